//! AutoQuad's telemetry to PX4's `EscStatus`, and that to MAVLink, as AutoQuad's telemetry goes there itself.

use mavlink_autoquad::autoquad::{AqEscTelemetry, Esc, Esc32DisarmV3, Esc32State, Esc32Status, EscInfo};
use mavlink_autoquad::esc::{Conversion, EscTable, Silent};
use mavlink_autoquad::px4::{EscConnectionType, EscReport, EscStatus, Order, ToMavlink};
use mavlink_autoquad::wire::Message;
use mavlink_conformance::random::Random;
use mavlink_wire::uorb::Topic;

use super::vectors::{ESC_STATUS, vectors};

/// Four controllers, of which the last has not been heard.
fn telemetry(time_boot_ms: u32) -> AqEscTelemetry {
    let mut one = Esc32Status::from_bits(0, 21);
    one.set_state(Esc32State::RUNNING).unwrap();
    one.set_voltage(15.12).unwrap();
    one.set_current(8.73).unwrap();
    one.set_rpm(6543).unwrap();
    one.set_duty_raw(128);
    one.set_errors(17).unwrap();
    let mut two = Esc32Status::from_bits(0, 30);
    two.set_state(Esc32State::RUNNING).unwrap();
    two.set_voltage(15.10).unwrap();
    two.set_current(9.01).unwrap();
    two.set_rpm(6601).unwrap();
    two.set_duty_raw(131);
    two.set_temperature(25.0).unwrap();
    let mut three = Esc32Status::from_bits(0, 31);
    three.set_voltage(15.09).unwrap();
    three.set_temperature(31.25).unwrap();
    three.set_disarm_v3(Esc32DisarmV3::CROSSING_TIMEOUT).unwrap();
    let mut telemetry = AqEscTelemetry { time_boot_ms, seq: 1, num_motors: 4, ..AqEscTelemetry::DEFAULT };
    for (id, age_ms, status) in
        [(1, Some(4), Some(one)), (4, Some(9), Some(two)), (2, Some(7), Some(three)), (3, None, None)]
    {
        telemetry.push_esc(Esc { id, age_ms, status }).unwrap();
    }
    telemetry
}

/// After seven cycles.
fn table() -> EscTable {
    let mut table = EscTable::new();
    for cycle in 1..=7 {
        table.update(&telemetry(123_456 - 70 + 10 * cycle));
    }
    table
}

fn to_px4(table: &EscTable) -> EscStatus {
    table.to_px4(table.uptime_us(), &Conversion::DEFAULT)
}

#[test]
fn telemetry_becomes_what_rosbags_makes_of_it() {
    let status = to_px4(&table());
    let mut compared = 0;
    for vectors in vectors(ESC_STATUS) {
        let definition =
            EscStatus::DEFINITIONS.iter().find(|definition| definition.name == vectors.definition).unwrap();
        let (_, payload, _) = vectors.values.iter().find(|(name, ..)| *name == "autoquad").unwrap();
        assert_eq!(status.to_cdr(definition, &mut [0; 512]).unwrap(), payload, "{}", definition.name);
        compared += 1;
    }
    assert_eq!(compared, 3);
}

#[test]
fn motors_are_what_is_reported() {
    let status = to_px4(&table());
    let motors: Vec<_> = status.motors().map(|motor| (motor.number, motor.slot, motor.online, motor.armed)).collect();
    let expected =
        [(Some(1), 0, true, true), (Some(2), 1, true, true), (Some(3), 2, true, false), (Some(4), 3, false, false)];
    assert_eq!(motors, expected);
    assert_eq!(EscStatus::UNKNOWN.motors().count(), 0);

    // Before 2019-08, logs did not say who answers.
    let mut old = EscStatus { esc_count: 2, ..EscStatus::UNKNOWN };
    old.esc[1].esc_voltage = 12.0;
    old.esc[2].esc_voltage = 12.0;
    assert_eq!(old.motors().map(|motor| motor.slot).collect::<Vec<_>>(), [1]);

    // In real logs: places in another order than motors, outputs that drive no motor, and reports that do not say what they drive.
    let mut odd = EscStatus { esc_online_flags: 0b10_1111, ..EscStatus::UNKNOWN };
    for (slot, function) in [102, 104, 101, 45, 113, 0].into_iter().enumerate() {
        odd.esc[slot].actuator_function = function;
    }
    let numbers: Vec<_> = odd.motors().map(|motor| (motor.number, motor.online)).collect();
    let expected = [(Some(2), true), (Some(4), true), (Some(1), true), (None, true), (None, false), (None, true)];
    assert_eq!(numbers, expected);
}

/// NaN is not equal to itself; its text is.
fn text(message: &impl std::fmt::Debug) -> String {
    format!("{message:?}")
}

/// A table of any controllers, some of them silent or never heard.
fn any_table(random: &mut Random) -> EscTable {
    let mut table = EscTable::new();
    let below = |random: &mut Random, limit: u64| random.number() % limit;
    let num_motors = 1 + below(random, 12) as u8;
    for cycle in 1..=3 {
        for seq in 1..=num_motors.div_ceil(4) {
            let time_boot_ms = 100_000 + 900 * cycle;
            let mut telemetry = AqEscTelemetry { time_boot_ms, seq, num_motors, ..AqEscTelemetry::DEFAULT };
            for id in 4 * seq - 3..=(4 * seq).min(num_motors) {
                let version = [20, 21, 30, 31][below(random, 4) as usize];
                let status = Esc32Status::from_bits(random.number() | 1, version);
                let status = (below(random, 4) > 0).then_some(status);
                let age_ms = status.map(|_| below(random, 3000) as u16);
                telemetry.push_esc(Esc { id, age_ms, status }).unwrap();
            }
            // Of some batches nothing is heard.
            if below(random, 5) > 0 {
                table.update(&telemetry);
            }
        }
    }
    table
}

#[test]
fn by_way_of_px4_mavlink_gets_the_same() {
    let mut random = Random::new(152);
    let tables = std::iter::once(table()).chain(std::iter::repeat_with(|| any_table(&mut random)));
    let (mut infos, mut online) = (0, 0);
    for table in tables.take(2_000).filter(|table| table.num_motors() > 0) {
        for silent in [Silent::Unknown, Silent::Zero] {
            let conversion = Conversion { silent, ..Conversion::DEFAULT };
            let now_us = table.uptime_us();
            let status = table.to_px4(now_us, &conversion);
            // A message with room behind the last motor: PX4 has nothing there, and so cannot say zeros.
            let batches = if silent == Silent::Zero { table.num_motors() / 4 } else { 4 };
            for batch in 0..batches {
                let info = table.to_esc_info(batch, now_us, &conversion);
                assert_eq!(text(&status.to_esc_info(batch, &ToMavlink::DEFAULT)), text(&info));
                let speeds = table.to_esc_status(batch, now_us, &conversion);
                assert_eq!(text(&status.to_esc_status(batch, &ToMavlink::DEFAULT)), text(&speeds));
                infos += usize::from(info.is_some());
                online += info.map_or(0, |info| info.info.count_ones());
            }
        }
    }
    assert!(infos > 3_000 && online > 3_000, "{infos} {online}");
}

#[test]
fn indices_are_of_motors_or_of_places() {
    let mut status = EscStatus { esc_online_flags: 0b11, esc_count: 2, ..EscStatus::UNKNOWN };
    status.esc_connectiontype = EscConnectionType::DSHOT;
    status.esc[0] = EscReport { actuator_function: 105, esc_rpm: 5, ..EscReport::UNKNOWN };
    status.esc[1] = EscReport { actuator_function: 102, esc_rpm: 2, esc_temperature: -7.25, ..EscReport::UNKNOWN };
    let info = |batch, order| -> Option<EscInfo> { status.to_esc_info(batch, &ToMavlink { order }) };
    let speeds =
        |batch, order| status.to_esc_status(batch, &ToMavlink { order }).map(|status| (status.index, status.rpm));
    assert_eq!(speeds(0, Order::Motor), Some((0, [0, 2, 0, 0])));
    assert_eq!(speeds(1, Order::Motor), Some((4, [5, 0, 0, 0])));
    assert_eq!((speeds(2, Order::Motor), speeds(200, Order::Motor)), (None, None));
    assert_eq!((speeds(0, Order::Slot), speeds(1, Order::Slot)), (Some((0, [5, 2, 0, 0])), None));
    let motors = info(0, Order::Motor).unwrap();
    assert_eq!(
        (motors.info, motors.temperature, motors.connection_type.0),
        (0b10, [i16::MAX, -725, i16::MAX, i16::MAX], 5)
    );
}

#[test]
fn failures_go_bit_by_bit_and_temperatures_stop_at_their_ends() {
    let mut status = EscStatus { esc_online_flags: 0xf, ..EscStatus::UNKNOWN };
    for (i, temperature) in [400.0, -400.0, 20.125, f32::INFINITY].into_iter().enumerate() {
        status.esc[i].actuator_function = 101 + i as u8;
        status.esc[i].esc_temperature = temperature;
        status.esc[i].failures = mavlink_autoquad::px4::EscFailures::from_bits_retain(0x8200 >> i);
    }
    let info = status.to_esc_info(0, &ToMavlink::DEFAULT).unwrap();
    assert_eq!(info.temperature, [i16::MAX, i16::MIN, 2013, i16::MAX]);
    assert_eq!(info.failure_flags.map(|flags| flags.bits()), [0x8200, 0x4100, 0x2080, 0x1040]);
}
