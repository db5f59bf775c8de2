//! `AQ_TELEMETRY_F`: datasets of twenty numbers, as AutoQuad's later firmware fills them.

use mavlink_autoquad::autoquad::AqTelemetryF;
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

/// What one dataset says: 5 is the estimate, 6 the supervisor, 9 the motors.
pub(super) fn dataset(index: u16, moment: &Moment, measured: &Measured<'_>) -> AqTelemetryF {
    // Places as AutoQuad numbers them, from 1.
    let values: Vec<(usize, f32)> = match index {
        5 => vec![
            (11, moment.altitude_m),
            (12, moment.north_m),
            (13, moment.east_m),
            (14, -moment.altitude_m),
            (17, -moment.climb_mps),
            (18, moment.altitude_m),
            (19, moment.altitude_m),
            (20, moment.climb_mps),
        ],
        6 => vec![
            (1, state(moment.phase)),
            (2, measured.flight_us as f32 / SECOND_US as f32),
            (5, measured.battery_v),
            (8, 58.0),
            (18, measured.battery_v),
            (19, 100.0),
        ],
        _ => {
            let most_a = measured.currents_a.iter().copied().fold(1.0, f32::max);
            let motors = (1..=16).zip(measured.currents_a.iter().map(|a| a / most_a * moment.throttle * FULL));
            motors.chain([(17, moment.throttle * FULL)]).collect()
        }
    };
    let mut payload = [0; 82];
    let (numbers, rest) = payload.as_chunks_mut::<4>();
    for (place, value) in values {
        if let Some(number) = numbers.get_mut(place - 1) {
            *number = value.to_le_bytes();
        }
    }
    rest.copy_from_slice(&index.to_le_bytes());
    AqTelemetryF::decode(&payload)
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
    fn values_stand_where_autoquad_puts_them() {
        let (moment, measured) =
            (Moment::at(60.0, 120.0), Measured { battery_v: 15.5, flight_us: 3_000_000, currents_a: &[8.0, 4.0] });
        let supervisor = dataset(6, &moment, &measured);
        assert_eq!((supervisor.index, supervisor.value2, supervisor.value18), (6, 3.0, 15.5));
        let motors = dataset(9, &moment, &measured);
        assert_eq!((motors.index, motors.value1, motors.value3), (9, motors.value17, 0.0));
        assert_eq!(motors.value1, 2.0 * motors.value2);
        let estimate = dataset(5, &moment, &measured);
        assert_eq!((estimate.index, estimate.value11, estimate.value14), (5, moment.altitude_m, -moment.altitude_m));
    }
}
