//! Serial ports of async tasks, over pseudo terminals.

use std::io::Read;

use mavlink_wire::Parser;
use serialport::{SerialPort, TTYPort};

use super::cancelled::{receive_with_drops, up_to};
use super::*;

/// A vehicle's end of a cable, and the address of ours.
fn cable() -> (TTYPort, String) {
    let (mut vehicle, ours) = TTYPort::pair().unwrap();
    vehicle.set_timeout(LONG).unwrap();
    let address = format!("serial:{}:57600", ours.name().unwrap());
    (vehicle, address)
}

#[tokio::test]
async fn both_sides_talk_and_a_cut_cable_is_told() {
    let (mut vehicle, address) = cable();
    let mut link = Link::connect(&address, station().without_reconnecting()).await.unwrap();
    vehicle.write_all(&stream(Sender::v2(1, 1), 0..3)).unwrap();
    for expected in sent(0..3) {
        assert_eq!(next(&mut link).await, expected);
    }
    assert_eq!(link.send(&message(0)).await.unwrap(), 1);
    let expected = stream(Sender::v2(255, 190), 0..1);
    let mut heard = vec![0; expected.len()];
    vehicle.read_exact(&mut heard).unwrap();
    assert_eq!(heard, expected);
    drop(vehicle);
    assert!(matches!(link.receive().await, Err(LinkError::Closed)));
    assert!(matches!(link.send(&message(0)).await, Err(LinkError::Closed)));
    let missing = Link::connect("serial:/dev/no_such_port:57600", station()).await.unwrap_err();
    assert!(matches!(missing, LinkError::NoDevice { .. }), "{missing:?}");
}

#[tokio::test]
async fn a_dropped_receiver_loses_no_byte() {
    let (mut vehicle, address) = cable();
    let mut link = Link::connect(&address, station()).await.unwrap();
    let writer = std::thread::spawn(move || {
        for piece in stream(Sender::v2(1, 1), 0..60).chunks(3) {
            vehicle.write_all(piece).unwrap();
        }
        vehicle
    });
    let (received, _) = receive_with_drops(&mut link, 60).await;
    let _vehicle = writer.join().unwrap();
    assert_eq!(received, sent(0..60));
}

/// What came at the other end of a cable: number and content of each frame.
struct Heard {
    vehicle: TTYPort,
    parser: Parser<'static>,
    frames: Vec<(u8, u32)>,
}

impl Heard {
    /// Takes a few bytes.
    fn take(&mut self) {
        let mut buffer = [0; 37];
        let count = self.vehicle.read(&mut buffer).unwrap();
        let mut input = &buffer[..count];
        while let Some(frame) = self.parser.next(&mut input) {
            let content = match frame.message() {
                Some(Small::AqEscTelemetry(telemetry)) => telemetry.time_boot_ms,
                Some(Small::Heartbeat(beat)) => beat.custom_mode,
                other => unreachable!("{other:?}"),
            };
            self.frames.push((frame.sequence(), content));
        }
    }
}

/// Fills the buffer, and drops sends at each of their waits while the other side takes a little at a time.
#[tokio::test]
async fn a_dropped_sender_tears_no_frame_and_loses_none() {
    let (vehicle, address) = cable();
    let mut heard = Heard { vehicle, parser: Parser::new(Small::TABLE), frames: vec![] };
    let link = Link::connect(&address, station().with_send_timeout(Duration::from_millis(1))).await.unwrap();
    let (mut number, mut done, mut dropped) = (0, vec![], 0);
    while dropped < 300 {
        number += 1;
        match up_to((number % 3) as usize, link.send(&message(number))).await {
            Some(Ok(_)) => done.push(number),
            Some(Err(error)) => {
                assert!(matches!(error, LinkError::Full), "{error}");
                heard.take();
            }
            None => {
                dropped += 1;
                heard.take();
            }
        }
        tokio::task::yield_now().await;
    }
    // What is still on its way goes out before the last one.
    while !matches!(up_to(0, link.send(&message(number + 1))).await, Some(Ok(_))) {
        heard.take();
        tokio::task::yield_now().await;
    }
    while heard.frames.last().is_none_or(|(_, content)| *content <= number) {
        heard.take();
        up_to(0, link.send(&message(number + 2))).await;
    }
    let (frames, statistics) = (heard.frames, heard.parser.statistics());
    assert_eq!((statistics.skipped_bytes, statistics.bad_checksums), (0, 0));
    assert!(frames.windows(2).all(|pair| pair[0].0.wrapping_add(1) == pair[1].0), "no number is missing");
    assert!(frames.windows(2).all(|pair| pair[0].1 < pair[1].1), "in order, each once");
    let came: std::collections::BTreeSet<_> = frames.iter().map(|(_, content)| *content).collect();
    assert!(done.iter().all(|number| came.contains(number)), "what was sent has come");
}
