//! What is bound to what, and what is not.

use mavlink_wire::uorb::ulog::{Binding, Log};

use crate::golden::V1_14;
use crate::topic::{EscReport, EscStatus};

/// `EscReport` of a log with these fields.
fn report(fields: &'static str, record: &[u8]) -> Option<EscReport> {
    Binding::of("esc_report", |name: &str| (name == "esc_report").then_some(fields))?.read(record)
}

#[test]
fn a_narrower_type_widens_and_another_is_absent() {
    let record = [0xfe, 0xff, 7, 0, 0, 0x80, 0x3f];
    let read = report("int16_t esc_rpm;uint8_t failures;float actuator_function;", &record).unwrap();
    assert_eq!((read.esc_rpm, read.failures, read.actuator_function), (-2, 7, 0));
}

#[test]
fn order_and_unknown_fields_do_not_matter() {
    let read = report("uint8_t[3] other;uint8_t esc_address;int8_t esc_power;", &[1, 2, 3, 4, 0xff]).unwrap();
    assert_eq!((read.esc_address, read.esc_power), (4, -1));
}

#[test]
fn a_record_must_reach_to_its_last_field_that_is_read() {
    let fields = "uint8_t esc_address;uint8_t[5] _padding0;";
    assert_eq!(report(fields, &[4]).map(|read| read.esc_address), Some(4), "padding need not be there");
    assert_eq!(report(fields, &[]), None);
}

#[test]
fn an_array_that_is_longer_than_ours_is_absent() {
    assert_eq!(report("uint8_t[2] esc_address;", &[1, 2]).map(|read| read.esc_address), Some(0));
}

#[test]
fn what_is_no_format_binds_nothing() {
    for fields in ["uint8_t", "uint8_t[x] a;", "nothing a;", "uint8_t a;b", "uint64_t[65535] a;esc_report b;"] {
        assert_eq!(report(fields, &[0; 64]), None, "{fields}");
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
