//! The course of a flight: what the pilot does, and where that takes the vehicle.

use std::f32::consts::TAU;

use mavlink_autoquad::autoquad::AutoquadNavStatus;

/// Metres of altitude in cruise.
const CRUISE_M: f32 = 40.0;

/// Metres of the radius of the circle that is flown.
const RADIUS_M: f32 = 60.0;

/// A part of the flight. Its end is a share of the whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Phase {
    /// Disarmed on the ground.
    Parked,
    /// Motors start, then idle.
    SpoolUp,
    /// To the altitude of the cruise.
    Climb,
    /// A circle, with changes of load.
    Cruise,
    /// Back to the ground.
    Descent,
    /// Disarmed on the ground.
    Landed,
}

/// Phases, and at which share of the flight they end.
const PHASES: [(Phase, f32); 6] = [
    (Phase::Parked, 0.04),
    (Phase::SpoolUp, 0.10),
    (Phase::Climb, 0.20),
    (Phase::Cruise, 0.85),
    (Phase::Descent, 0.95),
    (Phase::Landed, f32::INFINITY),
];

/// At which share of the flight one controller fails.
pub(super) const FAILS_AT: f32 = 0.55;

/// At which share of the flight its motor begins to run heavily.
pub(super) const WEAKENS_AT: f32 = 0.45;

/// At which share of the flight one controller falls silent.
pub(super) const FALLS_SILENT_AT: f32 = 0.70;

/// The flight at one moment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moment {
    /// Of the flight; 1 and more after its end.
    pub(super) share: f32,
    pub(super) phase: Phase,
    /// What the motors are asked for, 0 to 1.
    pub(super) throttle: f32,
    pub(super) altitude_m: f32,
    pub(super) climb_mps: f32,
    /// North and east of the place of the start, in metres.
    pub(super) north_m: f32,
    pub(super) east_m: f32,
    /// Roll, pitch and yaw in radians.
    pub(super) attitude: [f32; 3],
}

impl Moment {
    /// The flight of this many seconds at a second of it.
    pub(super) fn at(second: f32, seconds: f32) -> Self {
        let share = second / seconds;
        let (phase, within) = phase(share);
        let (throttle, altitude_m, climb_mps) = match phase {
            Phase::Parked | Phase::Landed => (0.0, 0.0, 0.0),
            Phase::SpoolUp => (0.12 + 0.06 * within, 0.0, 0.0),
            Phase::Climb => (0.72, CRUISE_M * ease(within), CRUISE_M / (0.10 * seconds)),
            Phase::Cruise => (load(share, second), CRUISE_M + (second * 0.4).sin(), 0.0),
            Phase::Descent => (0.46, CRUISE_M * (1.0 - ease(within)), -CRUISE_M / (0.10 * seconds)),
        };
        let along = if phase == Phase::Cruise { within } else { 0.0 };
        let turn = TAU * along;
        let (roll, pitch) = match phase {
            Phase::Cruise => (0.18 + 0.06 * (second * 1.3).sin(), -0.08 + 0.05 * (second * 0.9).cos()),
            Phase::Climb | Phase::Descent => (0.02 * (second * 1.7).sin(), 0.03 * (second * 1.1).cos()),
            Phase::Parked | Phase::SpoolUp | Phase::Landed => (0.0, 0.0),
        };
        let yaw = (turn + TAU / 4.0 + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
        let (north_m, east_m) = (RADIUS_M * turn.sin(), RADIUS_M * (1.0 - turn.cos()));
        Self { share, phase, throttle, altitude_m, climb_mps, north_m, east_m, attitude: [roll, pitch, yaw] }
    }

    /// Whether the motors are to run.
    pub(super) fn is_armed(&self) -> bool {
        !matches!(self.phase, Phase::Parked | Phase::Landed)
    }

    /// What AutoQuad's heartbeat says of it.
    pub(super) fn nav_status(&self) -> AutoquadNavStatus {
        let mut status = match self.phase {
            Phase::Parked | Phase::Landed => AutoquadNavStatus::READY,
            Phase::SpoolUp => AutoquadNavStatus::STANDBY,
            Phase::Climb => AutoquadNavStatus::MANUAL | AutoquadNavStatus::ALTHOLD,
            Phase::Cruise => AutoquadNavStatus::MISSION,
            Phase::Descent => AutoquadNavStatus::POSHOLD | AutoquadNavStatus::RTH,
        };
        if self.share > 0.80 {
            status |= AutoquadNavStatus::FUEL_LOW;
        }
        status
    }
}

/// The phase at a share of the flight, and how far through it that is, 0 to 1.
fn phase(share: f32) -> (Phase, f32) {
    let mut start = 0.0;
    for (phase, end) in PHASES {
        if share < end {
            return (phase, ((share - start) / (end - start)).clamp(0.0, 1.0));
        }
        start = end;
    }
    (Phase::Landed, 1.0)
}

/// What a cruise asks of the motors: a steady part, gusts, and for a while hard manoeuvres.
fn load(share: f32, second: f32) -> f32 {
    let hard = if (0.28..0.42).contains(&share) { 0.22 * (second * 0.8).sin().max(0.0) } else { 0.0 };
    0.56 + 0.02 * (second * 2.1).sin() + hard
}

/// A course from 0 to 1 that starts and ends gently.
fn ease(within: f32) -> f32 {
    within * within * (3.0 - 2.0 * within)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flight_has_its_phases_in_order_and_ends_where_it_began() {
        let moments: Vec<Moment> = (0..=1200).map(|tenth| Moment::at(tenth as f32 / 10.0, 120.0)).collect();
        let mut phases: Vec<Phase> = moments.iter().map(|moment| moment.phase).collect();
        phases.dedup();
        assert_eq!(phases, PHASES.map(|(phase, _)| phase));
        assert!(moments.iter().all(|moment| (0.0..=1.0).contains(&moment.throttle) && moment.altitude_m >= 0.0));
        assert!(moments.windows(2).all(|pair| (pair[1].altitude_m - pair[0].altitude_m).abs() < 2.0));
        assert!(moments.iter().any(|moment| moment.altitude_m > 39.0));
        assert_eq!(moments.last().map(|moment| moment.altitude_m), Some(0.0));
    }
}
