//! pymavlink, as other programs use it: `mavutil`.
//!
//! `PYMAVLINK_PYTHON=venv/bin/python cargo test --locked --test links -- --ignored`

use std::env;
use std::process::{Child, Command};

use mavlink_autoquad::autoquad::{Autoquad, Heartbeat};
use mavlink_autoquad::wire::link::Link;
use mavlink_autoquad::wire::{Dialect, Frame, MAX_FRAME, Message, Sender, tlog};

use super::{KEY, Kind, Way, over};

/// A process, which is killed with it.
struct Peer(Child);

fn python(arguments: &[&str]) -> Command {
    let mut command = Command::new(env::var("PYMAVLINK_PYTHON").unwrap_or_else(|_| "python3".to_owned()));
    command.arg("tests/links/peer.py").args(arguments);
    command
}

impl Peer {
    fn start(address: &str, kind: Kind) -> Self {
        let kind = match kind {
            Kind::V1 => "v1",
            Kind::V2 => "v2",
            Kind::Signed => std::str::from_utf8(&KEY).unwrap(),
        };
        Self(python(&["talk", address, kind]).spawn().unwrap())
    }
}

impl Drop for Peer {
    fn drop(&mut self) {
        self.0.kill().unwrap();
        self.0.wait().unwrap();
    }
}

#[test]
#[ignore = "needs Python with pymavlink"]
fn every_way_goes_in_every_version_and_goes_on_when_the_peer_comes_back() {
    for kind in Kind::ALL {
        for way in Way::all("tcp") {
            over(&way, kind, Peer::start);
        }
    }
}

#[test]
#[ignore = "needs Python with pymavlink"]
fn each_reads_the_log_that_the_other_has_written() {
    let folder = tempfile::tempdir().unwrap();
    let (theirs, ours) = (folder.path().join("theirs.tlog"), folder.path().join("ours.tlog"));
    let written = python(&["write", theirs.to_str().unwrap(), "v2"]).status().unwrap();
    assert!(written.success());
    let mut link = Link::connect(&format!("file:{}", theirs.display()), Kind::V2.options()).unwrap();
    let read = std::iter::from_fn(|| link.receive().ok().and_then(|frame| frame.decode::<Heartbeat>()));
    assert_eq!(read.map(|beat| beat.custom_mode).collect::<Vec<_>>(), (0..50).collect::<Vec<_>>());
    assert_eq!(link.statistics().received.skipped_bytes, 0);

    let (mut sender, mut log) = (Sender::v2(1, 1), tlog::Writer::new(std::fs::File::create(&ours).unwrap()));
    for custom_mode in 0..50 {
        let mut buffer = [0; MAX_FRAME];
        let bytes = sender.encode(&Heartbeat { custom_mode, ..Heartbeat::DEFAULT }, &mut buffer).unwrap();
        log.write(1_700_000_000_000_000, &Frame::parse(bytes, Autoquad::TABLE).unwrap()).unwrap();
    }
    log.flush().unwrap();
    let read = python(&["read", ours.to_str().unwrap(), "v2"]).output().unwrap();
    let numbers: Vec<String> = (0..50).map(|number: u32| number.to_string()).collect();
    assert_eq!(String::from_utf8(read.stdout).unwrap().split_whitespace().collect::<Vec<_>>(), numbers);
}
