//! A log as a stream of all topics that an enum has.

use std::cell::Cell;

use mavlink_wire::uorb::Topics;
use mavlink_wire::uorb::ulog::{End, Log, Logged};

use crate::golden::{MAIN, V1_14, V2026_02};
use crate::topic::{Any, EscStatus};

#[test]
fn a_stream_gives_what_reading_one_topic_gives() {
    for bytes in [MAIN, V1_14, V2026_02] {
        let log = Log::new(bytes).unwrap();
        let mut messages = log.messages::<Any>();
        let all: Vec<_> =
            messages.by_ref().map(|Logged { topic, instance, message }| (topic, instance, message)).collect();
        let alone: Vec<_> = log.read::<EscStatus>().map(|(instance, status)| (instance, Any::from(status))).collect();
        assert!(all.iter().all(|(topic, _, message)| (*topic, message.name()) == ("esc_status", "EscStatus")));
        let text = |instance: u8, message: &Any| format!("{instance} {message:?}");
        assert!(
            !all.is_empty()
                && all
                    .iter()
                    .map(|(_, i, message)| text(*i, message))
                    .eq(alone.iter().map(|(i, message)| text(*i, message)))
        );
        assert_eq!((messages.unreadable(), messages.unknown(), messages.end()), (0, 0, End::Complete));
        assert!(EscStatus::try_from(all[0].2).is_ok());
    }
}

/// A log of the definitions of another, with these records behind them.
fn log_of(records: &[(u8, Vec<u8>)]) -> Vec<u8> {
    let data = V1_14.len() - 2 * (3 + 2 + 336) - 16;
    let mut log = V1_14[..data].to_vec();
    for (kind, payload) in records {
        log.extend(u16::try_from(payload.len()).unwrap().to_le_bytes());
        log.push(*kind);
        log.extend(payload);
    }
    log
}

fn subscribed(instance: u8, id: u16, topic: &str) -> (u8, Vec<u8>) {
    (b'A', [&[instance][..], &id.to_le_bytes(), topic.as_bytes()].concat())
}

fn data(id: u16, length: usize) -> (u8, Vec<u8>) {
    (b'D', [&id.to_le_bytes()[..], &vec![id as u8; length]].concat())
}

fn read(log: &[u8]) -> (Vec<(u8, u8)>, usize, usize) {
    let log = Log::new(log).unwrap();
    let mut messages = log.messages::<Any>();
    let seen = messages.by_ref().map(|logged| match logged.message {
        Any::EscStatus(status) => (logged.instance, status.timestamp as u8),
        Any::EscReport(report) => (logged.instance, report.timestamp as u8),
    });
    (seen.collect(), messages.unreadable(), messages.unknown())
}

#[test]
fn ids_that_share_a_slot_are_told_apart() {
    let log = log_of(&[
        subscribed(0, 5, "esc_status"),
        subscribed(1, 261, "esc_status"),
        subscribed(0, 517, "something_else"),
        data(261, 336),
        data(517, 336),
        data(5, 336),
        data(773, 336),
    ]);
    assert_eq!(read(&log), (vec![(1, 5), (0, 5)], 0, 2));
}

#[test]
fn what_is_unsubscribed_or_too_short_is_counted() {
    let log = log_of(&[
        subscribed(0, 5, "esc_status"),
        subscribed(0, 6, "esc_report"),
        data(5, 300),
        data(6, 40),
        (b'R', vec![5, 0]),
        data(5, 336),
        subscribed(3, 5, "esc_status"),
        data(5, 336),
    ]);
    assert_eq!(read(&log), (vec![(0, 6), (3, 5)], 1, 1));
}

/// More subscriptions than are remembered: the first of them are read.
#[test]
fn a_log_of_many_subscriptions_is_read_as_far_as_they_are_remembered() {
    let mut records: Vec<_> = (0..300).map(|id| subscribed(0, id, "esc_status")).collect();
    records.extend((0..300).map(|id| data(id, 336)));
    let (seen, unreadable, unknown) = read(&log_of(&records));
    assert_eq!((seen.len(), unreadable, unknown), (256, 0, 44));
}

/// The formats of a log are searched once for each topic, however often a hostile log subscribes to one that has none.
#[test]
fn a_topic_without_a_format_is_looked_up_once() {
    let (searched, mut bindings) = (Cell::new(0), Any::UNBOUND);
    for _ in 0..1000 {
        let formats = |_: &str| {
            searched.set(searched.get() + 1);
            None
        };
        assert!(Any::bind(&mut bindings, "esc_status", &formats).is_some());
    }
    assert_eq!(searched.get(), 1);
}
