//! One motor with its ESC32 controller.

use fastrand::Rng;
use mavlink_autoquad::autoquad::{Esc, Esc32DisarmV2, Esc32DisarmV3, Esc32State, Esc32Status};
use mavlink_autoquad::wire::ViewError;

/// At full throttle, in rpm.
const MAX_RPM: f32 = 9_200.0;

/// At full speed, in amperes.
const MAX_CURRENT_A: f32 = 24.0;

/// Of the air, in °C.
const AMBIENT_C: f32 = 24.0;

/// Since when the flight controller takes the words of a controller for void, in ms.
const VOID_MS: u32 = 1000;

/// Up to when it reports the age of a status, in ms.
const OLDEST_MS: u32 = 3000;

/// How a controller does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Health {
    Sound,
    /// The motor runs heavily and draws more than the others.
    Weak,
    /// It has given up.
    Failed,
}

/// A motor, its controller, and what the flight controller last heard of it.
#[derive(Clone, Debug)]
pub(super) struct Motor {
    /// Motor port, 1 to 16.
    pub(super) port: u8,
    pub(super) health: Health,
    pub(super) silent: bool,
    state: Esc32State,
    rpm: f32,
    current_a: f32,
    voltage_v: f32,
    temperature_c: f32,
    duty: f32,
    errors: f32,
    silent_ms: u32,
    /// This motor is not quite like the others.
    trim: f32,
}

impl Motor {
    pub(super) fn new(port: u8, rng: &mut Rng) -> Self {
        Self {
            port,
            health: Health::Sound,
            silent: false,
            state: Esc32State::DISARMED,
            rpm: 0.0,
            current_a: 0.0,
            voltage_v: 16.8,
            temperature_c: AMBIENT_C + noise(rng),
            duty: 0.0,
            errors: 0.0,
            silent_ms: 0,
            trim: 1.0 + 0.05 * noise(rng),
        }
    }

    /// In amperes.
    pub(super) const fn current_a(&self) -> f32 {
        self.current_a
    }

    /// Goes on for some seconds with this throttle, 0 to 1; `None` if disarmed.
    pub(super) fn step(&mut self, throttle: Option<f32>, battery_v: f32, seconds: f32, rng: &mut Rng) {
        let throttle = throttle.filter(|_| self.health != Health::Failed);
        let target = MAX_RPM * self.trim * throttle.unwrap_or_default().clamp(0.0, 1.0).sqrt() * battery_v / 16.0;
        // Propellers are slower to stop than to start.
        let inertia_s = if target > self.rpm { 0.12 } else { 0.45 };
        self.rpm += (target - self.rpm) * (seconds / inertia_s).min(1.0);
        self.state = match throttle {
            None => Esc32State::DISARMED,
            Some(_) if self.rpm < 900.0 => Esc32State::STARTING,
            Some(_) => Esc32State::RUNNING,
        };
        let friction = if self.health == Health::Weak { 1.45 } else { 1.0 };
        let drawn = match throttle {
            Some(_) => 0.4 + MAX_CURRENT_A * friction * (self.rpm / MAX_RPM).powi(3),
            None => 0.0,
        };
        self.current_a = (drawn * (1.0 + 0.02 * noise(rng))).max(0.0);
        self.duty = throttle.map_or(0.0, |throttle| (100.0 * throttle.sqrt()).clamp(0.0, 100.0));
        self.voltage_v = battery_v - 0.008 * self.current_a + 0.015 * noise(rng);
        let warm = AMBIENT_C + 0.28 * self.current_a.powi(2);
        self.temperature_c += (warm - self.temperature_c) * seconds / 25.0;
        // A missed zero crossing now and then, and many where the motor is weak.
        let rate = if self.health == Health::Weak { 4.0 } else { 0.02 };
        if throttle.is_some() && rng.f32() < rate * seconds {
            self.errors = (self.errors + 1.0).min(511.0);
        }
        self.silent_ms = if self.silent { self.silent_ms.saturating_add((seconds * 1000.0) as u32) } else { 0 };
    }

    /// What the flight controller reports of it.
    pub(super) fn report(&self) -> Result<Esc, ViewError> {
        // Telemetry comes a hundred times a second.
        let age_ms = self.silent_ms + u32::from(self.port) % 10;
        let age = u16::try_from(age_ms).ok().filter(|_| age_ms <= OLDEST_MS);
        let status = if age_ms > VOID_MS { None } else { Some(self.status()?) };
        Ok(Esc { id: self.port, age_ms: age, status })
    }

    /// Every fourth has firmware 2.1, which counts errors; the others have 3.0, which measures the temperature.
    fn status(&self) -> Result<Esc32Status, ViewError> {
        let (failed, counts) = (self.health == Health::Failed, self.port.is_multiple_of(4));
        let status = Esc32Status::from_bits(0, if counts { 21 } else { 30 })
            .with_state(self.state)?
            .with_voltage(self.voltage_v.clamp(0.01, 40.95))?
            .with_current(self.current_a.clamp(0.0, 163.83))?
            .with_rpm(self.rpm.round() as u16)?
            .with_duty(self.duty)?;
        match (counts, self.state == Esc32State::DISARMED) {
            (true, false) => status.with_errors(self.errors as u16),
            (true, true) => {
                let reason = if failed { Esc32DisarmV2::BAD_DETECTS } else { Esc32DisarmV2::STARTUP };
                status.with_errors(self.errors as u16)?.with_disarm_v2(reason)
            }
            (false, false) => status.with_temperature(self.temperature_c.clamp(-32.0, 95.75)),
            (false, true) => {
                let reason = if failed { Esc32DisarmV3::CROSSING_TIMEOUT } else { Esc32DisarmV3::STARTUP };
                status.with_temperature(self.temperature_c.clamp(-32.0, 95.75))?.with_disarm_v3(reason)
            }
        }
    }
}

/// Between -1 and 1, mostly near 0.
pub(super) fn noise(rng: &mut Rng) -> f32 {
    (rng.f32() + rng.f32() + rng.f32()) / 1.5 - 1.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use mavlink_autoquad::esc::DisarmReason;

    fn run(motor: &mut Motor, throttle: Option<f32>, seconds: f32, rng: &mut Rng) -> Esc {
        for _ in 0..(seconds * 100.0) as u32 {
            motor.step(throttle, 15.5, 0.01, rng);
        }
        motor.report().unwrap()
    }

    #[test]
    fn a_motor_starts_runs_and_gives_up() {
        let mut rng = Rng::with_seed(1);
        let mut motor = Motor::new(3, &mut rng);
        let status = run(&mut motor, None, 0.1, &mut rng).status.unwrap();
        assert_eq!((status.state(), status.rpm()), (Esc32State::DISARMED, 0));
        assert!(!DisarmReason::of(status).unwrap().is_fault());
        assert_eq!(run(&mut motor, Some(0.1), 0.02, &mut rng).status.unwrap().state(), Esc32State::STARTING);
        let status = run(&mut motor, Some(0.56), 20.0, &mut rng).status.unwrap();
        assert_eq!(status.state(), Esc32State::RUNNING);
        assert!((6_000..8_000).contains(&status.rpm()) && (7.0..14.0).contains(&status.current()), "{status:?}");
        assert!(status.temperature().unwrap() > 30.0);
        motor.health = Health::Failed;
        let status = run(&mut motor, Some(0.56), 5.0, &mut rng).status.unwrap();
        assert_eq!((status.state(), status.rpm(), status.current()), (Esc32State::DISARMED, 0, 0.0));
        assert!(DisarmReason::of(status).unwrap().is_fault());
    }

    #[test]
    fn a_silent_controller_ages_as_the_flight_controller_says() {
        let mut rng = Rng::with_seed(1);
        let mut motor = Motor::new(1, &mut rng);
        motor.silent = true;
        let esc = run(&mut motor, Some(0.5), 0.9, &mut rng);
        assert!(esc.status.is_some() && esc.age_ms.is_some_and(|age| (890..=910).contains(&age)), "{esc:?}");
        let esc = run(&mut motor, Some(0.5), 1.0, &mut rng);
        assert!(esc.status.is_none() && esc.age_ms.is_some_and(|age| (1890..=1910).contains(&age)), "{esc:?}");
        assert_eq!(run(&mut motor, Some(0.5), 1.5, &mut rng).age_ms, None);
    }
}
