//! UDP.

use std::io::ErrorKind;
use std::net::{SocketAddr, UdpSocket};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use mavlink_wire::udp::Endpoint;
use mavlink_wire::{Dialect, Frame, Sender};

use super::{TooLarge, key, message, read, sent, stream};
use crate::small::Small;
use crate::streams::pieces::with_checksum;

/// Nothing is lost on the loopback interface: who waits so long waits in vain.
const LONG: Duration = Duration::from_secs(20);

fn socket() -> UdpSocket {
    let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
    socket.set_read_timeout(Some(LONG)).unwrap();
    socket
}

fn endpoint(system: u8) -> (Endpoint<'static>, SocketAddr) {
    let endpoint = Endpoint::new(socket(), Small::TABLE, Sender::v2(system, 1));
    let address = endpoint.socket().local_addr().unwrap();
    (endpoint, address)
}

#[test]
fn several_frames_of_several_peers_come_with_their_senders() {
    let (mut station, address) = endpoint(255);
    let vehicles: [UdpSocket; 2] = std::array::from_fn(|_| socket());
    for (vehicle, numbers) in vehicles.iter().zip([0..3, 3..5]) {
        vehicle.send_to(&stream(Sender::v1(1, 1), numbers), address).unwrap();
    }
    let mut received = vec![];
    for _ in 0..5 {
        let (frame, peer) = station.receive().unwrap();
        received.push((peer, read(&frame).1));
    }
    let [first, second] = vehicles.each_ref().map(|vehicle| vehicle.local_addr().unwrap());
    let expected = sent(0..5).into_iter().zip([first, first, first, second, second]);
    assert_eq!(received, expected.map(|((_, message), peer)| (peer, message)).collect::<Vec<_>>());
    assert_eq!(station.peers().collect::<Vec<_>>(), [second, first]);
    assert_eq!(station.statistics().frames, 5);

    // An answer to one, to all, and a frame as it came.
    station.send_to(&message(0), first).unwrap();
    station.send_to_all(&message(1)).unwrap();
    let forwarded = stream(Sender::v1(9, 9), 7..8);
    let forwarded = Frame::parse(&forwarded, Small::TABLE).unwrap();
    station.send_frame_to_all(&forwarded).unwrap();
    station.send_frame_to(&forwarded, first).unwrap();
    let answers = |vehicle: &UdpSocket, count: usize| -> Vec<Vec<u8>> {
        let receive = |_| {
            let mut buffer = [0; 300];
            let length = vehicle.recv(&mut buffer).unwrap();
            buffer[..length].to_vec()
        };
        (0..count).map(receive).collect()
    };
    let mut both = vec![stream(Sender::v2(255, 1), 0..1)];
    let mut second_frame = Sender::v2(255, 1);
    second_frame.set_sequence(1);
    both.push(stream(second_frame, 1..2));
    both.push(forwarded.bytes().to_vec());
    assert_eq!(answers(&vehicles[1], 2), both[1..]);
    both.push(forwarded.bytes().to_vec());
    assert_eq!(answers(&vehicles[0], 4), both);
}

#[test]
fn a_datagram_is_a_stream_of_its_own() {
    let (mut station, address) = endpoint(255);
    let (vehicle, bytes) = (socket(), stream(Sender::v2(1, 1), 0..3));
    let third = stream(Sender::v2(1, 1), 0..2).len();
    vehicle.send_to(&[], address).unwrap();
    vehicle.send_to(&bytes[..third + 5], address).unwrap();
    vehicle.send_to(&bytes[third + 5..], address).unwrap();
    vehicle.send_to(&[&[0xFD, 200, 0][..], &bytes].concat(), address).unwrap();
    let received: Vec<_> = (0..5).map(|_| read(&station.receive().unwrap().0)).collect();
    assert_eq!(received, [sent(0..2), sent(0..3)].concat());
}

#[test]
fn datagrams_without_a_frame_keep_nobody_waiting() {
    let (mut station, address) = endpoint(255);
    station.socket().set_read_timeout(Some(Duration::from_millis(50))).unwrap();
    let heard = AtomicBool::new(false);
    let error = std::thread::scope(|scope| {
        scope.spawn(|| {
            let stranger = socket();
            for garbage in [&b"MAVLink?"[..], &[], &[0xFD]].into_iter().cycle().take(2000) {
                if heard.load(Ordering::Relaxed) {
                    return;
                }
                stranger.send_to(garbage, address).unwrap();
                std::thread::sleep(Duration::from_millis(5));
            }
            stranger.send_to(&stream(Sender::v1(1, 1), 0..1), address).unwrap();
        });
        let error = station.receive().map(drop).unwrap_err();
        heard.store(true, Ordering::Relaxed);
        error.kind()
    });
    assert!(matches!(error, ErrorKind::TimedOut | ErrorKind::WouldBlock), "{error}");
}

#[test]
fn only_who_sends_verified_frames_is_a_peer_and_the_oldest_is_forgotten() {
    let (station, address) = endpoint(255);
    let mut station = station.with_peer_limit(2);
    let sockets: [UdpSocket; 4] = std::array::from_fn(|_| socket());
    let beat = stream(Sender::v1(1, 1), 0..1);
    let addresses = sockets.each_ref().map(|socket| socket.local_addr().unwrap());
    for sender in [0, 1, 0, 2] {
        sockets[sender].send_to(&beat, address).unwrap();
    }
    // The fourth sends a frame of a message that nobody knows.
    let unknown = with_checksum(vec![0xFE, 1, 0, 1, 1, 200, 7], 3);
    sockets[3].send_to(&unknown, address).unwrap();
    while station.receive().unwrap().1 != addresses[3] {}
    assert_eq!(station.peers().collect::<Vec<_>>(), [addresses[2], addresses[0]]);
    let (station, address) = endpoint(255);
    let mut station = station.with_peer_limit(0);
    sockets[0].send_to(&beat, address).unwrap();
    station.receive().unwrap();
    assert_eq!(station.peers().len(), 0);
}

#[test]
fn errors_have_their_reasons() {
    let mut station = Endpoint::new(socket(), Small::TABLE, Sender::v1(255, 1));
    station.socket().set_nonblocking(true).unwrap();
    assert_eq!(station.receive().unwrap_err().kind(), ErrorKind::WouldBlock);
    let nobody = socket().local_addr().unwrap();
    assert_eq!(station.send_to(&TooLarge, nobody).unwrap_err().kind(), ErrorKind::InvalidInput);
    assert_eq!(station.send_to_all(&TooLarge).unwrap_err().kind(), ErrorKind::InvalidInput);
    let key = key();
    let key = Frame::parse(&key, Small::TABLE).unwrap();
    assert_eq!(station.send_frame_to(&key, nobody).unwrap_err().kind(), ErrorKind::InvalidInput);
    assert_eq!(station.send_frame_to_all(&key).unwrap_err().kind(), ErrorKind::InvalidInput);
    station.send_to_all(&message(0)).unwrap();
    assert_eq!(station.sender().sequence(), 1);
}
