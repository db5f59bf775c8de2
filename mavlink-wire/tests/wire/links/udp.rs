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
        vehicle.send_to(&stream(Sender::v2(1, 1), numbers), address).unwrap();
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
fn frames_that_are_cut_into_datagrams_are_whole_again() {
    let (mut station, address) = endpoint(255);
    // Two bridges cut without looking, and each knows nothing of the other.
    let bridges: [UdpSocket; 2] = std::array::from_fn(|_| socket());
    let bytes = stream(Sender::v2(1, 1), 0..24);
    for chunk in bytes.chunks(13) {
        for bridge in &bridges {
            bridge.send_to(chunk, address).unwrap();
        }
    }
    let mut received = [vec![], vec![]];
    for _ in 0..48 {
        let (frame, from) = station.receive().unwrap();
        received[usize::from(from == bridges[1].local_addr().unwrap())].push(read(&frame));
    }
    assert_eq!(received, [sent(0..24), sent(0..24)]);
    assert_eq!((station.statistics().bad_checksums, station.statistics().skipped_bytes), (0, 0));
}

#[test]
fn what_waits_for_a_rest_that_does_not_come_is_searched_after_a_silence() {
    let (mut station, address) = endpoint(255);
    let (vehicle, bytes) = (socket(), stream(Sender::v2(1, 1), 0..3));
    // What looks like the start of a long frame, and nothing behind: long before the socket's timeout.
    vehicle.send_to(&[&[0xFD, 200, 0][..], &bytes].concat(), address).unwrap();
    let received: Vec<_> = (0..3).map(|_| read(&station.receive().unwrap().0)).collect();
    assert_eq!(received, sent(0..3));
    assert_eq!(station.socket().read_timeout().unwrap(), Some(LONG), "it is the caller's again");
    // Also where nobody waits: each call says that there is nothing yet, until it was silent for long enough.
    station.socket().set_nonblocking(true).unwrap();
    vehicle.send_to(&[&[0xFD, 200, 0][..], &bytes].concat(), address).unwrap();
    let mut received = vec![];
    while received.len() < 3 {
        match station.receive() {
            Ok((frame, _)) => received.push(read(&frame)),
            Err(error) => assert_eq!(error.kind(), ErrorKind::WouldBlock),
        }
    }
    assert_eq!(received, sent(0..3));
}

#[test]
fn one_call_does_bounded_work() {
    let (mut station, address) = endpoint(255);
    station.socket().set_nonblocking(true).unwrap();
    let stranger = socket();
    // More than one call's share, as far as the receive buffer of the socket takes it.
    for _ in 0..200 {
        stranger.send_to(&[0; 1000], address).unwrap();
    }
    assert_eq!(station.receive().unwrap_err().kind(), ErrorKind::WouldBlock);
    let first = station.statistics().skipped_bytes;
    assert!((1..=66_000).contains(&first), "{first}");
    stranger.send_to(&[0; 1000], address).unwrap();
    assert_eq!(station.receive().unwrap_err().kind(), ErrorKind::WouldBlock);
    assert!(station.statistics().skipped_bytes > first, "it goes on where it was");
}

#[test]
fn peers_expire_and_can_be_removed() {
    let (station, address) = endpoint(255);
    let mut station = station.with_peer_expiry(Duration::from_millis(20));
    let vehicle = socket();
    vehicle.send_to(&stream(Sender::v2(1, 1), 0..1), address).unwrap();
    station.receive().unwrap();
    while station.peers().len() > 0 {
        std::thread::yield_now();
    }
    assert_eq!(station.send_to_all(&message(0)).unwrap(), 0, "nobody is there");

    let mut station = station.with_peer_expiry(LONG);
    vehicle.send_to(&stream(Sender::v2(1, 1), 1..2), address).unwrap();
    station.receive().unwrap();
    let peer = vehicle.local_addr().unwrap();
    assert_eq!((station.peers().len(), station.send_to_all(&message(0)).unwrap()), (1, 1));
    assert!(station.remove_peer(peer) && !station.remove_peer(peer));
    assert_eq!((station.peers().len(), station.send_to_all(&message(0)).unwrap()), (0, 0));
    assert_eq!(station.statistics().frames, 2, "what it sent still counts");
}

#[test]
fn strangers_push_nobody_out() {
    let (mut station, address) = endpoint(255);
    let (vehicle, beat) = (socket(), stream(Sender::v1(1, 1), 0..1));
    // Half of a frame, whose rest comes behind the strangers.
    vehicle.send_to(&[&beat[..], &beat[..9]].concat(), address).unwrap();
    station.receive().unwrap();
    for _ in 0..40 {
        socket().send_to(&beat, address).unwrap();
        station.receive().unwrap();
        socket().send_to(b"no frame", address).unwrap();
    }
    vehicle.send_to(&beat[9..], address).unwrap();
    assert_eq!(station.receive().unwrap().1, vehicle.local_addr().unwrap());
    assert_eq!((station.peers().next(), station.peers().len()), (vehicle.local_addr().ok(), 16));
    assert_eq!(station.statistics().frames, 42);
}

#[test]
fn each_peer_is_spoken_to_in_its_version_under_one_number() {
    let (mut station, address) = endpoint(255);
    let (old, new) = (socket(), socket());
    let beat = |sender: Sender| stream(sender, 0..1);
    let frames = [
        (&old, beat(Sender::v1(1, 1))),
        (&new, beat(Sender::v1(2, 1))),
        (&new, beat(Sender::v2(2, 1))),
        (&new, beat(Sender::v1(2, 1))),
    ];
    for (from, bytes) in &frames {
        from.send_to(bytes, address).unwrap();
        station.receive().unwrap();
    }
    assert_eq!(station.send_to_all(&message(0)).unwrap(), 2);
    station.send_to(&message(1), old.local_addr().unwrap()).unwrap();
    // MAVLink 1 cannot carry it: the other gets it all the same, and the number is used.
    assert_eq!(station.send_to_all(&TooLarge).unwrap_err().kind(), ErrorKind::InvalidInput);
    assert_eq!(station.send_to_all(&message(2)).unwrap(), 2);
    assert_eq!((station.sender().sequence(), station.sender().version()), (4, mavlink_wire::Version::V2));
    let heard = |socket: &UdpSocket, count: usize| -> Vec<(u8, u8)> {
        let receive = |_| {
            let mut buffer = [0; 300];
            socket.recv(&mut buffer).unwrap();
            (buffer[0], buffer[if buffer[0] == 0xFE { 2 } else { 4 }])
        };
        (0..count).map(receive).collect()
    };
    assert_eq!(heard(&old, 3), [(0xFE, 0), (0xFE, 1), (0xFE, 3)]);
    assert_eq!(heard(&new, 3), [(0xFD, 0), (0xFD, 2), (0xFD, 3)]);
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
fn only_who_sends_verified_frames_is_a_peer_while_there_is_room() {
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
    assert_eq!(station.peers().collect::<Vec<_>>(), [addresses[0], addresses[1]]);
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
    let key = key();
    let key = Frame::parse(&key, Small::TABLE).unwrap();
    assert_eq!(station.send_frame_to(&key, nobody).unwrap_err().kind(), ErrorKind::InvalidInput);
    assert_eq!(station.send_frame_to_all(&key).unwrap_err().kind(), ErrorKind::InvalidInput);
    assert_eq!(station.send_to_all(&message(0)).unwrap(), 0);
    assert_eq!(station.sender().sequence(), 0);
}
