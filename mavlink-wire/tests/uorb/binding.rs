//! What is bound to what, and what is not.

use mavlink_wire::uorb::ulog::{Binding, Log};

use crate::golden::V1_14;
use crate::topic::EscStatus;

/// `EscStatus` of a log with these fields.
fn status(fields: &'static str, record: &[u8]) -> Option<EscStatus> {
    Binding::of("esc_status", |name: &str| (name == "esc_status").then_some(fields))?.read(record)
}

#[test]
fn a_narrower_type_widens_and_another_is_absent() {
    let record = [0xfe, 0xff, 7, 0, 0, 0x80, 0x3f];
    let read = status("uint16_t timestamp;uint8_t counter;float esc_count;", &record).unwrap();
    assert_eq!((read.timestamp, read.counter, read.esc_count), (0xfffe, 7, 0));
}

#[test]
fn order_and_unknown_fields_do_not_matter() {
    let read = status("uint8_t[3] other;uint8_t esc_count;uint16_t counter;", &[1, 2, 3, 4, 5, 1]).unwrap();
    assert_eq!((read.esc_count, read.counter), (4, 0x105));
}

#[test]
fn a_record_must_reach_to_its_last_field_that_is_read() {
    let fields = "uint8_t esc_count;uint8_t[5] _padding0;";
    assert_eq!(status(fields, &[4]).map(|read| read.esc_count), Some(4), "padding need not be there");
    assert_eq!(status(fields, &[]), None);
}

#[test]
fn an_array_that_is_longer_than_ours_is_absent() {
    assert_eq!(status("uint8_t[2] esc_count;", &[1, 2]).map(|read| read.esc_count), Some(0));
}

#[test]
fn what_is_no_format_binds_nothing() {
    for fields in ["uint8_t", "uint8_t[x] a;", "nothing a;", "uint8_t a;b", "uint64_t[65535] a;esc_status b;"] {
        assert_eq!(status(fields, &[0; 64]), None, "{fields}");
    }
}

#[test]
fn eleven_instances_are_one_too_many() {
    let data = V1_14.len() - 2 * (3 + 2 + 336);
    let mut log = V1_14[..data - 16].to_vec();
    for id in 0..11_u8 {
        log.extend([13, 0, b'A', id, id, 1]);
        log.extend(b"esc_status");
    }
    for id in (0..11_u8).rev() {
        log.extend([82, 1, b'D', id, 1]);
        log.extend([id; 336]);
    }
    let log = Log::new(&log).unwrap();
    let mut samples = log.read::<EscStatus>();
    assert_eq!(samples.by_ref().map(|(instance, _)| instance).collect::<Vec<_>>(), [9, 8, 7, 6, 5, 4, 3, 2, 1, 0]);
    assert_eq!(samples.unreadable(), 1);
}
