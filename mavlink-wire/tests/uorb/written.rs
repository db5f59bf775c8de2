//! Logs that are written.
#![cfg(feature = "std")]

use mavlink_wire::uorb::ulog::{End, Log, Writer};

use crate::golden::{MAIN, read};
use crate::topic::EscStatus;

/// The log of the other program, from its values: the same bytes.
#[test]
fn a_log_is_written_as_another_program_writes_it() {
    let mut log = Writer::new(vec![], 123_456).topic::<EscStatus>().begin().unwrap();
    for (instance, status) in read(MAIN) {
        log.write(instance, &status).unwrap();
    }
    assert_eq!(log.finish().unwrap(), MAIN);
}

/// So does what a log says about itself: pyulog reads this one, and writes the same bytes.
#[test]
fn infos_are_written_as_another_program_writes_them() {
    let log = Writer::new(vec![], 123_456).info("sys_name", "AutoQuad").info("ver_hw", "M4").topic::<EscStatus>();
    let mut log = log.begin().unwrap();
    for (instance, status) in read(MAIN) {
        log.write(instance, &status).unwrap();
    }
    assert_eq!(log.finish().unwrap(), include_bytes!("logs/infos.ulg"));
}

#[test]
fn instances_and_infos_are_read_again() {
    let mut log = Writer::new(vec![], 5).info("sys_name", "AutoQuad").topic::<EscStatus>().begin().unwrap();
    for instance in [0, 2, 1, 2] {
        let status = EscStatus { timestamp: u64::from(instance) + 10, ..EscStatus::UNKNOWN };
        log.write(instance, &status).unwrap();
    }
    let bytes = log.finish().unwrap();
    let log = Log::new(&bytes).unwrap();
    let mut samples = log.read::<EscStatus>();
    let times: Vec<_> = samples.by_ref().map(|(instance, status)| (instance, status.timestamp)).collect();
    assert_eq!(times, [(0, 10), (2, 12), (1, 11), (2, 12)]);
    assert_eq!((samples.unreadable(), samples.end()), (0, End::Complete));
    assert!(log.records().any(|record| record.payload == b"\x10char[8] sys_nameAutoQuad"));
}

#[test]
fn a_topic_that_was_not_added_is_refused() {
    let mut log = Writer::new(vec![], 0).begin().unwrap();
    let error = log.write(0, &EscStatus::UNKNOWN).unwrap_err();
    assert_eq!(error.to_string(), "EscStatus is none of the topics of this log");
}
