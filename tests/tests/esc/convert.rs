//! `ESC_INFO` and `ESC_STATUS`. The frames of `golden.rs` show the rest.

use mavlink_autoquad::autoquad::{Esc, Esc32Status, EscConnectionType, EscFailureFlags};
use mavlink_autoquad::esc::{Conversion, EscTable, InfoBits, Silent};

use super::{batch, cycle, running};

/// Ten motors; number 7 is silent, number 10 has not been heard of.
fn table() -> EscTable {
    let (mut table, mut batches) = (EscTable::new(), cycle(2000, 10, 1000));
    for one in &batches {
        table.update(one);
    }
    for one in &mut batches {
        one.time_boot_ms = 2100;
    }
    batches[1].set_esc(2, Esc { id: 7, age_ms: Some(1100), status: None }).unwrap();
    table.update(&batches[0]);
    table.update(&batches[1]);
    table
}

#[test]
fn there_is_a_message_for_every_four_motors() {
    let (table, options) = (table(), Conversion::DEFAULT);
    let now = table.uptime_us();
    for batch in 0..=u8::MAX {
        let (info, status) = (table.to_esc_info(batch, now, &options), table.to_esc_status(batch, now, &options));
        assert_eq!((info.is_some(), status.is_some()), (batch < 3, batch < 3));
        let (Some(info), Some(status)) = (info, status) else { continue };
        assert_eq!((info.index, status.index, info.count, info.counter), (4 * batch, 4 * batch, 10, 1));
        assert_eq!((info.time_usec, status.time_usec), (2_100_000, 2_100_000));
        assert_eq!(info.connection_type, EscConnectionType::CAN);
        assert_eq!(info.info, [0b1111, 0b1011, 0b0011][usize::from(batch)]);
    }
    assert!(EscTable::new().to_esc_info(0, 0, &options).is_none());
}

#[test]
fn info_can_mean_the_whole_vehicle() {
    let (table, options) = (table(), Conversion { info: InfoBits::Vehicle, ..Conversion::DEFAULT });
    for batch in 0..3 {
        let info = table.to_esc_info(batch, table.uptime_us(), &options).unwrap();
        assert_eq!(info.info, 0b1011_1111);
    }
}

#[test]
fn the_values_of_a_silent_controller_are_not_known_or_zero() {
    let table = table();
    let now = table.uptime_us();
    let known = table.to_esc_status(1, now, &Conversion::DEFAULT).unwrap();
    assert_eq!((known.rpm, known.voltage[1]), ([1005, 1006, 0, 1008], 15.0));
    assert!(known.voltage[2].is_nan() && known.current[2].is_nan());
    let zero = Conversion { silent: Silent::Zero, ..Conversion::DEFAULT };
    let status = table.to_esc_status(1, now, &zero).unwrap();
    assert_eq!((status.voltage[2], status.current[2]), (0.0, 0.0));
    let info = table.to_esc_info(1, now, &zero).unwrap();
    assert_eq!(info.temperature, [i16::MAX, i16::MAX, 0, i16::MAX]);
}

#[test]
fn with_time_all_are_silent() {
    let table = table();
    let later = table.uptime_us() + 1_195_000;
    let (options, patient) = (Conversion::DEFAULT, Conversion { online_limit_ms: 1201, ..Conversion::DEFAULT });
    assert_eq!(table.to_esc_info(0, later - 1, &options).unwrap().info, 0b1111);
    assert_eq!(table.to_esc_info(0, later, &options).unwrap().info, 0);
    assert_eq!(table.to_esc_info(0, later, &patient).unwrap().info, 0b1111);
}

#[test]
fn errors_stay_and_failures_go_with_the_status() {
    let mut table = EscTable::new();
    // Disarmed by low voltage, 300 errors.
    let status = Some(Esc32Status::from_bits(4 << 61 | 300 << 52 | 1100 << 3, 21));
    table.update(&batch(1000, 1, 2, &[Esc { id: 1, age_ms: Some(0), status }, running(2, 1)]));
    let info = table.to_esc_info(0, 1_000_000, &Conversion::DEFAULT).unwrap();
    assert_eq!((info.error_count[0], info.failure_flags[0], info.info), (300, EscFailureFlags::GENERIC, 0b11));
    table.update(&batch(2500, 1, 2, &[Esc { id: 1, age_ms: Some(1500), status: None }, running(2, 1)]));
    let info = table.to_esc_info(0, 2_500_000, &Conversion::DEFAULT).unwrap();
    assert_eq!((info.error_count[0], info.failure_flags[0], info.info), (300, EscFailureFlags::empty(), 0b10));
    let zero = Conversion { silent: Silent::Zero, ..Conversion::DEFAULT };
    assert_eq!(table.to_esc_info(0, 2_500_000, &zero).unwrap().error_count[0], 0);
}
