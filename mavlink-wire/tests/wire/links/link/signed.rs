//! Links with keys.

use std::net::UdpSocket;

use mavlink_wire::link::Peer;
use mavlink_wire::signing::{Key, Setup, Signer, Verifier};
use mavlink_wire::{EncodeError, Timestamp, Version};

use super::*;

const KEY: [u8; 32] = [7; 32];

fn signer() -> Signer {
    Signer::new(Key::new(KEY), 0, Timestamp::ZERO)
}

fn trusting(options: Options) -> Options {
    options.with_verifier(Verifier::new(Some(Key::new(KEY))))
}

#[test]
fn who_signs_is_heard_and_who_does_not_is_refused() {
    for (listener, caller) in [("udpin", "udpout"), ("tcpin", "tcpout")] {
        let options = Options::new(Small::TABLE, Sender::v2(255, 190).signed(signer()));
        let mut station = Link::connect(&format!("{listener}:127.0.0.1:0"), trusting(options)).unwrap();
        let address = format!("{caller}:{}", station.local_addr().unwrap());
        let signing = Options::new(Small::TABLE, Sender::v2(1, 1).signed(signer()));
        let mut vehicle = Link::connect(&address, trusting(signing)).unwrap();
        for number in 0..3 {
            vehicle.send(&message(number)).unwrap();
            assert_eq!(next(&mut station).0, number as u8);
            station.send(&message(number)).unwrap();
            let frame = vehicle.receive_until(soon()).unwrap().unwrap();
            assert!(frame.signature().is_some() && frame.version() == Version::V2);
        }
        assert_eq!(station.verifier().unwrap().streams().len(), 1);
        drop(vehicle);
        let stranger = Link::connect(&address, super::vehicle()).unwrap();
        stranger.send(&message(9)).unwrap();
        let end = soon();
        while station.statistics().refused == 0 {
            let pause = std::time::Instant::now() + Duration::from_millis(10);
            assert!(station.receive_until(pause).unwrap().is_none() && pause < end);
        }
    }
}

#[test]
fn what_is_not_signed_passes_by_a_rule() {
    let options = trusting(station()).with_unsigned(|frame| frame.signature().is_none());
    let mut station = Link::connect("udpin:127.0.0.1:0", options).unwrap();
    let address = station.local_addr().unwrap();
    let stranger = UdpSocket::bind("127.0.0.1:0").unwrap();
    let forged = Sender::v2(1, 1).signed(Signer::new(Key::new([8; 32]), 0, Timestamp::ZERO));
    stranger.send_to(&[stream(forged, 0..1), stream(Sender::v2(1, 1), 1..2)].concat(), address).unwrap();
    assert_eq!(next(&mut station).1, sent(1..2)[0].1);
    assert_eq!((station.statistics().refused, station.peers().len()), (1, 0), "it makes no peer");
    station.set_verifier(None);
    stranger.send_to(&stream(Sender::v2(1, 1), 2..3), address).unwrap();
    assert_eq!(next(&mut station).1, sent(2..3)[0].1);
    assert_eq!(station.peers().len(), 1);
}

#[test]
fn a_key_goes_to_nobody_who_was_not_named() {
    let setup = Setup::new(1, 1, Key::new(KEY), Timestamp::new(1)).unwrap();
    for listener in ["udpin", "tcpin"] {
        let link = Link::connect(&format!("{listener}:127.0.0.1:0"), station()).unwrap();
        assert!(matches!(link.send(&setup), Err(LinkError::Encode(EncodeError::CarriesKey))));
    }
    let vehicle = UdpSocket::bind("127.0.0.1:0").unwrap();
    let address = vehicle.local_addr().unwrap();
    let link = Link::connect("udpin:127.0.0.1:0", station()).unwrap();
    link.send_to(&setup, Peer::from(address)).unwrap();
    let link = Link::connect(&format!("udpout:{address}"), station()).unwrap();
    assert_eq!(link.send(&setup).unwrap(), 1, "the address is a name");
}

#[test]
fn a_new_key_is_used_from_then_on() {
    let mut station = Link::connect("udpin:127.0.0.1:0", trusting(station())).unwrap();
    let address = format!("udpout:{}", station.local_addr().unwrap());
    let vehicle = Link::connect(&address, vehicle()).unwrap();
    vehicle.with_sender(|sender| sender.set_signer(Some(signer())));
    vehicle.send(&message(0)).unwrap();
    assert_eq!(next(&mut station), sent(0..1)[0]);
    let saved = vehicle.with_sender(|sender| sender.signer().map(Signer::timestamp));
    assert!(saved.is_some_and(|saved| saved > Timestamp::ZERO), "it goes with the clock");
}
