//! What a parser has to find, written down as directly as possible, over a whole stream.

use mavlink_wire::{Parser, Table, crc};

/// All frames of a stream that comes in these chunks.
pub(crate) fn parsed<'c>(table: &Table<'_>, chunks: impl IntoIterator<Item = &'c [u8]>) -> Vec<Vec<u8>> {
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

/// A frame at a place of a stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    pub(crate) start: usize,
    pub(crate) end: usize,
    pub(crate) verified: bool,
}

/// The same by the definition, a byte at a time over the whole stream.
pub(crate) fn scanned(table: &Table<'_>, stream: &[u8]) -> Vec<Place> {
    let (mut at, mut expected, mut frames) = (0, true, vec![]);
    while at < stream.len() {
        match whole_frame(table, &stream[at..]) {
            Some((length, verified)) if verified || is_believed(table, &stream[at..], length, expected) => {
                frames.push(Place { start: at, end: at + length, verified });
                (at, expected) = (at + length, true);
            }
            _ => (at, expected) = (at + 1, false),
        }
    }
    frames
}

/// Whether this one of the frames that were found stands between others, or at an end.
pub(crate) fn stands_between(found: &[Place], place: Place, stream: &[u8]) -> bool {
    let behind = place.start == 0 || found.iter().any(|other| other.end == place.start);
    behind && matches!(stream.get(place.end), None | Some(0xFD | 0xFE))
}

/// Whether an unknown frame stands between others, or carries no known one.
fn is_believed(table: &Table<'_>, bytes: &[u8], length: usize, expected: bool) -> bool {
    let between = expected && matches!(bytes.get(length), None | Some(0xFD | 0xFE));
    between || !(1..length).any(|inside| matches!(whole_frame(table, &bytes[inside..]), Some((_, true))))
}

/// Length and verification of the frame at the start of the bytes.
pub(crate) fn whole_frame(table: &Table<'_>, bytes: &[u8]) -> Option<(usize, bool)> {
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
