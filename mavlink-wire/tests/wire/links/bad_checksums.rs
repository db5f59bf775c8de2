//! Of which messages the checksums are wrong, told alike by everything that reads.

use mavlink_wire::io::FrameReader;
use mavlink_wire::udp::Endpoint;
use mavlink_wire::{Dialect, Message, Sender, tlog};

use crate::small::{AqEscTelemetry, Heartbeat, Small};
use crate::streams::pieces::encoded;

/// Of which messages the damaged frames are.
const TOLD: [u32; 4] = [0, 0, 152, 152];

/// Six frames, of which four are damaged.
fn frames() -> [Vec<u8>; 6] {
    let telemetry = |number| encoded(Sender::v2(1, 1), number, &AqEscTelemetry::DEFAULT.into());
    let beat = |number| encoded(Sender::v1(1, 1), number, &Heartbeat::DEFAULT.into());
    let mut frames = [telemetry(0), beat(1), beat(2), telemetry(3), beat(4), telemetry(5)];
    for damaged in [1, 2, 3, 5] {
        // What looks like a start in a damaged frame is not told.
        frames[damaged][10..13].copy_from_slice(&[0xFE, 1, 1]);
    }
    frames
}

#[test]
fn by_a_reader() {
    let (stream, mut told) = (frames().concat(), vec![]);
    let mut reader = FrameReader::new(&stream[..], Small::TABLE);
    while reader.receive_reporting_bad_checksums(|id| told.push(id)).unwrap().is_some() {}
    assert_eq!(told, TOLD);
    assert_eq!(reader.statistics().bad_checksums, 4);
}

#[test]
fn by_a_reader_of_a_log() {
    let time = 1_700_000_000_000_000_u64.to_be_bytes();
    let log: Vec<u8> = frames().iter().flat_map(|frame| [&time[..], frame].concat()).collect();
    let (mut reader, mut told) = (tlog::Reader::new(&log[..], Small::TABLE), vec![]);
    while reader.read_reporting_bad_checksums(|id| told.push(id)).unwrap().is_some() {}
    assert_eq!(told, TOLD);
}

#[test]
fn by_an_endpoint() {
    let socket = std::net::UdpSocket::bind("127.0.0.1:0").unwrap();
    let (mut endpoint, mut told) = (Endpoint::new(socket, Small::TABLE, Sender::v1(1, 1)), vec![]);
    let address = endpoint.socket().local_addr().unwrap();
    // The last one says that all have come.
    for datagram in [frames().concat(), encoded(Sender::v1(9, 9), 9, &Heartbeat::DEFAULT.into())] {
        endpoint.socket().send_to(&datagram, address).unwrap();
    }
    while endpoint.receive_reporting_bad_checksums(|id| told.push(id)).unwrap().0.system_id() != 9 {}
    assert_eq!(told, TOLD);
}

/// What waits for bytes that do not come is searched, and damage in it told.
#[test]
fn by_a_reader_that_gives_up() {
    let stream = [&[0xFD, 255, 0, 0][..], &frames()[1]].concat();
    let link = super::scripted::Scripted::new(
        [super::scripted::Step::Take(1000), super::scripted::Step::Fail(std::io::ErrorKind::TimedOut)],
        &stream,
    );
    let (mut reader, mut told) = (FrameReader::new(link, Small::TABLE), Vec::<u32>::new());
    assert!(reader.receive_reporting_bad_checksums(|id| told.push(id)).is_err());
    assert_eq!(told.len(), 0);
    assert_eq!(reader.finish_reporting_bad_checksums(|id| told.push(id)), None);
    assert_eq!(told, [0]);
}

#[cfg(feature = "embedded-io")]
#[test]
fn by_a_reader_of_embedded_io() {
    let (stream, mut told) = (frames().concat(), vec![]);
    let mut reader = mavlink_wire::embedded_io::FrameReader::new(&stream[..], Small::TABLE);
    while reader.receive_reporting_bad_checksums(|id| told.push(id)).unwrap().is_some() {}
    assert_eq!(told, TOLD);
}

#[cfg(feature = "embedded-io-async")]
#[tokio::test]
async fn by_a_reader_of_embedded_io_async() {
    let (stream, mut told) = (frames().concat(), vec![]);
    let mut reader = mavlink_wire::embedded_io_async::FrameReader::new(&stream[..], Small::TABLE);
    while reader.receive_reporting_bad_checksums(|id| told.push(id)).await.unwrap().is_some() {}
    assert_eq!(told, TOLD);
}

#[cfg(feature = "tokio-codec")]
#[test]
fn by_a_codec() {
    use tokio_util::bytes::BytesMut;
    use tokio_util::codec::Decoder;

    let (mut stream, mut told) = (BytesMut::from(&frames().concat()[..]), vec![]);
    let mut codec = mavlink_wire::tokio_codec::Codec::new(Small::TABLE, Sender::v1(1, 1))
        .reporting_bad_checksums(|id| told.push(id));
    while codec.decode_eof(&mut stream).unwrap().is_some() {}
    assert_eq!(told, TOLD);
}
