//! rust-mavlink, with messages of its own.

use std::io::Write;
use std::net::UdpSocket;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use mavlink::dialects::common::{HEARTBEAT_DATA, MavMessage};
use mavlink_autoquad::wire::link::Link;
use mavlink_core::{MavConnection, MavHeader, MavlinkVersion, SigningConfig};

use super::{KEY, Kind, Way, over, talk};

/// A peer in a thread, which ends with it.
struct Peer {
    done: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Peer {
    fn start(address: &str, kind: Kind) -> Self {
        let done = Arc::new(AtomicBool::new(false));
        // As it writes serial ports.
        let address = if address.starts_with('/') { format!("serial:{address}:57600") } else { address.into() };
        let thread = thread::spawn({
            let done = done.clone();
            move || run(&address, kind, &done)
        });
        Self { done, thread: Some(thread) }
    }
}

fn run(address: &str, kind: Kind, done: &AtomicBool) {
    let connection = loop {
        match mavlink_core::connect::<MavMessage>(address) {
            Ok(connection) => break connection,
            // Nobody listens yet, or the port is not free again yet.
            Err(_) if !done.load(Ordering::Relaxed) => thread::sleep(Duration::from_millis(20)),
            Err(_) => return,
        }
    };
    let mut connection = connection;
    connection.set_allow_recv_any_version(false);
    connection.set_protocol_version(if kind == Kind::V1 { MavlinkVersion::V1 } else { MavlinkVersion::V2 });
    if kind == Kind::Signed {
        connection.setup_signing(Some(SigningConfig::new(KEY, 2, true, false)));
    }
    let say = |custom_mode| {
        let beat = MavMessage::HEARTBEAT(HEARTBEAT_DATA { custom_mode, ..HEARTBEAT_DATA::default() });
        // One that nobody takes is asked for again.
        connection.send(&MavHeader { system_id: 7, component_id: 8, sequence: 0 }, &beat).ok();
    };
    let mut next = Instant::now();
    while !done.load(Ordering::Relaxed) {
        match connection.try_recv() {
            Ok((_, MavMessage::HEARTBEAT(beat))) => say(beat.custom_mode + 1000),
            Ok(_) => {}
            Err(_) => thread::sleep(Duration::from_millis(1)),
        }
        if Instant::now() >= next {
            say(0);
            next += Duration::from_millis(100);
        }
    }
}

impl Drop for Peer {
    fn drop(&mut self) {
        self.done.store(true, Ordering::Relaxed);
        self.thread.take().map(JoinHandle::join).transpose().unwrap();
    }
}

#[test]
fn every_way_goes_in_every_version_and_goes_on_when_the_peer_comes_back() {
    for kind in Kind::ALL {
        for way in Way::all("tcpout") {
            over(&way, kind, Peer::start);
        }
    }
}

#[test]
fn garbage_between_does_no_harm() {
    for way in Way::all("tcpout").into_iter().take(1) {
        let mut link = Link::connect(&way.ours, Kind::V2.options()).unwrap();
        let _peer = Peer::start(&way.theirs, Kind::V2);
        let (to, done) = (way.ours.replace("udpin:", ""), AtomicBool::new(false));
        thread::scope(|scope| {
            scope.spawn(|| {
                let flood = UdpSocket::bind("127.0.0.1:0").unwrap();
                let mut garbage: Vec<u8> =
                    (0..1400_u32).map(|at| (at.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
                garbage.iter_mut().step_by(50).for_each(|byte| *byte = 0xFD);
                while !done.load(Ordering::Relaxed) {
                    flood.send_to(&garbage, &to).unwrap();
                    garbage.rotate_left(1);
                    thread::sleep(Duration::from_micros(200));
                }
            });
            talk::with(&mut link, Kind::V2, "garbage");
            done.store(true, Ordering::Relaxed);
        });
        assert!(link.statistics().received.skipped_bytes > 0);
    }
}

#[test]
fn what_it_writes_we_read_as_a_file() {
    let mut file = tempfile::NamedTempFile::new().unwrap();
    for version in [MavlinkVersion::V1, MavlinkVersion::V2] {
        for custom_mode in 0..3 {
            let beat = MavMessage::HEARTBEAT(HEARTBEAT_DATA { custom_mode, ..HEARTBEAT_DATA::default() });
            let header = MavHeader { system_id: 7, component_id: 8, sequence: custom_mode as u8 };
            mavlink_core::write_versioned_msg(&mut file, version, header, &beat).unwrap();
        }
    }
    file.flush().unwrap();
    let mut link = Link::connect(&format!("file:{}", file.path().display()), Kind::V2.options()).unwrap();
    let read = std::iter::from_fn(|| link.receive().ok().map(|frame| (frame.version(), frame.sequence())));
    let expected = [Kind::V1, Kind::V2].map(|kind| (0..3).map(move |number| (kind.version(), number)));
    assert_eq!(read.collect::<Vec<_>>(), expected.into_iter().flatten().collect::<Vec<_>>());
}
