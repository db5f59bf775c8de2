//! Logs, whole and damaged.

mod salvage;

use mavlink_wire::tlog::{MAX_ENTRY, encode, entries};
use mavlink_wire::{Dialect, Frame, Message, Sender};
use proptest::prelude::*;

use crate::small::{AqEscTelemetry, Heartbeat, Small};
use crate::streams::pieces::{Piece, encoded, with_checksum};

/// The beginning of the log.
const START_US: u64 = 1_700_000_000_000_000;

fn known(number: u8) -> Vec<u8> {
    encoded(Sender::v2(1, 1), number, &AqEscTelemetry { seq: number, ..AqEscTelemetry::DEFAULT }.into())
}

fn unknown(payload: &[u8]) -> Vec<u8> {
    Piece::Unknown { id: 70_000, crc_extra: 7, payload: payload.to_vec() }.bytes(0)
}

fn entry(time_us: u64, frame: &[u8]) -> Vec<u8> {
    [&time_us.to_be_bytes()[..], frame].concat()
}

/// A log of these frames, one a second.
fn log(frames: &[Vec<u8>]) -> Vec<u8> {
    frames.iter().zip(0..).flat_map(|(frame, second)| entry(START_US + second * 1_000_000, frame)).collect()
}

fn times(log: &[u8]) -> Vec<Option<u64>> {
    entries(log, Small::TABLE).map(|entry| entry.time_us).collect()
}

/// Times since the beginning in seconds, the least number for none, and frames.
fn found(log: &[u8]) -> Vec<(i64, Vec<u8>)> {
    let seconds = |time_us: Option<u64>| time_us.map_or(i64::MIN, |us| (us as i64 - START_US as i64) / 1_000_000);
    let found: Vec<_> =
        entries(log, Small::TABLE).map(|entry| (seconds(entry.time_us), entry.frame.bytes().to_vec())).collect();
    #[cfg(feature = "std")]
    assert_eq!(found, files::read(log).iter().map(|(us, frame)| (seconds(*us), frame.clone())).collect::<Vec<_>>());
    found
}

#[test]
fn times_and_frames_come_back() {
    let frames = [known(0), unknown(&[1, 2, 3]), unknown(&known(9)), known(1)];
    let expected: Vec<_> = (0..).zip(frames.clone()).collect();
    assert_eq!(found(&log(&frames)), expected);
    assert_eq!(found(&[]), []);
}

#[test]
fn a_gap_of_years_between_entries_is_a_gap() {
    let log = [entry(0, &known(0)), entry(START_US, &unknown(&[1])), entry(7, &known(1))].concat();
    assert_eq!(times(&log), [0, START_US, 7].map(Some));
}

#[test]
fn garbage_costs_nothing_but_itself() {
    let garbage = [0xFD, 200, 0, 1, 2, 3, 0xFE, 5, 9];
    let log =
        [&entry(START_US, &known(0))[..], &garbage, &entry(START_US, &unknown(&[1])), &garbage, &[7; 300]].concat();
    let log = [&log[..], &entry(START_US, &known(1)), &known(2)[..9]].concat();
    let mut entries = entries(&log, Small::TABLE);
    let skipped: Vec<u64> = entries.by_ref().map(|entry| entry.skipped).collect();
    assert_eq!(skipped, [0, 9, 309]);
    assert_eq!(entries.skipped_bytes(), 327);
    assert_eq!(found(&log).len(), 3);
}

#[test]
fn behind_damage_the_time_before_stands_for_one_that_cannot_be() {
    let mut log = log(&[known(0), known(1), known(2)]);
    let second = 8 + known(0).len();
    log[second + 10] ^= 0xFF;
    let third = second + 8 + known(1).len();
    log[third] ^= 0xFF;
    assert_eq!(found(&log), [(0, known(0)), (0, known(2))]);
    // Without one before, there is none.
    assert_eq!(times(&log[second..]), [None]);
}

#[test]
fn a_frame_without_a_time_makes_those_behind_it_no_less_plausible() {
    let damage = [1; 3];
    let log = [&damage[..], &entry(7, &known(0)), &damage, &entry(START_US, &known(1)), &entry(7, &known(2))].concat();
    assert_eq!(times(&log), [None, Some(START_US), Some(7)]);
}

#[test]
fn behind_damage_an_unknown_frame_needs_a_plausible_time() {
    let false_frame = unknown(&[1, 2, 3]);
    let log = [&entry(START_US, &known(0))[..], &[1; 9], &false_frame, &entry(START_US, &known(1))].concat();
    assert_eq!(found(&log), [(0, known(0)), (0, known(1))]);
}

#[test]
fn logs_have_neither_signatures_nor_keys() {
    let mut buffer = [0; MAX_ENTRY];
    let signed = Piece::Signed(Heartbeat::DEFAULT.into()).bytes(3);
    let frame = Frame::parse(&signed, Small::TABLE).unwrap();
    let written = encode(START_US, &frame, &mut buffer).unwrap();
    assert_eq!(written, entry(START_US, &encoded(Sender::v2(1, 2), 3, &Heartbeat::DEFAULT.into())));
    let key = with_checksum(vec![0xFD, 1, 0, 0, 0, 1, 1, 0, 1, 0, 7], 71);
    assert_eq!(encode(START_US, &Frame::parse(&key, Small::TABLE).unwrap(), &mut buffer), None);
}

proptest! {
    #[test]
    fn damage_at_any_byte_costs_one_entry(hit in any::<prop::sample::Index>(), flip in 1..=255_u8, torn in any::<bool>()) {
        let frames: Vec<_> = (0..6).map(known).collect();
        let mut log = log(&frames);
        let hit = hit.index(log.len());
        if torn {
            log.truncate(hit);
        } else {
            log[hit] ^= flip;
        }
        let found = found(&log);
        let mut end = 0;
        for (number, frame) in (0..).zip(&frames) {
            let start = end;
            end += 8 + frame.len();
            let whole = if torn { end <= hit } else { !(start..end).contains(&hit) };
            prop_assert!(!whole || found.contains(&(number, frame.clone())), "{number} of {found:?}");
        }
    }

    #[test]
    fn any_bytes_are_survived(bytes in proptest::collection::vec(crate::streams::pieces::byte(), 0..700)) {
        let mut entries = entries(&bytes, Small::TABLE);
        let used: usize = entries.by_ref().map(|entry| 8 + entry.frame.bytes().len()).sum();
        prop_assert_eq!(used as u64 + entries.skipped_bytes(), bytes.len() as u64);
        found(&bytes);
    }
}

/// Files on a disk.
#[cfg(feature = "std")]
mod files {
    use std::fs::File;
    use std::io::{BufWriter, ErrorKind, Read, Seek};

    use mavlink_wire::tlog::{Reader, Writer};

    use super::*;

    /// Gives few bytes at once, and an interruption now and then.
    struct Slow<'b>(&'b [u8], usize);

    impl Read for Slow<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
            self.1 += 1;
            let limit = (self.1 * 7 % 40 + 1).min(buffer.len());
            match self.1 % 5 {
                0 => Err(ErrorKind::Interrupted.into()),
                _ => self.0.read(&mut buffer[..limit]),
            }
        }
    }

    pub(super) fn read(log: &[u8]) -> Vec<(Option<u64>, Vec<u8>)> {
        let (mut reader, mut found) = (Reader::new(Slow(log, 0), Small::TABLE), vec![]);
        while let Some(entry) = reader.read().unwrap() {
            found.push((entry.time_us, entry.frame.bytes().to_vec()));
        }
        let used: usize = found.iter().map(|(_, frame)| 8 + frame.len()).sum();
        assert_eq!(reader.skipped_bytes() + used as u64, log.len() as u64);
        found
    }

    #[test]
    fn a_file_is_written_and_read() {
        let mut file: File = tempfile::tempfile().unwrap();
        let frames: Vec<_> = (0..200).map(known).collect();
        let mut writer = Writer::new(BufWriter::new(&file));
        for (frame, second) in frames.iter().zip(0..) {
            writer.write(START_US + second, &Frame::parse(frame, Small::TABLE).unwrap()).unwrap();
        }
        writer.flush().unwrap();
        drop(writer);
        file.rewind().unwrap();
        let (mut reader, mut found) = (Reader::new(&file, Small::TABLE), vec![]);
        while let Some(entry) = reader.read().unwrap() {
            found.push((entry.time_us.unwrap() - START_US, entry.frame.bytes().to_vec()));
        }
        assert_eq!(found, (0..).zip(frames).collect::<Vec<_>>());
    }
}
