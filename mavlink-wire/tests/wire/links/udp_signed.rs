//! UDP with keys.

use std::net::{SocketAddr, UdpSocket};
use std::time::Duration;

use mavlink_wire::signing::{Key, Setup, Signer, SigningError, Verifier};
use mavlink_wire::udp::Endpoint;
use mavlink_wire::{Dialect, EncodeError, Frame, MessageInfo, Sender, Table, Timestamp};

use super::{message, read, sent, stream};
use crate::small::Small;

const KEY: [u8; 32] = [7; 32];

fn socket() -> UdpSocket {
    let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
    socket.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
    socket
}

fn now() -> Timestamp {
    let since_1970 = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap();
    Timestamp::from_unix_micros(since_1970.as_micros() as u64)
}

/// A station that trusts the key and signs with it.
fn station() -> (Endpoint<'static>, SocketAddr) {
    let sender = Sender::v2(255, 190).signed(Signer::new(Key::new(KEY), 0, Timestamp::ZERO));
    let endpoint = Endpoint::new(socket(), Small::TABLE, sender).with_verifier(Verifier::new(Some(Key::new(KEY))));
    let address = endpoint.socket().local_addr().unwrap();
    (endpoint, address)
}

fn signed(key: [u8; 32], time: Timestamp) -> Sender {
    Sender::v2(1, 1).signed(Signer::new(Key::new(key), 3, time))
}

#[test]
fn with_a_verifier_only_a_signed_frame_makes_a_peer() {
    let (mut station, address) = station();
    let (stranger, forger, vehicle) = (socket(), socket(), socket());
    stranger.send_to(&stream(Sender::v2(1, 1), 0..2), address).unwrap();
    forger.send_to(&stream(signed([8; 32], now()), 0..1), address).unwrap();
    let genuine = stream(signed(KEY, now()), 0..1);
    // The second is a replay, from whatever address.
    for from in [&vehicle, &stranger] {
        from.send_to(&genuine, address).unwrap();
    }
    vehicle.send_to(&stream(signed(KEY, now()), 1..2), address).unwrap();
    let received: Vec<_> =
        (0..2).map(|_| station.receive().map(|(frame, from)| (read(&frame).1, from)).unwrap()).collect();
    let peer = vehicle.local_addr().unwrap();
    assert_eq!(received, [(sent(0..1)[0].1, peer), (sent(1..2)[0].1, peer)]);
    assert_eq!((station.peers().collect::<Vec<_>>(), station.refused_frames()), (vec![peer], 4));
    assert_eq!(station.verifier().unwrap().streams().len(), 1);
}

#[test]
fn what_is_allowed_without_a_signature_makes_no_peer() {
    static RADIO_STATUS: MessageInfo = MessageInfo::new(109, "RADIO_STATUS", 185, 9);
    static TABLE: Table<'static> = Table::of(&[&RADIO_STATUS]);
    let mut station =
        Endpoint::new(socket(), &TABLE, Sender::v2(255, 190)).with_verifier(Verifier::new(Some(Key::new(KEY))));
    let bytes = crate::streams::pieces::with_checksum(vec![0xFE, 9, 0, 51, 68, 109, 1, 2, 3, 4, 5, 6, 7, 8, 9], 185);
    let radio = socket();
    radio.send_to(&bytes, station.socket().local_addr().unwrap()).unwrap();
    let (frame, from) = station.receive().unwrap();
    assert!(frame.message_id() == 109 && frame.is_verified() && from == radio.local_addr().unwrap());
    assert_eq!((station.peers().len(), station.refused_frames()), (0, 0));
}

#[test]
fn what_goes_out_is_signed_with_the_time() {
    let (mut station, _) = station();
    let vehicle = socket();
    let before = now();
    station.send_to(&message(1), vehicle.local_addr().unwrap()).unwrap();
    let mut buffer = [0; 300];
    let length = vehicle.recv(&mut buffer).unwrap();
    let frame = Frame::parse(&buffer[..length], Small::TABLE).unwrap();
    let signature = frame.signature().unwrap();
    assert!((before..=now()).contains(&signature.timestamp()));
    assert!(Verifier::new(Some(Key::new(KEY))).check(&frame, now()).is_ok());
}

#[test]
fn a_key_goes_to_nobody_who_was_not_named() {
    let mut station = Endpoint::new(socket(), Small::TABLE, Sender::v2(255, 190));
    let address = station.socket().local_addr().unwrap();
    let vehicle = socket();
    vehicle.send_to(&stream(Sender::v2(1, 1), 0..1), address).unwrap();
    station.receive().unwrap();
    let setup = Setup::new(1, 1, Key::new(KEY), now()).unwrap();
    let error = station.send_to_all(&setup).unwrap_err();
    assert_eq!(error.into_inner().unwrap().downcast::<EncodeError>().unwrap(), Box::new(EncodeError::CarriesKey));
    station.send_to(&message(1), vehicle.local_addr().unwrap()).unwrap();
    station.send_to(&setup, vehicle.local_addr().unwrap()).unwrap();
    let mut keys = (0..2).map(|_| {
        let mut buffer = [0; 300];
        let length = vehicle.recv(&mut buffer).unwrap();
        Setup::decode(&Frame::parse(&buffer[..length], Small::TABLE).unwrap())
    });
    assert_eq!(keys.next(), Some(None), "the first to come is the message behind the refused key");
    let received = keys.next().flatten().unwrap();
    assert!(received.target_system() == 1 && received.key().is_some_and(|(key, _)| *key == Key::new(KEY)));
}

#[test]
fn a_key_that_came_for_everybody_is_read_and_not_made_again() {
    let mut payload = [0; 42];
    payload[10..].copy_from_slice(&KEY);
    let bytes = [&[0xFD, 42, 0, 0, 0, 255, 190, 0, 1, 0][..], &payload].concat();
    let bytes = crate::streams::pieces::with_checksum(bytes, 71);
    let received = Setup::decode(&Frame::parse(&bytes, Small::TABLE).unwrap()).unwrap();
    assert!(received.target_system().is_broadcast() && received.target_component().is_broadcast());
    let (key, timestamp) = received.key().unwrap();
    let again = Setup::new(received.target_system(), received.target_component(), key.clone(), timestamp);
    assert!(matches!(again, Err(SigningError::Broadcast { .. })));
}
