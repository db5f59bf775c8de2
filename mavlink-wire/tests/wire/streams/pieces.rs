//! What streams are made of.

use mavlink_wire::{Chars, Encode, MAX_FRAME, Message, Sender, crc};
use proptest::prelude::*;

use crate::small::{AqEscTelemetry, Heartbeat, Small, Statustext};

#[derive(Clone, Debug)]
pub(crate) enum Piece {
    V1(Small),
    V2(Small),
    Signed(Small),
    Unknown { id: u32, crc_extra: u8, payload: Vec<u8> },
    Garbage(Vec<u8>),
}

impl Piece {
    pub(crate) fn bytes(&self, sequence: u8) -> Vec<u8> {
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

pub(crate) fn encoded(mut sender: Sender, sequence: u8, message: &Small) -> Vec<u8> {
    let mut buffer = [0; MAX_FRAME];
    sender.set_sequence(sequence);
    sender.encode(message, &mut buffer).unwrap().to_vec()
}

pub(crate) fn with_checksum(mut bytes: Vec<u8>, crc_extra: u8) -> Vec<u8> {
    let checksum = crc::step(crc::checksum(&bytes[1..]), crc_extra);
    bytes.extend(checksum.to_le_bytes());
    bytes
}

/// Bytes with many starts of frames among them.
pub(crate) fn byte() -> impl Strategy<Value = u8> {
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

pub(crate) fn pieces() -> impl Strategy<Value = Vec<Vec<u8>>> {
    proptest::collection::vec(piece(), 1..12)
        .prop_map(|pieces| pieces.iter().zip(0..).map(|(piece, sequence)| piece.bytes(sequence)).collect())
}

/// Cuts a stream at these places.
pub(crate) fn cut<'s>(stream: &'s [u8], cuts: &[prop::sample::Index]) -> Vec<&'s [u8]> {
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
