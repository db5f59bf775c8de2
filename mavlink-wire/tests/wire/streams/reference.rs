//! What a parser has to find, written down as directly as possible, over a whole stream.

use std::ops::Range;

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
    let (mut at, mut expected, mut searched, mut frames, mut seen) = (0, true, 0, vec![], Sightings::default());
    while at < stream.len() {
        let Some(found) = whole_frame(table, &stream[at..]) else {
            (at, expected) = (at + 1, false);
            continue;
        };
        let end = at + found.length;
        if !found.verified && !seen.are_alike(&found) && !is_between(stream, end, expected) {
            let carries_known = carries_known(table, stream, at..end, &mut searched);
            if carries_known {
                (at, expected) = (at + 1, false);
                continue;
            }
        }
        if !found.verified && expected {
            seen.add(found);
        }
        frames.push(Place { start: at, end, verified: found.verified });
        (at, expected) = (end, true);
    }
    frames
}

/// The unknown messages that were seen behind another frame, or at the beginning, the latest last: id, `crc_extra`, and
/// whether it was the same the time before.
#[derive(Default)]
struct Sightings(Vec<(u32, u8, bool)>);

impl Sightings {
    fn are_alike(&self, found: &Found) -> bool {
        self.0.contains(&(found.id, found.crc_extra, true))
    }

    fn add(&mut self, found: Found) {
        let before = self.0.iter().position(|(id, ..)| *id == found.id).map(|place| self.0.remove(place));
        let alike = before.is_some_and(|(_, crc_extra, _)| crc_extra == found.crc_extra);
        self.0.push((found.id, found.crc_extra, alike));
        if self.0.len() > 8 {
            self.0.remove(0);
        }
    }
}

/// Whether this one of the frames that were found stands between others, or at an end.
pub(crate) fn stands_between(found: &[Place], place: Place, stream: &[u8]) -> bool {
    let behind = place.start == 0 || found.iter().any(|other| other.end == place.start);
    behind && matches!(stream.get(place.end), None | Some(0xFD | 0xFE))
}

/// Whether a frame that ends here stands between others, or at the end.
fn is_between(stream: &[u8], end: usize, expected: bool) -> bool {
    expected && matches!(stream.get(end), None | Some(0xFD | 0xFE))
}

/// Whether a known frame starts inside of this unknown one: one that ends in it; or one that seems to start in it, and ends
/// behind it, unless another one seems to start directly behind, or the stream ends there. What was searched before is not
/// searched again.
fn carries_known(table: &Table<'_>, stream: &[u8], frame: Range<usize>, searched: &mut usize) -> bool {
    for start in frame.start + 1..frame.end {
        if start < *searched {
            continue;
        }
        *searched = start;
        let ends_inside = shape(&stream[start..]).is_some_and(|shape| start + shape.length <= frame.end);
        if ends_inside && is_verified(table, &stream[start..]) {
            return true;
        }
        if !ends_inside && seems_known(table, stream, start) && frame.end < stream.len() {
            return !seems_known(table, stream, frame.end);
        }
    }
    *searched = frame.end.max(*searched);
    false
}

/// Whether a known frame starts here, as far as the ten bytes of a header tell.
pub(crate) fn seems_known(table: &Table<'_>, stream: &[u8], start: usize) -> bool {
    let bytes = &stream[start..stream.len().min(start + 10)];
    let Some(Shape { length, payload, id }) = shape(bytes) else { return false };
    let likely = table.get(id).is_some_and(|info| bytes[0] == 0xFD || usize::from(info.len_v1) == payload);
    if length <= bytes.len() { is_verified(table, bytes) } else { likely }
}

fn is_verified(table: &Table<'_>, bytes: &[u8]) -> bool {
    matches!(whole_frame(table, bytes), Some(Found { verified: true, .. }))
}

/// A frame by its checksum.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    pub(crate) length: usize,
    pub(crate) verified: bool,
    id: u32,
    crc_extra: u8,
}

/// What a header says.
struct Shape {
    length: usize,
    payload: usize,
    id: u32,
}

/// The header at the start of the bytes.
fn shape(bytes: &[u8]) -> Option<Shape> {
    let payload = usize::from(*bytes.get(1)?);
    match *bytes {
        [0xFE, _, _, _, _, id, ..] => Some(Shape { length: 6 + payload + 2, payload, id: id.into() }),
        [0xFD, _, signed @ 0..=1, _, _, _, _, a, b, c, ..] => {
            let length = 10 + payload + 2 + 13 * usize::from(signed);
            Some(Shape { length, payload, id: u32::from_le_bytes([a, b, c, 0]) })
        }
        _ => None,
    }
}

/// The frame at the start of the bytes.
pub(crate) fn whole_frame(table: &Table<'_>, bytes: &[u8]) -> Option<Found> {
    let Shape { length, payload, id } = shape(bytes)?;
    let end = payload + if bytes[0] == 0xFE { 6 } else { 10 };
    let _ = bytes.get(..length)?;
    let (sent, crc) = (u16::from_le_bytes([bytes[end], bytes[end + 1]]), crc::checksum(&bytes[1..end]));
    let known = table.get(id).map(|info| info.crc_extra);
    let crc_extra =
        (0..=255).find(|extra| crc::step(crc, *extra) == sent && known.is_none_or(|known| known == *extra))?;
    Some(Found { length, verified: known.is_some(), id, crc_extra })
}
