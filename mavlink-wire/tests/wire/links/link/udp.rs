//! UDP: who listens, who sends, who sends to all.

use std::net::UdpSocket;
use std::time::{Duration, Instant};

use mavlink_wire::link::{Link, Peer};
use mavlink_wire::{Dialect, EncodeError, Frame, Sender, Version};

use super::super::key;
use super::*;

fn listener() -> (Link, String) {
    let link = Link::connect("udpin:127.0.0.1:0", station()).unwrap();
    let address = link.local_addr().unwrap().to_string();
    (link, address)
}

#[test]
fn both_sides_talk() {
    let (mut station, address) = listener();
    assert_eq!(station.send(&message(0)).unwrap(), 0, "nobody is there");
    let mut vehicle = Link::connect(&format!("udpout:{address}"), vehicle()).unwrap();
    for number in 0..3 {
        assert_eq!(vehicle.send(&message(number)).unwrap(), 1);
        assert_eq!(next(&mut station), sent(number..number + 1)[0]);
        assert_eq!(station.send(&message(number)).unwrap(), 1);
        assert_eq!(next(&mut vehicle), sent(number..number + 1)[0]);
    }
    let statistics = station.statistics();
    assert_eq!((statistics.received.frames, statistics.sent, statistics.unsent, statistics.connections), (3, 3, 0, 1));
    assert_eq!(station.losses().of(1, 1).unwrap().received, 3);
    assert_eq!((station.system_id().to_u32(), station.component_id().to_u32()), (255, 190));
    assert!(station.is_connected() && station.trouble().is_none());
}

#[test]
fn a_frame_goes_on_to_the_byte_and_a_key_does_not() {
    let (mut station, address) = listener();
    let vehicle = Link::connect(&format!("udpout:{address}"), vehicle()).unwrap();
    let bytes = stream(Sender::v1(9, 9), 7..8);
    let frame = Frame::parse(&bytes, Small::TABLE).unwrap();
    assert_eq!(vehicle.send_frame(&frame).unwrap(), 1);
    let (received, peer) = station.receive_from(soon()).unwrap().unwrap();
    assert_eq!(received.bytes(), bytes);
    station.send_frame_to(&frame, peer).unwrap();
    assert_eq!(station.peers(), [peer]);
    let key = key();
    let key = Frame::parse(&key, Small::TABLE).unwrap();
    for refused in [station.send_frame(&key).map(drop), station.send_frame_to(&key, peer)] {
        assert!(matches!(refused, Err(LinkError::Encode(EncodeError::CarriesKey))), "{refused:?}");
    }
    assert!(station.remove_peer(peer) && !station.remove_peer(peer) && station.peers().is_empty());
}

#[test]
fn each_peer_is_answered_in_its_version() {
    let (mut station, address) = listener();
    let mut peers = [Sender::v1(1, 1), Sender::v2(2, 1)].map(|sender| {
        let options = Options::new(Small::TABLE, sender);
        Link::connect(&format!("udpout:{address}"), options).unwrap()
    });
    for peer in &peers {
        peer.send(&message(1)).unwrap();
        next(&mut station);
    }
    assert_eq!(station.send(&message(2)).unwrap(), 2);
    let versions = peers.each_mut().map(|peer| peer.receive_until(soon()).unwrap().unwrap().version());
    assert_eq!(versions, [Version::V1, Version::V2]);
    // Who spoke first is answered in the version of the answer.
    peers[0].send(&message(3)).unwrap();
    assert_eq!(station.receive_until(soon()).unwrap().unwrap().version(), Version::V1);
}

#[test]
fn one_version_for_all_if_it_is_said() {
    let options = station().with_version(Version::V2);
    let mut station = Link::connect("udpin:127.0.0.1:0", options).unwrap();
    let address = station.local_addr().unwrap();
    let old = UdpSocket::bind("127.0.0.1:0").unwrap();
    old.send_to(&stream(Sender::v1(1, 1), 0..1), address).unwrap();
    next(&mut station);
    station.send(&message(0)).unwrap();
    let mut buffer = [0; 300];
    old.set_read_timeout(Some(LONG)).unwrap();
    old.recv(&mut buffer).unwrap();
    assert_eq!(buffer[0], 0xFD);
}

#[test]
fn what_a_sender_hears_from_others_gets_nothing() {
    let (mut station, address) = listener();
    let mut vehicle = Link::connect(&format!("udpout:{address}"), vehicle()).unwrap();
    vehicle.send(&message(0)).unwrap();
    let from = station.receive_from(soon()).unwrap().unwrap().1.address().unwrap();
    let stranger = UdpSocket::bind("127.0.0.1:0").unwrap();
    stranger.send_to(&stream(Sender::v2(7, 7), 0..1), from).unwrap();
    assert_eq!(next(&mut vehicle), sent(0..1)[0]);
    assert_eq!(vehicle.send(&message(1)).unwrap(), 1);
    assert_eq!(next(&mut station).0, 1);
    stranger.set_nonblocking(true).unwrap();
    assert!(stranger.recv(&mut [0; 300]).is_err());
    // But one can be answered who asks.
    vehicle.send_to(&message(2), Peer::from(stranger.local_addr().unwrap())).unwrap();
    stranger.set_nonblocking(false).unwrap();
    assert!(stranger.recv(&mut [0; 300]).is_ok());
}

#[test]
fn a_deadline_passes_whatever_comes() {
    let (mut station, address) = listener();
    let begun = Instant::now();
    assert!(station.receive_until(begun).unwrap().is_none());
    let done = std::sync::atomic::AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let flood = UdpSocket::bind("127.0.0.1:0").unwrap();
            while !done.load(std::sync::atomic::Ordering::Relaxed) {
                flood.send_to(&[0xFD; 1400], &address).unwrap();
            }
        });
        let frame = station.receive_until(Instant::now() + Duration::from_millis(100)).unwrap().map(drop);
        done.store(true, std::sync::atomic::Ordering::Relaxed);
        assert!(frame.is_none());
    });
    assert!(station.statistics().received.skipped_bytes > 0);
    // What comes behind the flood is found.
    let vehicle = Link::connect(&format!("udpout:{address}"), vehicle()).unwrap();
    vehicle.send(&message(0)).unwrap();
    assert_eq!(next(&mut station), sent(0..1)[0]);
}

#[test]
fn halves_go_to_threads_and_closing_ends_both() {
    let (station, address) = listener();
    let (mut receiving, sending) = station.split();
    let vehicle = Link::connect(&format!("udpout:{address}"), vehicle()).unwrap();
    vehicle.send(&message(0)).unwrap();
    let received = std::thread::spawn(move || {
        let mut count = 0;
        loop {
            match receiving.receive() {
                Ok(_) => count += 1,
                Err(error) => return (count, error),
            }
        }
    });
    while sending.send(&message(1)).unwrap() == 0 {
        std::thread::yield_now();
    }
    sending.clone().close();
    let (count, error) = received.join().unwrap();
    assert!(count == 1 && matches!(error, LinkError::Closed), "{count} {error:?}");
    assert!(matches!(sending.send(&message(1)), Err(LinkError::Closed)));
}

#[test]
fn a_broadcast_needs_no_peer() {
    let mut all = Link::connect("udpin:0.0.0.0:0", station()).unwrap();
    let port = all.local_addr().unwrap().port();
    // The network of the loopback interface.
    let vehicle = Link::connect(&format!("udpbcast:127.255.255.255:{port}"), vehicle()).unwrap();
    assert_eq!(vehicle.send(&message(0)).unwrap(), 1);
    assert_eq!(next(&mut all), sent(0..1)[0]);
}
