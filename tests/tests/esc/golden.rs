//! Frames that pymavlink made of the definitions: telemetry, and what it becomes for ground stations of today.

use mavlink_autoquad::autoquad::{
    AqEscTelemetry, Autoquad, Esc, Esc32DisarmV2, Esc32DisarmV3, Esc32State, Esc32Status,
};
use mavlink_autoquad::esc::{Conversion, DisarmReason, EscTable, ONLINE_LIMIT_MS, Update};
use mavlink_autoquad::wire::{Dialect, Frame, MAX_FRAME, Message, Sender};

const V1: &str = "fe37002abe9840e2010044afb4e134afc221282f000000000000310318013933480e0000d0cf\
                  00000000040009000700ffff01040401020304151e1f00d9ed";
const V2: &str = "fd360000002abe98000040e2010044afb4e134afc221282f000000000000310318013933480e0000d0cf\
                  00000000040009000700ffff01040401020304151e1f5ea1";
const INFO: &str = "fd2e0000002abe22010000ca5b07000000001100000000000000000000000000000001000000000020000000\
                    ff7fc409350cff7f00040407cacd";
const STATUS: &str = "fd380000002abe23010000ca5b07000000008f190000c9190000000000000000000085eb71419a997141a4707141\
                      0000c07f14ae0b41f6281041000000000000c07fbc71";

fn bytes(text: &str) -> Vec<u8> {
    let digits = text.as_bytes().chunks(2).map(|pair| str::from_utf8(pair).unwrap());
    digits.map(|pair| u8::from_str_radix(pair, 16).unwrap()).collect()
}

fn decoded(text: &str) -> AqEscTelemetry {
    Frame::parse(&bytes(text), Autoquad::TABLE).unwrap().decode().unwrap()
}

/// The message, made of values.
fn made() -> AqEscTelemetry {
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
    let mut telemetry = AqEscTelemetry { time_boot_ms: 123_456, seq: 1, num_motors: 4, ..AqEscTelemetry::DEFAULT };
    for (id, age_ms, status) in [(1, 4, one), (2, 9, two), (3, 7, three)] {
        telemetry.push_esc(Esc { id, age_ms: Some(age_ms), status: Some(status) }).unwrap();
    }
    telemetry.push_esc(Esc { id: 4, age_ms: None, status: None }).unwrap();
    telemetry
}

#[test]
fn values_are_decoded() {
    for telemetry in [decoded(V1), decoded(V2)] {
        let escs: Vec<Esc> = telemetry.escs().collect();
        assert_eq!(
            escs.iter().map(|esc| (esc.id, esc.age_ms)).collect::<Vec<_>>(),
            [(1, Some(4)), (2, Some(9)), (3, Some(7)), (4, None)]
        );
        let [Some(one), Some(two), Some(three), None] = [0, 1, 2, 3].map(|index| escs[index].status) else {
            panic!("three have a status")
        };
        assert_eq!(
            [one, two, three].map(Esc32Status::bits),
            [0x0118_0331_e1b4_af44, 0x0e48_3339_21c2_af34, 0xcfd0_0000_0000_2f28]
        );
        assert_eq!((one.state(), one.voltage(), one.current(), one.rpm()), (Esc32State::RUNNING, 15.12, 8.73, 6543));
        assert_eq!((one.voltage_mv(), one.current_ma(), one.duty_raw()), (15_120, 8_730, 128));
        assert_eq!((one.errors(), one.disarm_v2()), (Some(17), Some(Esc32DisarmV2::STARTUP)));
        assert_eq!((one.temperature(), one.disarm_v3(), one.data_version()), (None, None, 21));
        assert_eq!((two.voltage(), two.current(), two.rpm(), two.duty_raw()), (15.10, 9.01, 6601, 131));
        assert_eq!((two.temperature(), two.temperature_cdegc(), two.errors()), (Some(25.0), Some(2500), None));
        assert_eq!((three.state(), three.voltage(), three.rpm()), (Esc32State::DISARMED, 15.09, 0));
        assert_eq!((three.temperature(), three.temperature_cdegc()), (Some(31.25), Some(3125)));
        assert_eq!(DisarmReason::of(three), Some(DisarmReason::CrossingTimeout));
    }
}

#[test]
fn values_are_encoded() {
    let (made, mut buffer) = (made(), [0; MAX_FRAME]);
    assert_eq!(made, decoded(V1));
    assert_eq!(Sender::v1(42, 190).encode(&made, &mut buffer), Ok(&bytes(V1)[..]));
    assert_eq!(Sender::v2(42, 190).encode(&made, &mut buffer), Ok(&bytes(V2)[..]));
}

#[test]
fn a_ground_station_of_today_gets_these_frames() {
    let mut table = EscTable::new();
    assert_eq!(table.update(&decoded(V1)), Update::Complete);
    let now = table.uptime_us();
    let (info, status) =
        (table.to_esc_info(0, now, &Conversion::DEFAULT), table.to_esc_status(0, now, &Conversion::DEFAULT));
    let mut buffer = [0; MAX_FRAME];
    assert_eq!(Sender::v2(42, 190).encode(&info.unwrap(), &mut buffer), Ok(&bytes(INFO)[..]));
    assert_eq!(Sender::v2(42, 190).encode(&status.unwrap(), &mut buffer), Ok(&bytes(STATUS)[..]));
    assert_eq!(Conversion::DEFAULT.online_limit_ms, ONLINE_LIMIT_MS);
}
