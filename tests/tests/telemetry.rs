//! AQ_TELEMETRY_F: the datasets of AutoQuad's firmware by name, in frames that pymavlink made.

use mavlink_autoquad::autoquad::{AqGimbal, AqGps, AqImu, AqLegacy1, AqLegacyGps, AqTelemetryF, Autoquad};
use mavlink_wire::{Dialect, MAX_FRAME, Message, Parser, Sender};

/// Dataset 4: what [`GPS`] says.
const GPS_FRAME: &str = "fd510000002abe9600000000a03f0000403f0000003f000060400000c0bf00001040000000be00401c4700409c\
    460000c03f00003e42000004410000e03f004087430040ce4380cba44d0000000000000000000000000000000004c85d";

/// Dataset 0, of old firmware.
const LEGACY_FRAME: &str = "fd500000002abe9600000000c03f000020c0000087430000000000000000000000000000000000000000000000\
    000000000000000000000000000000000000000000000000000000000000003c41000020410000a0c10000f4c11153";

const GPS: AqGps = AqGps {
    pdop: 1.25,
    tdop: 0.75,
    speed_accuracy: 0.5,
    course_accuracy: 3.5,
    vel_n: -1.5,
    vel_e: 2.25,
    vel_d: -0.125,
    pos_age: 40_000.0,
    message_age: 20_000.0,
    vertical_accuracy: 1.5,
    lat: 47.5,
    lon: 8.25,
    horizontal_accuracy: 1.75,
    heading: 270.5,
    height: 412.5,
    itow: 345_600_000.0,
};

fn bytes(hex: &str) -> Vec<u8> {
    (0..hex.len()).step_by(2).map(|at| u8::from_str_radix(&hex[at..at + 2], 16).unwrap()).collect()
}

fn received(hex: &str) -> AqTelemetryF {
    let (mut parser, bytes) = (Parser::new(Autoquad::TABLE), bytes(hex));
    parser.next(&mut bytes.as_slice()).unwrap().decode().unwrap()
}

#[test]
fn a_dataset_is_read_by_name() {
    let telemetry = received(GPS_FRAME);
    assert_eq!((telemetry.gps(), telemetry.ukf(), telemetry.legacy1()), (Some(GPS), None, None));
    let legacy = telemetry.legacy_gps().unwrap();
    let times = (legacy.pos_time, legacy.message_time);
    assert_eq!((legacy.pdop, times), (1.25, (40_000.0, 20_000.0)), "old firmware sends times, not ages");

    let legacy = AqLegacy1 {
        roll: 1.5,
        pitch: -2.5,
        yaw: 270.0,
        voltage: 11.75,
        pos_n: 10.0,
        pos_e: -20.0,
        pos_d: -30.5,
        ..AqLegacy1::default()
    };
    assert_eq!(received(LEGACY_FRAME).legacy1(), Some(legacy));
    assert_eq!(received(LEGACY_FRAME).gps(), None);
}

#[test]
fn a_simulator_sends_a_dataset() {
    let mut buffer = [0; MAX_FRAME];
    let sent = Sender::v2(42, 190).encode(&AqTelemetryF::DEFAULT.with_gps(GPS), &mut buffer).unwrap().to_vec();
    assert_eq!(sent, bytes(GPS_FRAME));
}

/// Every dataset has another index, but for those that are another in old firmware.
#[test]
fn indices() {
    let indices = [
        (AqTelemetryF::DEFAULT.with_gps(GPS), 4),
        (AqTelemetryF::DEFAULT.with_legacy_gps(AqLegacyGps::default()), 4),
        (AqTelemetryF::DEFAULT.with_imu(AqImu { pressure: 1.0, ..AqImu::default() }), 12),
        (AqTelemetryF::DEFAULT.with_gimbal(AqGimbal::default()), 8),
    ];
    for (telemetry, index) in indices {
        assert_eq!(telemetry.index, index);
    }
    assert_eq!(indices[2].0.value20, 1.0, "the values between are not in use");
}

/// The index, and the first and last value, of each dataset, as the firmware's `switch` has them.
#[test]
fn layout() {
    let ramp = |index: u16| {
        let mut payload = [0; 82];
        (0..20_u8).for_each(|at| {
            let at = usize::from(at);
            payload[4 * at..4 * at + 4].copy_from_slice(&(at as f32 + 1.0).to_le_bytes());
        });
        payload[80..].copy_from_slice(&index.to_le_bytes());
        AqTelemetryF::decode(&payload)
    };
    let ukf = ramp(5).ukf().unwrap();
    assert_eq!((ukf.q1, ukf.altitude, ukf.pos_n, ukf.vel_d, ukf.alt_vel), (7.0, 11.0, 12.0, 17.0, 20.0));
    let supervisor = ramp(6).supervisor().unwrap();
    let voltages = (supervisor.voltage_filtered, supervisor.voltage);
    assert_eq!((voltages, supervisor.idle, supervisor.radio_errors), ((5.0, 18.0), 8.0, 20.0));
    let stacks = ramp(7).stacks().unwrap();
    assert_eq!(
        (stacks.init, stacks.dimu, stacks.cyrf, stacks.heap_used, stacks.ccm_used),
        (1.0, 10.0, 11.0, 18.0, 20.0)
    );
    let gimbal = ramp(8).gimbal().unwrap();
    assert_eq!((gimbal.pitch_pwm, gimbal.tilt, gimbal.trigger_count), (1.0, 6.0, 11.0));
    let motors = ramp(9).motors().unwrap();
    assert_eq!((motors.motor1, motors.motor16, motors.throttle, motors.yaw), (1.0, 16.0, 17.0, 20.0));
    assert_eq!(ramp(10).motors_pwm().unwrap().port14, 14.0);
    let nav = ramp(11).nav().unwrap();
    assert_eq!((nav.hold_heading, nav.pressure_altitude_offset, nav.update_age, nav.fix_type), (1.0, 11.0, 19.0, 20.0));
    let imu = ramp(12).imu().unwrap();
    assert_eq!((imu.mag_z, imu.temperature, imu.update_age, imu.pressure), (12.0, 13.0, 14.0, 20.0));
    let debug = ramp(13).debug().unwrap();
    assert_eq!((debug.int10, debug.float1, debug.float10), (10.0, 11.0, 20.0));
    let rc = ramp(14).rc().unwrap();
    assert_eq!((rc.altitude_hold, rc.waypoint_record, rc.camera_trigger, rc.passthrough), (5.0, 12.0, 18.0, 20.0));
    let config = ramp(15).config().unwrap();
    assert_eq!((config.param1_id, config.param1_value, config.param6_value), (1.0, 2.0, 12.0));
    assert_eq!(ramp(16).imu2().unwrap().mag_z, 9.0);

    let legacy1 = ramp(0).legacy1().unwrap();
    assert_eq!((legacy1.mag_z, legacy1.hold_heading, legacy1.voltage, legacy1.pos_d), (12.0, 13.0, 17.0, 20.0));
    let legacy2 = ramp(1).legacy2().unwrap();
    let remaining = (legacy2.flight_time_remaining, legacy2.radio_errors);
    assert_eq!((legacy2.pdop, legacy2.hold_course, legacy2.vel_n, remaining), (6.0, 7.0, 12.0, (19.0, 20.0)));
    let legacy3 = ramp(2).legacy3().unwrap();
    assert_eq!((legacy3.aux2, legacy3.motor1, legacy3.motor14), (6.0, 7.0, 20.0));
    assert_eq!(ramp(4).legacy_gps().unwrap().message_time, 9.0);
    assert_eq!(ramp(5).legacy_ukf().unwrap().q4, 10.0);
    let supervisor = ramp(6).legacy_supervisor().unwrap();
    assert_eq!((supervisor.soc, supervisor.last_good_radio), (6.0, 7.0));
    assert_eq!(ramp(7).legacy_stacks().unwrap().dimu, 10.0);
}
