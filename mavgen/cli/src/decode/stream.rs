//! Frames out of a stream of bytes or a log, as the runtime finds them.

use std::collections::BTreeMap;
use std::io::{self, Read};

use mavlink_wire::io::FrameReader;
use mavlink_wire::{Table, tlog};

use super::received::Received;

/// Frames, with the times that a log has in front of them.
pub(super) struct Stream<'t> {
    reader: Reader<'t>,
    table: &'t Table<'t>,
    tally: Tally,
}

enum Reader<'t> {
    Frames(Box<FrameReader<'t, Box<dyn Read>>>),
    Log(Box<tlog::Reader<'t, Box<dyn Read>>>),
}

/// What was found, and what was not.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Tally {
    frames: u64,
    unverified: u64,
    skipped: u64,
    /// Messages of the table whose checksums were others.
    refused: BTreeMap<u32, u64>,
}

impl<'t> Stream<'t> {
    /// Frames, one after the other.
    pub(super) fn of_frames(input: Box<dyn Read>, table: &'t Table<'t>) -> Self {
        Self { reader: Reader::Frames(Box::new(FrameReader::new(input, table))), table, tally: Tally::default() }
    }

    /// Frames behind times.
    pub(super) fn of_log(input: Box<dyn Read>, table: &'t Table<'t>) -> Self {
        Self { reader: Reader::Log(Box::new(tlog::Reader::new(input, table))), table, tally: Tally::default() }
    }

    /// The next frame; `None` at the end.
    pub(super) fn next(&mut self) -> io::Result<Option<Received<'_>>> {
        let Self { reader, table, tally: Tally { frames, unverified, refused, .. } } = self;
        let bad_checksum = |message_id| {
            // Damage may look like the start of any message.
            if table.get(message_id).is_some() {
                *refused.entry(message_id).or_default() += 1;
            }
        };
        let received = match reader {
            Reader::Frames(reader) => {
                reader.receive_reporting_bad_checksums(bad_checksum)?.map(|frame| Received { time: None, frame })
            }
            Reader::Log(reader) => reader.read_reporting_bad_checksums(bad_checksum)?.map(Received::from),
        };
        if let Some(received) = &received {
            *frames += 1;
            *unverified += u64::from(!received.frame.is_verified());
        }
        Ok(received)
    }

    pub(super) fn tally(self) -> Tally {
        let skipped = match &self.reader {
            Reader::Frames(reader) => reader.statistics().skipped_bytes,
            Reader::Log(reader) => reader.skipped_bytes(),
        };
        Tally { skipped, ..self.tally }
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

    use super::super::received::Time;
    use super::*;

    const BEAT: [u8; 17] = [0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];

    static HEARTBEAT: MessageInfo = MessageInfo::new(0, "HEARTBEAT", 50, 9);

    /// Gives one byte at a time.
    struct Slow(io::Cursor<Vec<u8>>);

    impl Read for Slow {
        fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
            self.0.read(bytes.get_mut(..1).unwrap_or_default())
        }
    }

    fn found(bytes: &[u8], is_log: bool, table: &Table<'_>) -> (Vec<Option<Time>>, Tally) {
        let read = |input: Box<dyn Read>| {
            let mut stream = if is_log { Stream::of_log(input, table) } else { Stream::of_frames(input, table) };
            let mut times = Vec::new();
            while let Some(received) = stream.next().unwrap() {
                times.push(received.time);
            }
            (times, stream.tally())
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
        assert_eq!(found(&log, true, &Table::of(&infos)), (times, tally(3, 0)));
    }

    #[test]
    fn what_is_no_frame_is_counted() {
        let infos = [&HEARTBEAT];
        let table = Table::of(&infos);
        let noisy = [&[1, 2, 0xfe][..], &BEAT, &[0xfe, 1], &BEAT, &[0xfd]].concat();
        assert_eq!(found(&noisy, false, &table), (vec![None, None], tally(2, 6)));
        assert_eq!(found(&[], true, &table), (vec![], tally(0, 0)));
        assert_eq!(found(&[0; 9_999], true, &table), (vec![], tally(0, 9_999)));
    }

    #[test]
    fn other_definitions_are_counted_by_message() {
        let other = MessageInfo::new(0, "HEARTBEAT", 51, 9);
        let infos = [&other];
        let table = Table::of(&infos);
        let timed = [&[0; 8][..], &BEAT].concat();
        for (stream, is_log) in [(BEAT.repeat(3), false), (timed.repeat(3), true)] {
            let (times, tally) = found(&stream, is_log, &table);
            assert_eq!((times.len(), tally.refused), (0, BTreeMap::from([(0, 3)])));
            let (_, unverified) = found(&stream, is_log, &Table::of(&[]));
            assert_eq!((unverified.frames, unverified.unverified), (3, 3));
        }
    }
}
