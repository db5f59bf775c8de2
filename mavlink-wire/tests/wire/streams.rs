//! Streams that are cut anywhere and damaged anywhere.

use crate::small::{AqEscTelemetry, Heartbeat, Small, Statustext};
use mavlink_wire::{Chars, Dialect, Encode, Frame, FrameBuf, MAX_FRAME, Message, Parser, Sender, Table, crc};
use proptest::prelude::*;

/// All frames of a stream that comes in these chunks.
fn parsed<'c>(table: &Table<'_>, chunks: impl IntoIterator<Item = &'c [u8]>) -> Vec<Vec<u8>> {
    let (mut parser, mut frames) = (Parser::new(table), vec![]);
    for mut chunk in chunks {
        while let Some(frame) = parser.next(&mut chunk) {
            frames.push(frame.bytes().to_vec());
        }
        assert!(chunk.is_empty());
    }
    while let Some(frame) = parser.finish() {
        frames.push(frame.bytes().to_vec());
    }
    frames
}

/// The same by the definition, a byte at a time over the whole stream: start, end and verification of each frame.
fn scanned(table: &Table<'_>, stream: &[u8]) -> Vec<(usize, usize, bool)> {
    let (mut at, mut frames) = (0, vec![]);
    while at < stream.len() {
        match whole_frame(table, &stream[at..]) {
            Some((length, verified)) => {
                frames.push((at, at + length, verified));
                at += length;
            }
            None => at += 1,
        }
    }
    frames
}

fn whole_frame(table: &Table<'_>, bytes: &[u8]) -> Option<(usize, bool)> {
    let (header, signature) = match *bytes {
        [0xFE, ..] => (6, 0),
        [0xFD, _, flags @ 0..=1, ..] => (10, 13 * usize::from(flags)),
        _ => return None,
    };
    let end = header + usize::from(*bytes.get(1)?);
    let _ = bytes.get(..end + 2 + signature)?;
    let id = match header {
        6 => u32::from(bytes[5]),
        _ => u32::from_le_bytes([bytes[7], bytes[8], bytes[9], 0]),
    };
    let (sent, crc) = (u16::from_le_bytes([bytes[end], bytes[end + 1]]), crc::checksum(&bytes[1..end]));
    let explained = |extra: &u8| crc::step(crc, *extra) == sent;
    let verified = match table.get(id) {
        Some(info) => explained(&info.crc_extra).then_some(true)?,
        None => (0..=255).any(|extra| explained(&extra)).then_some(false)?,
    };
    Some((end + 2 + signature, verified))
}

#[derive(Clone, Debug)]
enum Piece {
    V1(Small),
    V2(Small),
    Signed(Small),
    Unknown { id: u32, crc_extra: u8, payload: Vec<u8> },
    Garbage(Vec<u8>),
}

impl Piece {
    fn bytes(&self, sequence: u8) -> Vec<u8> {
        match self {
            Self::V1(message) => encoded(Sender::v1(1, 2), sequence, message),
            Self::V2(message) => encoded(Sender::v2(1, 2), sequence, message),
            Self::Signed(message) => {
                let mut frame = encoded(Sender::v2(1, 2), sequence, message);
                frame.truncate(frame.len() - 2);
                frame[2] = 1;
                let mut frame = with_checksum(frame, message.info().crc_extra);
                frame.extend([0xFD; 13]);
                frame
            }
            Self::Unknown { id, crc_extra, payload } => {
                let [a, b, c, _] = id.to_le_bytes();
                let header = [0xFD, payload.len() as u8, 0, 0, sequence, 1, 2, a, b, c];
                with_checksum([&header, &payload[..]].concat(), *crc_extra)
            }
            Self::Garbage(bytes) => bytes.clone(),
        }
    }
}

fn encoded(mut sender: Sender, sequence: u8, message: &Small) -> Vec<u8> {
    let mut buffer = [0; MAX_FRAME];
    sender.set_sequence(sequence);
    sender.encode(message, &mut buffer).unwrap().to_vec()
}

fn with_checksum(mut bytes: Vec<u8>, crc_extra: u8) -> Vec<u8> {
    let checksum = crc::step(crc::checksum(&bytes[1..]), crc_extra);
    bytes.extend(checksum.to_le_bytes());
    bytes
}

/// Bytes with many starts of frames among them.
fn byte() -> impl Strategy<Value = u8> {
    prop_oneof![3 => any::<u8>(), 2 => Just(0xFD), 2 => Just(0xFE), 2 => 0..4_u8]
}

fn message() -> impl Strategy<Value = Small> {
    let bytes = proptest::collection::vec(byte(), 55);
    (0..3, bytes).prop_map(|(which, bytes)| match which {
        0 => Heartbeat::decode(&bytes).into(),
        1 => AqEscTelemetry::decode(&bytes).into(),
        _ => Statustext { text: Chars::truncated("Low voltage"), ..Statustext::decode(&bytes) }.into(),
    })
}

fn piece() -> impl Strategy<Value = Piece> {
    let unknown = (300..70_000_u32, any::<u8>(), proptest::collection::vec(byte(), 0..=255));
    prop_oneof![
        3 => message().prop_map(Piece::V1),
        3 => message().prop_map(Piece::V2),
        1 => message().prop_map(Piece::Signed),
        1 => unknown.prop_map(|(id, crc_extra, payload)| Piece::Unknown { id, crc_extra, payload }),
        2 => proptest::collection::vec(byte(), 0..40).prop_map(Piece::Garbage),
    ]
}

fn pieces() -> impl Strategy<Value = Vec<Vec<u8>>> {
    proptest::collection::vec(piece(), 1..12)
        .prop_map(|pieces| pieces.iter().zip(0..).map(|(piece, sequence)| piece.bytes(sequence)).collect())
}

/// Cuts a stream at these places.
fn cut<'s>(stream: &'s [u8], cuts: &[prop::sample::Index]) -> Vec<&'s [u8]> {
    let mut places: Vec<usize> = cuts.iter().map(|cut| cut.index(stream.len() + 1)).collect();
    places.sort_unstable();
    let mut chunks = vec![];
    let mut rest = stream;
    for place in places.iter().rev() {
        let (before, chunk) = rest.split_at(*place);
        chunks.push(chunk);
        rest = before;
    }
    chunks.push(rest);
    chunks.reverse();
    chunks
}

proptest! {
    #[test]
    fn cuts_change_nothing(
        pieces in pieces(),
        cuts in proptest::collection::vec(any::<prop::sample::Index>(), 0..20),
        size in 1..40_usize,
    ) {
        let stream = pieces.concat();
        let expected: Vec<Vec<u8>> =
            scanned(Small::TABLE, &stream).iter().map(|&(start, end, _)| stream[start..end].to_vec()).collect();
        prop_assert_eq!(&parsed(Small::TABLE, [&stream[..]]), &expected);
        prop_assert_eq!(&parsed(Small::TABLE, cut(&stream, &cuts)), &expected);
        prop_assert_eq!(&parsed(Small::TABLE, stream.chunks(size)), &expected);
        prop_assert_eq!(&parsed(Small::TABLE, stream.chunks(1)), &expected);
    }

    #[test]
    fn a_damaged_frame_costs_only_itself(
        pieces in pieces(),
        hit in any::<prop::sample::Index>(),
        flip in 1..=255_u8,
        cuts in proptest::collection::vec(any::<prop::sample::Index>(), 0..4),
    ) {
        let mut stream = pieces.concat();
        prop_assume!(!stream.is_empty());
        let hit = hit.index(stream.len());
        stream[hit] ^= flip;
        let found = scanned(Small::TABLE, &stream);
        let frames = parsed(Small::TABLE, cut(&stream, &cuts));
        let mut end = 0;
        for piece in &pieces {
            let start = end;
            end += piece.len();
            let intact = whole_frame(Small::TABLE, piece).is_some_and(|(length, _)| length == piece.len());
            // Chance can make a frame of an unknown message from garbage, or a verified one with a good checksum.
            let swallowed = found.iter().any(|&(s, e, _)| (s, e) != (start, end) && s < end && start < e);
            if intact && !(start..end).contains(&hit) && !swallowed {
                prop_assert!(frames.contains(piece));
            }
        }
    }

    #[test]
    fn any_bytes_are_survived(bytes in proptest::collection::vec(byte(), 0..600), size in 1..300_usize) {
        prop_assert_eq!(parsed(Small::TABLE, bytes.chunks(size)), parsed(Small::TABLE, [&bytes[..]]));
    }
}

/// Two heartbeats, the first with this byte changed.
fn two_heartbeats(at: usize, to: u8) -> Vec<u8> {
    let mut stream = encoded(Sender::v2(1, 1), 0, &Heartbeat::DEFAULT.into());
    stream[at] = to;
    stream.extend(encoded(Sender::v1(1, 1), 1, &Heartbeat::DEFAULT.into()));
    stream
}

#[test]
fn every_single_damage_costs_one_frame() {
    let length = encoded(Sender::v2(1, 1), 0, &Heartbeat::DEFAULT.into()).len();
    for at in 0..length {
        for to in 0..=255 {
            let stream = two_heartbeats(at, to);
            for size in [1, 7, 64] {
                let frames = parsed(Small::TABLE, stream.chunks(size));
                // An id that becomes unknown leaves the checksum explained in one of 256 cases: handed over, too.
                let second = frames.last().map(Vec::as_slice);
                assert_eq!(second, Some(&stream[length..]), "byte {at} is {to}, chunks of {size}");
            }
        }
    }
}

#[test]
fn an_unfinished_frame_waits_until_the_end() {
    let stream = two_heartbeats(1, 255);
    let (mut parser, mut input) = (Parser::new(Small::TABLE), &stream[..]);
    assert_eq!(parser.next(&mut input), None);
    assert!(input.is_empty());
    assert_eq!(parser.finish().map(|frame| frame.sequence()), Some(1));
    assert_eq!(parser.finish(), None);
    let mut input = &stream[stream.len() - 17..];
    assert!(parser.next(&mut input).is_some_and(|frame| frame.is_verified()));
}

#[test]
fn frames_within_a_chunk_are_not_copied() {
    let stream = two_heartbeats(0, 0xFD);
    let (mut parser, mut input) = (Parser::new(Small::TABLE), &stream[..]);
    let (first, second) = (parser.next(&mut input).map(address), parser.next(&mut input).map(address));
    assert_eq!((first, second), (Some(stream.as_ptr()), Some(stream[stream.len() - 17..].as_ptr())));
}

fn address(frame: Frame<'_>) -> *const u8 {
    frame.bytes().as_ptr()
}

#[test]
fn unknown_flags_refuse_the_frame() {
    let mut frame = encoded(Sender::v2(1, 1), 0, &Heartbeat::DEFAULT.into());
    frame.truncate(frame.len() - 2);
    frame[2] = 2;
    let frame = with_checksum(frame, 50);
    assert_eq!(parsed(Small::TABLE, [&frame[..]]), Vec::<Vec<u8>>::new());
}

#[test]
fn a_kept_frame_outlives_the_parser() {
    let stream = two_heartbeats(0, 0xFD);
    let mut kept = vec![];
    for mut chunk in stream.chunks(5) {
        let mut parser = Parser::new(Small::TABLE);
        while let Some(frame) = parser.next(&mut chunk) {
            kept.push(FrameBuf::from(frame));
        }
    }
    assert_eq!(kept, []);
    let mut parser = Parser::new(Small::TABLE);
    for mut chunk in stream.chunks(5) {
        while let Some(frame) = parser.next(&mut chunk) {
            kept.push(FrameBuf::from(frame));
        }
    }
    assert_eq!(kept.iter().map(|frame| frame.as_frame().bytes()).collect::<Vec<_>>().concat(), stream);
}

/// A tlog has a time of eight bytes before every frame, and a router's log many messages that the reader does not know.
#[test]
fn unknown_frames_between_the_times_of_a_tlog_are_handed_over() {
    let known = encoded(Sender::v2(1, 1), 0, &Heartbeat::DEFAULT.into());
    let unknown = Piece::Unknown { id: 70_000, crc_extra: 7, payload: vec![1, 2, 3] }.bytes(0);
    let time = 1_700_000_000_000_000_u64.to_be_bytes();
    let log = [&time[..], &unknown, &time, &known, &time, &unknown, &time, &unknown].concat();
    for size in [1, 7, 64, log.len()] {
        assert_eq!(parsed(Small::TABLE, log.chunks(size)), [&unknown[..], &known, &unknown, &unknown]);
    }
}
