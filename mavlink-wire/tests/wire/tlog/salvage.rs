//! What is left in logs that were cut.

use mavlink_wire::tlog::salvage::{Record, records};
use mavlink_wire::{Dialect, Encode, Message, Sender, Table};
use proptest::prelude::*;

use super::START_US;
use crate::small::{AqEscTelemetry, Heartbeat, Small};
use crate::streams::pieces::{encoded, with_checksum};

fn telemetry(number: u8) -> AqEscTelemetry {
    AqEscTelemetry {
        seq: number,
        num_in_seq: 4,
        escid: [1, 2, 3, 4],
        data0: [number.into(); 4],
        data_version: [30; 4],
        ..AqEscTelemetry::DEFAULT
    }
}

/// Bytes of a time.
const TIME: usize = 8;

/// A frame as QGroundControl wrote it: the time backwards, the frame without its last eight bytes.
fn cut(second: u64, frame: &[u8]) -> Vec<u8> {
    [&(START_US + second * 1_000_000).to_le_bytes()[..], &frame[..frame.len() - 8]].concat()
}

fn frame(number: u8) -> Vec<u8> {
    encoded(Sender::v1(42, 190), number, &telemetry(number).into())
}

/// A frame of four bytes of payload, of which not even the header is whole here.
fn short() -> Vec<u8> {
    with_checksum(vec![0xFE, 4, 0, 42, 190, 43, 1, 2, 3, 4], 132)
}

fn summary(record: &Record<'_>) -> (i64, Option<u32>, usize, usize) {
    (
        (record.time_us as i64 - START_US as i64) / 1_000_000,
        record.message_id(),
        record.payload().len(),
        record.missing(),
    )
}

#[test]
fn what_is_there_of_the_telemetry_is_given() {
    let log = [cut(0, &frame(7)), cut(1, &frame(8))].concat();
    let found: Vec<Record<'_>> = records(&log, Small::TABLE).collect();
    assert_eq!(found.iter().map(summary).collect::<Vec<_>>(), [(0, Some(152), 49, 6), (1, Some(152), 49, 6)]);
    let second = found[1];
    assert_eq!(second.sequence(), Some(8));
    assert_eq!((second.system_id(), second.component_id()), (Some(42.into()), Some(190.into())));
    // The words are there; the last two ids and all versions are not.
    let expected = AqEscTelemetry { escid: [1, 2, 0, 0], data_version: [0; 4], ..telemetry(8) };
    assert_eq!(AqEscTelemetry::decode(second.payload()), expected);
}

#[test]
fn frames_that_are_shorter_than_what_is_missing_are_records() {
    let log = [cut(0, &short()), cut(1, &frame(0)), cut(2, &short()), cut(3, &short())].concat();
    let found: Vec<_> = records(&log, Small::TABLE).map(|record| summary(&record)).collect();
    assert_eq!(found, [(0, None, 0, 4), (1, Some(152), 49, 6), (2, None, 0, 4), (3, None, 0, 4)]);
    let record = records(&log, Small::TABLE).next().unwrap();
    assert_eq!((record.sequence(), record.system_id(), record.component_id()), (Some(0), Some(42.into()), None));
}

#[test]
fn unknown_messages_and_other_lengths_need_a_record_behind_them() {
    let log = [cut(0, &frame(0)), cut(1, &frame(1)), vec![0; 3]].concat();
    let nothing = Table::of(&[]);
    assert_eq!(records(&log, &nothing).map(|record| summary(&record).0).collect::<Vec<_>>(), [0]);
    assert_eq!(records(&log, Small::TABLE).count(), 2);
}

#[test]
fn a_log_that_goes_on_years_later_is_read_on() {
    let years = 10 * 365 * 86_400;
    let log = [cut(0, &frame(0)), cut(years as u64, &frame(1)), cut(years as u64, &frame(2))].concat();
    assert_eq!(records(&log, Small::TABLE).map(|record| summary(&record).0).collect::<Vec<_>>(), [0, years, years]);
}

#[test]
fn a_known_message_of_another_time_needs_a_record_behind_it() {
    let log = [cut(0, &frame(0)), cut(86_401, &frame(1)), vec![0; 3]].concat();
    assert_eq!(records(&log, Small::TABLE).count(), 1);
}

#[test]
fn garbage_between_records_is_counted() {
    let garbage = [&[0xFE, 9, 9, 9][..], &START_US.to_le_bytes(), &[0xFD, 0xFE]].concat();
    let log = [&cut(0, &frame(0))[..], &garbage, &cut(1, &frame(1)), &garbage].concat();
    let skipped: Vec<u64> = records(&log, Small::TABLE).map(|record| record.skipped).collect();
    assert_eq!(skipped, [0, garbage.len() as u64]);
}

#[test]
fn a_damaged_length_takes_no_known_record_along() {
    let mut log: Vec<u8> = (0..4).flat_map(|number| cut(number, &frame(number as u8))).collect();
    let record = log.len() / 4;
    // The first record reaches to the end of the second, of the third, of the log.
    for records_long in 2..=4 {
        log[TIME + 1] = (records_long * record - TIME) as u8;
        let found: Vec<i64> = records(&log, Small::TABLE).map(|record| summary(&record).0).collect();
        assert_eq!(found, [1, 2, 3]);
    }
}

#[test]
fn a_tlog_has_no_records() {
    let log = super::log(&[frame(0), frame(1)]);
    let mut records = records(&log, Small::TABLE);
    assert_eq!((records.next(), records.skipped_bytes()), (None, log.len() as u64));
}

proptest! {
    #[test]
    fn damage_at_any_byte_costs_one_record(hit in any::<prop::sample::Index>(), flip in 1..=255_u8, torn in any::<bool>()) {
        let beat: Small = Heartbeat::DEFAULT.into();
        prop_assert_eq!(beat.info().len_v1, 9);
        let all: Vec<Vec<u8>> = (0..6).map(|number| cut(number, &match number % 2 {
            0 => frame(number as u8),
            _ => encoded(Sender::v1(1, 1), 0, &beat),
        })).collect();
        let mut log = all.concat();
        let hit = hit.index(log.len());
        if torn {
            log.truncate(hit);
        } else {
            log[hit] ^= flip;
        }
        let found: Vec<i64> = records(&log, Small::TABLE).map(|record| summary(&record).0).collect();
        let mut end = 0;
        for (number, record) in (0..).zip(&all) {
            let start = end;
            end += record.len();
            let whole = if torn { end <= hit } else { !(start..end).contains(&hit) };
            prop_assert!(!whole || found.contains(&number), "{} of {:?}", number, found);
        }
    }

    #[test]
    fn any_bytes_are_survived(bytes in proptest::collection::vec(crate::streams::pieces::byte(), 0..700)) {
        let mut records = records(&bytes, Small::TABLE);
        let used: u64 = records.by_ref().map(|record| record.skipped + TIME as u64).sum();
        prop_assert!(used <= bytes.len() as u64 && records.skipped_bytes() <= bytes.len() as u64);
    }
}
