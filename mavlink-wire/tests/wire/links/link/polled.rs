//! Links of async tasks.

mod cancelled;
#[cfg(all(unix, feature = "tokio-serial"))]
mod serial;

use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::thread;
use std::time::{Duration, Instant};

use mavlink_wire::link::LinkError;
use mavlink_wire::link::tokio::Link;
use mavlink_wire::{EncodeError, Frame, Sender, tlog};

use super::super::{TooLarge, key};
use super::*;

/// Sends until somebody is there.
async fn send_surely(link: &Link, number: u32) {
    let end = soon();
    while link.send(&message(number)).await.unwrap() == 0 {
        assert!(Instant::now() < end, "nobody came: {:?}", link.trouble());
        tokio::time::sleep(Duration::from_millis(1)).await;
    }
}

/// Number and message of the next frame.
async fn next(link: &mut Link) -> (u8, Option<Small>) {
    read(&link.receive_until(soon()).await.unwrap().unwrap())
}

async fn pair(listener: &str, caller: &str) -> (Link, Link) {
    let station = Link::connect(&format!("{listener}:127.0.0.1:0"), station()).await.unwrap();
    let address = station.local_addr().unwrap();
    let vehicle = Link::connect(&format!("{caller}:{address}"), vehicle()).await.unwrap();
    (station, vehicle)
}

#[tokio::test]
async fn both_sides_talk() {
    for (listener, caller) in [("udpin", "udpout"), ("tcpin", "tcpout")] {
        let (mut station, mut vehicle) = pair(listener, caller).await;
        if listener == "udpin" {
            assert_eq!(station.send(&message(0)).await.unwrap(), 0, "nobody was heard");
        }
        for number in 0..20 {
            assert_eq!(vehicle.send(&message(number)).await.unwrap(), 1);
            assert_eq!(next(&mut station).await, sent(number..number + 1)[0]);
            assert_eq!(station.send(&message(number)).await.unwrap(), 1);
            assert_eq!(next(&mut vehicle).await, sent(number..number + 1)[0]);
        }
        let bytes = stream(Sender::v1(9, 9), 7..8);
        let frame = Frame::parse(&bytes, Small::TABLE).unwrap();
        assert_eq!(vehicle.send_frame(&frame).await.unwrap(), 1);
        let (received, peer) = station.receive_from(soon()).await.unwrap().unwrap();
        assert_eq!(received.bytes(), bytes);
        station.send_to(&message(20), peer).await.unwrap();
        station.send_frame_to(&frame, peer).await.unwrap();
        assert_eq!((next(&mut vehicle).await.0, next(&mut vehicle).await.0), (20, 0));
        let statistics = station.statistics();
        assert_eq!((statistics.received.frames, statistics.sent, statistics.connections), (21, 22, 1), "{listener}");
        assert_eq!((station.peers(), station.losses().total().lost), (vec![peer], 0));
        let key = key();
        let key = Frame::parse(&key, Small::TABLE).unwrap();
        assert!(matches!(station.send_frame(&key).await, Err(LinkError::Encode(EncodeError::CarriesKey))));
        assert!(station.receive_until(Instant::now()).await.unwrap().is_none());
    }
}

#[tokio::test]
async fn what_is_queued_goes_out_with_the_flush_in_order() {
    let (mut station, vehicle) = pair("tcpin", "tcpout").await;
    vehicle.flush().await.unwrap();
    for number in 0..10 {
        assert_eq!(vehicle.queue(&message(number)).await.unwrap(), 1);
    }
    let a_while = Instant::now() + Duration::from_millis(50);
    assert!(station.receive_until(a_while).await.unwrap().is_none(), "nothing goes out before");
    // What is too much is not kept, and a message that is sent takes along what is queued.
    for number in 10..199 {
        vehicle.queue(&message(number)).await.unwrap();
    }
    vehicle.send(&message(199)).await.unwrap();
    for expected in sent(0..200) {
        assert_eq!(next(&mut station).await, expected);
    }
    vehicle.queue(&message(200)).await.unwrap();
    vehicle.flush().await.unwrap();
    assert_eq!(next(&mut station).await, sent(200..201)[0]);
    assert_eq!(vehicle.statistics().sent, 201);
    // A datagram goes out at once.
    let (mut station, vehicle) = pair("udpin", "udpout").await;
    assert_eq!(vehicle.queue(&message(0)).await.unwrap(), 1);
    assert_eq!(next(&mut station).await, sent(0..1)[0]);
}

#[tokio::test]
async fn a_listener_takes_the_next_client_and_a_client_the_next_listener() {
    let mut station = Link::connect("tcpin:127.0.0.1:0", station()).await.unwrap();
    let address = station.local_addr().unwrap();
    for round in 0..2 {
        let mut client = TcpStream::connect(address).unwrap();
        let bytes = stream(Sender::v2(1, 1), 0..3);
        client.write_all(&bytes[..bytes.len() - 5]).unwrap();
        drop(client);
        assert_eq!([next(&mut station).await, next(&mut station).await], *sent(0..2), "{round}");
    }
    let mut vehicle = Link::connect(&format!("tcpout:{address}"), vehicle()).await.unwrap();
    vehicle.send(&message(0)).await.unwrap();
    assert_eq!(next(&mut station).await, sent(0..1)[0]);
    drop(station);
    let pause = Instant::now() + Duration::from_millis(200);
    assert!(vehicle.receive_until(pause).await.unwrap().is_none());
    assert!(!vehicle.is_connected() && vehicle.trouble().is_some());
    assert_eq!(vehicle.send(&message(1)).await.unwrap(), 0);
    let mut station = Link::connect(&format!("tcpin:{address}"), super::station()).await.unwrap();
    // Both look for each other, as two tasks would.
    let heard = async {
        send_surely(&vehicle, 1).await;
    };
    let (heard, ()) = tokio::join!(next(&mut station), heard);
    assert_eq!(heard.1, sent(1..2)[0].1);
    assert_eq!(vehicle.statistics().connections, 2);
}

#[tokio::test]
async fn who_only_sends_connects_again_as_well() {
    let server = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = server.local_addr().unwrap();
    let vehicle = Link::connect(&format!("tcpout:{address}"), vehicle()).await.unwrap();
    drop(server.accept().unwrap());
    let again = thread::spawn(move || server.accept().unwrap().0.read_exact(&mut [0; 12]).unwrap());
    while !again.is_finished() {
        vehicle.send(&message(1)).await.unwrap();
        tokio::time::sleep(Duration::from_millis(5)).await;
    }
    again.join().unwrap();
}

#[tokio::test]
async fn without_reconnecting_a_loss_is_the_end() {
    let mut station = Link::connect("tcpin:127.0.0.1:0", station().without_reconnecting()).await.unwrap();
    let mut client = TcpStream::connect(station.local_addr().unwrap()).unwrap();
    client.write_all(&stream(Sender::v2(1, 1), 0..1)).unwrap();
    drop(client);
    assert_eq!(next(&mut station).await, sent(0..1)[0]);
    assert!(matches!(station.receive().await, Err(LinkError::Closed)));
    assert!(matches!(station.send(&message(0)).await, Err(LinkError::Closed)));
}

#[tokio::test]
async fn closing_wakes_who_waits() {
    for listener in ["udpin", "tcpin"] {
        let link = Link::connect(&format!("{listener}:127.0.0.1:0"), station()).await.unwrap();
        let (mut receiving, sending) = link.split();
        let waiting = tokio::spawn(async move { receiving.receive().await.map(drop) });
        tokio::task::yield_now().await;
        sending.close();
        assert!(matches!(waiting.await.unwrap(), Err(LinkError::Closed)), "{listener}");
        assert!(matches!(sending.send(&message(0)).await, Err(LinkError::Closed)));
    }
}

#[tokio::test]
async fn files_give_their_frames_and_end() {
    let bytes = stream(Sender::v2(1, 1), 0..500);
    let (mut log, mut buffer, mut input) = (vec![], [0; tlog::MAX_ENTRY], &bytes[..]);
    while let Ok(frame) = Frame::parse(input, Small::TABLE) {
        log.extend_from_slice(tlog::encode(1_700_000_000_000_000, &frame, &mut buffer).unwrap());
        input = &input[frame.bytes().len()..];
    }
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in [("kept", &bytes), ("a.tlog", &log)] {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        let mut link = Link::connect(&format!("file:{}", path.display()), station()).await.unwrap();
        for expected in sent(0..500) {
            assert_eq!(next(&mut link).await, expected, "{name}");
        }
        assert!(matches!(link.receive().await, Err(LinkError::Ended)), "{name}");
        assert_eq!((link.statistics().received.frames, link.statistics().received.skipped_bytes), (500, 0), "{name}");
        assert_eq!(link.send(&message(0)).await.unwrap(), 0);
    }
}

#[tokio::test]
async fn errors_have_their_kinds() {
    let taken = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let taken = taken.local_addr().unwrap();
    let free = std::net::TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap();
    let error = async |address: String| Link::connect(&address, station()).await.unwrap_err();
    assert!(matches!(error("tcp:0.0.0.0:1".into()).await, LinkError::Address(_)));
    assert!(matches!(error(format!("tcpin:{taken}")).await, LinkError::Unreachable { .. } | LinkError::InUse { .. }));
    assert!(matches!(error(format!("tcpout:{free}")).await, LinkError::Unreachable { .. }));
    assert!(matches!(error("udpout:no.such.host.invalid:1".into()).await, LinkError::Unreachable { .. }));
    assert!(matches!(error("file:/no/such/file".into()).await, LinkError::NoFile { .. }));
    let (_station, vehicle) = pair("udpin", "udpout").await;
    vehicle.with_sender(|sender| sender.set_version(mavlink_wire::Version::V1));
    assert!(matches!(vehicle.send(&TooLarge).await, Err(LinkError::Encode(_))));
    assert_eq!(vehicle.with_sender(|sender| sender.sequence()), 0);
}
