//! pymavlink at the other end of a UDP link on the loopback interface: it reads what we send, and we read what it sends.
//!
//! Needs Python with the packages of `oracle/requirements.txt`:
//! `PYMAVLINK_PYTHON=venv/bin/python cargo test -p mavlink-conformance --test peer -- --ignored`

use std::env;
use std::io::Write;
use std::net::UdpSocket;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use mavlink_autoquad::autoquad::{Autoquad, Heartbeat};
use mavlink_conformance::autoquad::SUBJECTS;
use mavlink_conformance::definition::Definition;
use mavlink_conformance::subject::Subject;
use mavlink_conformance::values::Values;
use mavlink_conformance::vectors::{self, Vectors};
use mavlink_wire::signing::{Key, Signer, Trust, Verifier};
use mavlink_wire::{Dialect, Frame, MAX_FRAME, Sender, Timestamp, Version};

/// The peer of `oracle/peer.py`.
struct Peer {
    process: Child,
    socket: UdpSocket,
}

impl Peer {
    /// Starts pymavlink.
    fn new() -> Self {
        let python = env::var("PYMAVLINK_PYTHON").unwrap_or_else(|_| "python3".to_owned());
        let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
        socket.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
        let port = socket.local_addr().unwrap().port().to_string();
        let arguments = ["oracle/peer.py", "../xml/autoquad.xml", &port];
        let process = Command::new(python).args(arguments).stdin(Stdio::piped()).spawn().unwrap();
        Self { process, socket }
    }

    /// Begins another link: `v1`, `v2` or `signed`.
    fn begin(&mut self, kind: &str) {
        if self.socket.peer_addr().is_ok() {
            self.socket.send(b"done").unwrap();
        }
        writeln!(self.process.stdin.as_mut().unwrap(), "{kind}").unwrap();
        let mut buffer = [0; MAX_FRAME];
        let (length, from) = self.socket.recv_from(&mut buffer).expect("pymavlink starts within 30 s");
        assert_eq!(&buffer[..length], b"ready");
        self.socket.connect(from).unwrap();
    }

    /// What pymavlink answers to a frame.
    fn answer(&self, frame: &[u8]) -> Vec<u8> {
        self.socket.send(frame).unwrap();
        let mut buffer = [0; 512];
        let length = self.socket.recv(&mut buffer).expect("pymavlink answers within 30 s");
        buffer[..length].to_vec()
    }
}

impl Drop for Peer {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// Sends every golden message through pymavlink and holds what comes back against it; gives their number.
fn exchange(peer: &Peer, mut sender: Sender, version: Version, mut check: impl FnMut(&Frame<'_>)) -> usize {
    let (mut buffer, mut sequence, mut count) = ([0; MAX_FRAME], 0_u8, 0);
    for Vectors { definition, cases } in vectors::read(vectors::AUTOQUAD) {
        if version == Version::V1 && definition.id > 255 {
            continue;
        }
        let subject: &Subject<Autoquad> = SUBJECTS.iter().find(|subject| subject.id == definition.id).unwrap();
        for case in cases {
            let message = (subject.build_in_dialect)(&case.values);
            let answer = peer.answer(sender.encode(&message, &mut buffer).unwrap());
            let place = format!("{}, case {}: {}", definition.name, case.name, String::from_utf8_lossy(&answer));
            let frame = Frame::parse(&answer, Autoquad::TABLE).unwrap_or_else(|error| panic!("{place}: {error}"));
            assert_eq!(frame.bytes().len(), answer.len(), "{place}");
            let header =
                (frame.version(), frame.sequence(), frame.system_id(), frame.component_id(), frame.message_id());
            assert_eq!(header, (version, sequence, 7.into(), 8.into(), definition.id), "{place}");
            check(&frame);
            let message = frame.message().and_then(subject.values_in_dialect).unwrap();
            assert_eq!(message, carried(&definition, &case.values, version), "{place}");
            (sequence, count) = (sequence.wrapping_add(1), count + 1);
        }
    }
    count
}

/// MAVLink 1 leaves extensions out.
fn carried(definition: &Definition, values: &Values, version: Version) -> Values {
    let fields = definition.fields.iter().zip(values);
    fields
        .map(|(field, values)| {
            let lost = field.extension && version == Version::V1;
            if lost { vec![0; values.len()] } else { values.clone() }
        })
        .collect()
}

#[test]
#[ignore = "needs Python with pymavlink"]
fn every_message_goes_there_and_back() {
    let mut peer = Peer::new();
    peer.begin("v1");
    let v1 = exchange(&peer, Sender::v1(1, 1), Version::V1, |frame| assert!(frame.signature().is_none()));
    peer.begin("v2");
    let v2 = exchange(&peer, Sender::v2(1, 1), Version::V2, |frame| assert!(frame.signature().is_none()));
    peer.begin("signed");
    let sender = Sender::v2(1, 1).signed(Signer::new(Key::new(vectors::key()), 3, Timestamp::new(1000)));
    let mut verifier = Verifier::new(Some(Key::new(vectors::key())));
    let signed = exchange(&peer, sender, Version::V2, |frame| {
        assert_eq!(verifier.check(frame, Timestamp::new(0)), Ok(Trust::Signed));
        assert_eq!(frame.signature().map(|signature| signature.link_id()), Some(5));
    });
    println!("{v1} frames of MAVLink 1, {v2} of MAVLink 2 and {signed} signed ones, there and back");
    assert!(v1 > 900 && v2 > 2000 && signed == v2, "{v1} {v2} {signed}");
}

#[test]
#[ignore = "needs Python with pymavlink"]
fn pymavlink_refuses_what_is_not_signed_with_its_key_or_was_there_before() {
    let mut peer = Peer::new();
    peer.begin("signed");
    let beat = Autoquad::from(Heartbeat::default());
    let frame = |sender: &mut Sender| sender.encode(&beat, &mut [0; MAX_FRAME]).unwrap().to_vec();
    let signer = |key, link| Sender::v2(1, 1).signed(Signer::new(Key::new(key), link, Timestamp::new(1000)));
    let (mut ours, mut other) = (signer(vectors::key(), 3), signer([7; 32], 4));
    let first = frame(&mut ours);
    let is_refused = |frame: &[u8]| peer.answer(frame).starts_with(b"refused: ");
    assert!(!is_refused(&first));
    assert!(is_refused(&first), "a replay");
    assert!(is_refused(&frame(&mut other)), "another key");
    assert!(is_refused(&frame(&mut Sender::v2(1, 1))), "no signature");
    assert!(!is_refused(&frame(&mut ours)), "what follows is not affected");
}
