//! TCP, whose ends die and come back.

use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::thread;
use std::time::Duration;

use super::*;

fn listener(options: Options) -> (Link, String) {
    let link = Link::connect("tcpin:127.0.0.1:0", options).unwrap();
    let address = link.local_addr().unwrap().to_string();
    (link, address)
}

#[test]
fn both_sides_talk() {
    let (mut station, address) = listener(station());
    assert!(station.send(&message(0)).unwrap() == 0 && !station.is_connected(), "nobody is there");
    let mut vehicle = Link::connect(&format!("tcpout:{address}"), vehicle()).unwrap();
    for number in 0..50 {
        assert_eq!(vehicle.send(&message(number)).unwrap(), 1);
        assert_eq!(next(&mut station), sent(number..number + 1)[0]);
        assert_eq!(station.send(&message(number)).unwrap(), 1);
        assert_eq!(next(&mut vehicle), sent(number..number + 1)[0]);
    }
    let (frame, peer) = {
        vehicle.send(&message(50)).unwrap();
        let (frame, peer) = station.receive_from(soon()).unwrap().unwrap();
        (frame.sequence(), peer)
    };
    assert_eq!((frame, station.peers()), (50, vec![peer]));
    station.send_to(&message(50), peer).unwrap();
    let nobody = "127.0.0.1:9".parse::<std::net::SocketAddr>().unwrap();
    assert!(matches!(station.send_to(&message(51), nobody.into()), Err(LinkError::Unreachable { .. })));
}

#[test]
fn a_listener_takes_the_next_client_when_one_has_died() {
    let (mut station, address) = listener(station());
    for round in 0..3 {
        let mut client = TcpStream::connect(&address).unwrap();
        // The last frame is cut off, and its rest never comes.
        let bytes = stream(Sender::v2(1, 1), 0..3);
        client.write_all(&bytes[..bytes.len() - 5]).unwrap();
        let received: Vec<_> = (0..2).map(|_| next(&mut station)).collect();
        assert_eq!(received, sent(0..2), "{round}");
    }
    assert_eq!(station.statistics().connections, 3);
}

#[test]
fn a_client_connects_again_when_the_server_comes_back() {
    let server = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = server.local_addr().unwrap();
    let mut vehicle = Link::connect(&format!("tcpout:{address}"), vehicle()).unwrap();
    let (mut first, _) = server.accept().unwrap();
    first.write_all(&stream(Sender::v2(255, 190), 0..1)).unwrap();
    assert_eq!(next(&mut vehicle), sent(0..1)[0]);
    drop((server, first));
    assert!(vehicle.receive_until(std::time::Instant::now() + Duration::from_millis(300)).unwrap().is_none());
    assert!(!vehicle.is_connected() && vehicle.trouble().is_some(), "{:?}", vehicle.trouble());
    assert_eq!(vehicle.send(&message(0)).unwrap(), 0);
    let server = TcpListener::bind(address).unwrap();
    let back = thread::spawn(move || {
        let (mut stream_again, _) = server.accept().unwrap();
        stream_again.write_all(&stream(Sender::v2(255, 190), 1..2)).unwrap();
        stream_again.read_exact(&mut [0; 12]).unwrap();
    });
    assert_eq!(next(&mut vehicle).1, sent(1..2)[0].1);
    send_surely(&vehicle, 1);
    back.join().unwrap();
    assert!(vehicle.is_connected() && vehicle.trouble().is_none() && vehicle.statistics().connections == 2);
}

#[test]
fn who_only_sends_connects_again_as_well() {
    let server = TcpListener::bind("127.0.0.1:0").unwrap();
    let vehicle = Link::connect(&format!("tcpout:{}", server.local_addr().unwrap()), vehicle()).unwrap();
    drop(server.accept().unwrap());
    let again = thread::spawn(move || server.accept().unwrap().0.read_exact(&mut [0; 12]).unwrap());
    while !again.is_finished() {
        vehicle.send(&message(1)).unwrap();
        thread::sleep(Duration::from_millis(5));
    }
    again.join().unwrap();
}

#[test]
fn without_reconnecting_a_loss_is_the_end() {
    let (mut station, address) = listener(station().without_reconnecting());
    let mut client = TcpStream::connect(&address).unwrap();
    client.write_all(&stream(Sender::v2(1, 1), 0..2)).unwrap();
    drop(client);
    assert_eq!((next(&mut station), next(&mut station)), (sent(0..1)[0], sent(1..2)[0]), "what came is handed over");
    assert!(matches!(station.receive(), Err(LinkError::Closed)));
    assert!(matches!(station.send(&message(0)), Err(LinkError::Closed)));
}

#[test]
fn a_full_buffer_is_told_and_tears_no_frame() {
    let (mut station, address) = listener(station().with_send_timeout(Duration::from_millis(1)));
    let mut client = TcpStream::connect(&address).unwrap();
    client.write_all(&stream(Sender::v2(1, 1), 0..1)).unwrap();
    next(&mut station);
    let mut count: u32 = 0;
    let error = loop {
        match station.send(&message(count)) {
            Ok(taken) => count += taken as u32,
            Err(error) => break error,
        }
    };
    assert!(matches!(error, LinkError::Full), "{error:?}");
    assert_eq!(station.statistics().unsent, 1);
    // The other side begins to read: everything arrives, also the frame that was taken in part.
    let reader = thread::spawn(move || {
        let mut bytes = vec![];
        client.read_to_end(&mut bytes).unwrap();
        bytes
    });
    while matches!(station.send(&message(count)), Err(LinkError::Full)) {}
    drop(station);
    let (bytes, expected) = (reader.join().unwrap(), stream(Sender::v2(255, 190), 0..count + 1));
    assert!(bytes == expected, "{} bytes of {}", bytes.len(), expected.len());
}

#[test]
fn what_is_queued_goes_out_with_the_flush_in_order() {
    let (mut station, address) = listener(station());
    let vehicle = Link::connect(&format!("tcpout:{address}"), vehicle()).unwrap();
    vehicle.flush().unwrap();
    for number in 0..10 {
        assert_eq!(vehicle.queue(&message(number)).unwrap(), 1);
    }
    let a_while = std::time::Instant::now() + Duration::from_millis(50);
    assert!(station.receive_until(a_while).unwrap().is_none(), "nothing goes out before");
    assert_eq!(vehicle.statistics().sent, 0);
    vehicle.flush().unwrap();
    assert_eq!(vehicle.statistics().sent, 10);
    // A message that is sent takes along what is queued, and what is too much is not kept.
    for number in 10..13 {
        vehicle.queue(&message(number)).unwrap();
    }
    vehicle.send(&message(13)).unwrap();
    for number in 14..200 {
        vehicle.queue(&message(number)).unwrap();
    }
    assert!(vehicle.statistics().sent >= 100, "{:?}", vehicle.statistics());
    vehicle.flush().unwrap();
    let received: Vec<_> = (0..200).map(|_| next(&mut station)).collect();
    assert_eq!(received, sent(0..200));
    assert_eq!(vehicle.statistics().sent, 200);
}

#[test]
fn what_is_queued_for_a_connection_is_lost_with_it() {
    let server = TcpListener::bind("127.0.0.1:0").unwrap();
    let mut vehicle = Link::connect(&format!("tcpout:{}", server.local_addr().unwrap()), vehicle()).unwrap();
    let (first, _) = server.accept().unwrap();
    vehicle.queue(&message(0)).unwrap();
    drop(first);
    let accepted = thread::spawn(move || server.accept().unwrap().0);
    while vehicle.statistics().connections < 2 {
        assert!(vehicle.receive_until(std::time::Instant::now() + Duration::from_millis(20)).unwrap().is_none());
    }
    let mut second = accepted.join().unwrap();
    send_surely(&vehicle, 1);
    assert_eq!((vehicle.statistics().sent, vehicle.statistics().unsent), (1, 1));
    drop(vehicle);
    let mut bytes = vec![];
    second.read_to_end(&mut bytes).unwrap();
    let frame = mavlink_wire::Frame::parse(&bytes, Small::TABLE).unwrap();
    assert_eq!((frame.message(), frame.bytes().len()), (sent(1..2)[0].1, bytes.len()));
}

#[test]
fn a_queue_that_nobody_takes_is_full() {
    let (mut station, address) = listener(station().with_send_timeout(Duration::from_millis(1)));
    let mut client = TcpStream::connect(&address).unwrap();
    client.write_all(&stream(Sender::v2(1, 1), 0..1)).unwrap();
    next(&mut station);
    let mut count: u32 = 0;
    // The system may find more room after a while.
    let full = loop {
        match station.queue(&message(count)) {
            Ok(_) => count += 1,
            Err(queue) => {
                if let Err(flush) = station.flush() {
                    break [queue, flush];
                }
            }
        }
    };
    assert!(matches!(full, [LinkError::Full, LinkError::Full]));
    let reader = thread::spawn(move || {
        let mut bytes = vec![];
        client.read_to_end(&mut bytes).unwrap();
        bytes
    });
    while matches!(station.flush(), Err(LinkError::Full)) {}
    assert_eq!(station.statistics().sent, u64::from(count));
    drop(station);
    let (bytes, expected) = (reader.join().unwrap(), stream(Sender::v2(255, 190), 0..count));
    assert!(bytes == expected, "{} bytes of {}", bytes.len(), expected.len());
}

#[test]
fn garbage_costs_nothing_but_itself() {
    let (mut station, address) = listener(station());
    let mut client = TcpStream::connect(&address).unwrap();
    let flood = thread::spawn(move || {
        for _ in 0..50 {
            client.write_all(&[0xFE; 10_000]).unwrap();
        }
        client.write_all(&stream(Sender::v2(1, 1), 0..2)).unwrap();
    });
    assert_eq!((next(&mut station), next(&mut station)), (sent(0..1)[0], sent(1..2)[0]));
    flood.join().unwrap();
    assert!(station.statistics().received.skipped_bytes >= 500_000);
}

#[test]
fn closing_wakes_who_waits() {
    let (station, _) = listener(station());
    let (mut receiving, sending) = station.split();
    let waiting = thread::spawn(move || receiving.receive().map(drop));
    sending.close();
    assert!(matches!(waiting.join().unwrap(), Err(LinkError::Closed)));
}

#[test]
fn a_silent_client_gives_its_place_to_one_who_waits() {
    let (mut station, address) = listener(station());
    let mut first = TcpStream::connect(&address).unwrap();
    first.write_all(&stream(Sender::v2(1, 1), 0..1)).unwrap();
    assert_eq!(next(&mut station), sent(0..1)[0]);
    // Its cable is cut: it does not even say goodbye.
    let mut second = TcpStream::connect(&address).unwrap();
    second.write_all(&stream(Sender::v2(2, 1), 1..2)).unwrap();
    let (frame, peer) = station.receive_from(soon()).unwrap().unwrap();
    assert_eq!((frame.system_id().to_u32(), peer.address()), (2, second.local_addr().ok()));
    assert_eq!(station.statistics().connections, 2);
}
