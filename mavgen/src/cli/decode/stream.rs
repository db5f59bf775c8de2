//! Frames out of a stream of bytes, with the times that a tlog has in front of them.

use std::collections::BTreeMap;
use std::io::{self, ErrorKind, Read};

use mavlink_wire::{Frame, FrameError, Table};

use super::received::{Received, Time};

/// Bytes that are read at once.
const CHUNK: usize = 1 << 13;

/// A stream of frames. After what is no frame, the search goes on with the next byte.
///
/// Unlike the runtime's parser it knows that in a tlog a frame and the time of the next one belong together, so that it
/// never takes a time for the start of a frame where all is whole.
pub(super) struct Stream<'t> {
    input: Box<dyn Read>,
    /// Bytes in front of each frame.
    lead: usize,
    table: &'t Table<'t>,
    buffer: Vec<u8>,
    /// The first byte in the buffer that belongs to no frame so far.
    start: usize,
    ended: bool,
    tally: Tally,
    /// Whether a frame ended right before `start`: what comes should be one.
    expected: bool,
}

/// What was found, and what was not.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Tally {
    frames: u64,
    unverified: u64,
    skipped: u64,
    /// Where a frame was expected: ids whose checksum was another.
    refused: BTreeMap<u32, u64>,
}

impl<'t> Stream<'t> {
    pub(super) fn new(input: Box<dyn Read>, lead: usize, table: &'t Table<'t>) -> Self {
        let (buffer, tally) = (Vec::new(), Tally::default());
        Self { input, lead, table, buffer, start: 0, ended: false, tally, expected: true }
    }

    /// The next frame; `None` at the end.
    pub(super) fn next(&mut self) -> io::Result<Option<Received<'_>>> {
        let Some(at) = self.find()? else { return Ok(None) };
        let bytes = self.buffer.get(at..).unwrap_or_default();
        let (time, bytes) = bytes.split_at_checked(self.lead).unwrap_or_default();
        let time = time.first_chunk().map(|time| Time(u64::from_be_bytes(*time)));
        Ok(Frame::parse(bytes, self.table).ok().map(|frame| Received { time, frame }))
    }

    pub(super) fn tally(&self) -> &Tally {
        &self.tally
    }

    /// Where the next frame begins, with what stands in front of it; the search will go on behind it.
    fn find(&mut self) -> io::Result<Option<usize>> {
        loop {
            let there = self.buffer.get(self.start + self.lead..).unwrap_or_default();
            match Frame::parse(there, self.table) {
                Ok(frame) => {
                    let (length, verified) = (self.lead + frame.bytes().len(), frame.is_verified());
                    if verified || self.expected || self.precedes_another(length)? {
                        self.tally.frames += 1;
                        self.tally.unverified += u64::from(!verified);
                        let at = self.start;
                        self.start += length;
                        self.expected = true;
                        return Ok(Some(at));
                    }
                    self.skip();
                }
                Err(FrameError::Incomplete { .. }) if !self.ended => self.fill()?,
                Err(_) if self.start >= self.buffer.len() => return Ok(None),
                Err(FrameError::Checksum { id }) if self.expected && self.table.get(id).is_some() => {
                    *self.tally.refused.entry(id).or_default() += 1;
                    self.skip();
                }
                Err(_) => self.skip(),
            }
        }
    }

    /// Whether the end, or what may be the start of a frame, follows so many bytes. Behind damage, one false start in 256
    /// passes for a message that is not known; few of those pass this, too.
    fn precedes_another(&mut self, length: usize) -> io::Result<bool> {
        loop {
            match self.buffer.get(self.start + length + self.lead) {
                Some(byte) => return Ok(matches!(byte, 0xfe | 0xfd)),
                None if self.ended => return Ok(self.start + length == self.buffer.len()),
                None => self.fill()?,
            }
        }
    }

    fn skip(&mut self) {
        self.start += 1;
        self.tally.skipped += 1;
        self.expected = false;
    }

    /// Reads more, and forgets what was used.
    fn fill(&mut self) -> io::Result<()> {
        self.buffer.drain(..self.start.min(self.buffer.len()));
        self.start = 0;
        let kept = self.buffer.len();
        self.buffer.resize(kept + CHUNK, 0);
        let read = loop {
            match self.input.read(self.buffer.get_mut(kept..).unwrap_or_default()) {
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                other => break other,
            }
        };
        self.buffer.truncate(kept + read.as_ref().copied().unwrap_or_default());
        self.ended = read? == 0;
        Ok(())
    }
}

impl Tally {
    /// What was found, in words.
    pub(super) fn lines(&self, table: &Table<'_>) -> Vec<String> {
        let Self { frames, unverified, skipped, refused } = self;
        let mut lines = vec![format!("frames: {frames}, of them unverified: {unverified}, bytes skipped: {skipped}")];
        lines.extend(refused.iter().map(|(id, count)| {
            let name = table.get(*id).map_or("", |info| info.name);
            format!("checksums that do not fit {name} ({id}): {count}; damage, or another definition of it")
        }));
        lines
    }
}

#[cfg(test)]
mod tests {
    use mavlink_wire::MessageInfo;

    use super::*;

    const BEAT: [u8; 17] = [0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];

    static HEARTBEAT: MessageInfo = MessageInfo {
        id: 0,
        name: "HEARTBEAT",
        crc_extra: 50,
        len_v1: 9,
        len_v2: 9,
        target_system: None,
        target_component: None,
    };

    /// Gives one byte at a time.
    struct Slow(io::Cursor<Vec<u8>>);

    impl Read for Slow {
        fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
            self.0.read(bytes.get_mut(..1).unwrap_or_default())
        }
    }

    fn found(bytes: &[u8], lead: usize, table: &Table<'_>) -> (Vec<Option<Time>>, Tally) {
        let read = |input: Box<dyn Read>| {
            let (mut stream, mut times) = (Stream::new(input, lead, table), Vec::new());
            while let Some(received) = stream.next().unwrap() {
                times.push(received.time);
            }
            (times, stream.tally)
        };
        let cursor = io::Cursor::new(bytes.to_vec());
        let (at_once, slowly) = (read(Box::new(cursor.clone())), read(Box::new(Slow(cursor))));
        assert_eq!(at_once, slowly);
        at_once
    }

    fn tally(frames: u64, skipped: u64) -> Tally {
        Tally { frames, skipped, ..Tally::default() }
    }

    #[test]
    fn times_stand_in_front_of_frames() {
        let log: Vec<u8> =
            [7, 0xfe00, u64::MAX].iter().flat_map(|time: &u64| [&time.to_be_bytes()[..], &BEAT].concat()).collect();
        let infos = [&HEARTBEAT];
        let times = [7, 0xfe00, u64::MAX].map(|time| Some(Time(time))).to_vec();
        assert_eq!(found(&log, 8, &Table::of(&infos)), (times, tally(3, 0)));
    }

    #[test]
    fn what_is_no_frame_is_counted() {
        let infos = [&HEARTBEAT];
        let table = Table::of(&infos);
        let noisy = [&[1, 2, 0xfe][..], &BEAT, &[0xfe, 1], &BEAT, &[0xfd]].concat();
        assert_eq!(found(&noisy, 0, &table), (vec![None, None], tally(2, 6)));
        assert_eq!(found(&[], 8, &table), (vec![], tally(0, 0)));
        assert_eq!(found(&[0; 9_999], 8, &table), (vec![], tally(0, 9_999)));
    }

    #[test]
    fn a_false_start_takes_no_frame_along() {
        let infos = [&HEARTBEAT];
        let table = Table::of(&infos);
        // A length, and an id that nobody knows, in front of a frame; and a checksum that some definition explains.
        let false_start = |checksum: u16| [&[0xfe, 17, 0, 0, 0, 77][..], &BEAT, &checksum.to_le_bytes()].concat();
        let passes = (0..=u16::MAX).map(false_start).find(|bytes| Frame::parse(bytes, &table).is_ok());
        let passes = passes.unwrap_or_default();
        let behind_damage = [&[0x55], &passes[..], &[0; 3]].concat();
        assert_eq!(found(&behind_damage, 0, &table), (vec![None], tally(1, 1 + 6 + 2 + 3)));
        let (_, whole) = found(&[&passes[..], &passes].concat(), 0, &table);
        assert_eq!((whole.frames, whole.unverified, whole.skipped), (2, 2, 0), "a frame may carry another");
        let (_, recovered) = found(&[&[0x55], &passes[..], &BEAT].concat(), 0, &table);
        assert_eq!((recovered.frames, recovered.unverified, recovered.skipped), (2, 1, 1));
    }

    #[test]
    fn other_definitions_are_counted_by_message() {
        let other = MessageInfo { crc_extra: 51, ..HEARTBEAT };
        let infos = [&other];
        let log = [BEAT, BEAT].concat();
        let (times, tally) = found(&log, 0, &Table::of(&infos));
        assert_eq!((times.len(), tally.refused), (0, BTreeMap::from([(0, 1)])), "only where a frame is expected");
        let (_, unverified) = found(&log, 0, &Table::of(&[]));
        assert_eq!((unverified.frames, unverified.unverified), (2, 2));
    }
}
