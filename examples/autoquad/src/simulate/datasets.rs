//! `AQ_TELEMETRY_F`: datasets of twenty numbers, as AutoQuad's later firmware fills them.

use mavlink_autoquad::autoquad::{AqMotors, AqSupervisor, AqTelemetryF, AqUkf};
use mavlink_autoquad::wire::Message;

use super::flight::{Moment, Phase};
use crate::time::SECOND_US;

/// At full throttle, as the flight controller counts it.
const FULL: f32 = 4095.0;

/// What is measured rather than flown.
pub(super) struct Measured<'m> {
    pub(super) battery_v: f32,
    pub(super) flight_us: u64,
    pub(super) currents_a: &'m [f32],
}

/// What one dataset says: 5 is the Kalman filter, 6 the supervisor, 9 the motors.
pub(super) fn dataset(index: u16, moment: &Moment, measured: &Measured<'_>) -> AqTelemetryF {
    match index {
        5 => AqTelemetryF::DEFAULT.with_ukf(filter(moment)),
        6 => AqTelemetryF::DEFAULT.with_supervisor(supervisor(moment, measured)),
        _ => AqTelemetryF::DEFAULT.with_motors(motors(moment, measured.currents_a)),
    }
}

fn filter(moment: &Moment) -> AqUkf {
    AqUkf {
        q1: 1.0,
        altitude: moment.altitude_m,
        pos_n: moment.north_m,
        pos_e: moment.east_m,
        pos_d: -moment.altitude_m,
        vel_d: -moment.climb_mps,
        pressure_altitude: moment.altitude_m,
        alt_pos: moment.altitude_m,
        alt_vel: moment.climb_mps,
        ..AqUkf::default()
    }
}

fn supervisor(moment: &Moment, measured: &Measured<'_>) -> AqSupervisor {
    AqSupervisor {
        state: state(moment.phase),
        flight_time: measured.flight_us as f32 / SECOND_US as f32,
        voltage_filtered: measured.battery_v,
        voltage: measured.battery_v,
        idle: 58.0,
        radio_quality: 100.0,
        ..AqSupervisor::default()
    }
}

fn motors(moment: &Moment, currents_a: &[f32]) -> AqMotors {
    let most_a = currents_a.iter().copied().fold(1.0, f32::max);
    let throttle = moment.throttle * FULL;
    let motor = |port: usize| currents_a.get(port - 1).map_or(0.0, |a| a / most_a * throttle);
    AqMotors {
        motor1: motor(1),
        motor2: motor(2),
        motor3: motor(3),
        motor4: motor(4),
        motor5: motor(5),
        motor6: motor(6),
        motor7: motor(7),
        motor8: motor(8),
        motor9: motor(9),
        motor10: motor(10),
        motor11: motor(11),
        motor12: motor(12),
        motor13: motor(13),
        motor14: motor(14),
        motor15: motor(15),
        motor16: motor(16),
        throttle,
        ..AqMotors::default()
    }
}

/// AutoQuad's `supervisorStates`, one bit each: disarmed, armed, flying.
const fn state(phase: Phase) -> f32 {
    match phase {
        Phase::Parked | Phase::Landed => 2.0,
        Phase::SpoolUp => 4.0,
        Phase::Climb | Phase::Cruise | Phase::Descent => 8.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dataset_says_what_its_number_promises() {
        let currents_a = &[8.0, 4.0];
        let (moment, measured) =
            (Moment::at(60.0, 120.0), Measured { battery_v: 15.5, flight_us: 3_000_000, currents_a });
        let supervisor = dataset(6, &moment, &measured).supervisor().unwrap();
        assert_eq!((supervisor.flight_time, supervisor.voltage), (3.0, 15.5));
        let motors = dataset(9, &moment, &measured).motors().unwrap();
        assert_eq!((motors.motor1, motors.motor2, motors.motor3), (motors.throttle, motors.throttle / 2.0, 0.0));
        assert_eq!(dataset(5, &moment, &measured).ukf().unwrap().altitude, moment.altitude_m);
    }
}
