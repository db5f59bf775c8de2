//! A vehicle: its motors, its battery, and the messages that it sends.

use std::time::Duration;

use fastrand::Rng;
use mavlink_autoquad::autoquad::{
    AqEscTelemetry, Attitude, Autoquad, GlobalPositionInt, GpsFixType, GpsRawInt, Heartbeat, MavAutopilot,
    MavComponent, MavModeFlag, MavSeverity, MavState, MavSysStatusSensor, MavType, Statustext, SysStatus,
};
use mavlink_autoquad::wire::{Chars, ComponentId, Frame, Message, SystemId, ViewError};

use super::datasets::{Measured, dataset};
use super::flight::{FAILS_AT, FALLS_SILENT_AT, Moment, WEAKENS_AT};
use super::motor::{Health, Motor, noise};
use super::streams::Streams;
use crate::time::SECOND_US;

/// The vehicle's own ids.
pub(super) const ID: (SystemId, ComponentId) = (SystemId::from_u8(1), ComponentId::from_u8(MavComponent::AUTOPILOT1.0));

/// Microseconds that a step takes: AutoQuad's fastest stream has 200 a second.
pub(super) const STEP_US: u64 = 5_000;

/// Microseconds since the vehicle was switched on, at the start.
const SWITCHED_ON_US: u64 = 12 * SECOND_US;

/// Where it starts: latitude and longitude in 1e-7 degrees, altitude in mm.
const HOME: (i32, i32, i32) = (473_977_420, 85_455_940, 488_000);

/// Metres of a 1e-7 degree of latitude.
const METRES: f32 = 0.011_131_9;

/// A simulated AutoQuad.
pub(super) struct Vehicle {
    pub(super) streams: Streams,
    motors: Vec<Motor>,
    rng: Rng,
    flight_s: f32,
    elapsed_us: u64,
    moment: Moment,
    battery_v: f32,
    used_ah: f32,
    failing: u8,
    silent: u8,
}

impl Vehicle {
    /// A vehicle of 1 to 16 motors. Its seed says which motor fails, which falls silent, and how all values scatter.
    pub(super) fn new(motors: u8, seed: u64, flight: Duration, streams: Streams) -> Self {
        let mut rng = Rng::with_seed(seed);
        let failing = rng.u8(1..=motors);
        let silent = (failing - 1 + rng.u8(1..=motors.saturating_sub(1).max(1))) % motors + 1;
        let flight_s = flight.as_secs_f32();
        Self {
            streams,
            motors: (1..=motors).map(|port| Motor::new(port, &mut rng)).collect(),
            rng,
            flight_s,
            elapsed_us: 0,
            moment: Moment::at(0.0, flight_s),
            battery_v: 16.6,
            used_ah: 0.0,
            failing,
            silent,
        }
    }

    /// Whether the flight is over.
    pub(super) fn has_landed(&self) -> bool {
        self.moment.share >= 1.0
    }

    /// Microseconds since the start.
    pub(super) const fn elapsed_us(&self) -> u64 {
        self.elapsed_us
    }

    /// Does what a frame asks for, and gives the answer.
    pub(super) fn receive(&mut self, frame: &Frame<'_>) -> Option<Autoquad> {
        self.streams.receive(frame, ID)
    }

    /// Goes on by [`STEP_US`], and gives what the vehicle sends then.
    pub(super) fn step(&mut self) -> Result<Vec<Autoquad>, ViewError> {
        let mut sent = Vec::new();
        self.fly(&mut sent);
        if self.is_due(SECOND_US) {
            sent.extend([Autoquad::from(self.heartbeat()), self.sys_status().into()]);
        }
        if self.is_due(SECOND_US / 5) {
            sent.extend([Autoquad::from(self.global_position()), self.gps_raw().into()]);
        }
        if self.is_due(SECOND_US / 10) {
            sent.push(self.attitude().into());
        }
        if self.streams.propulsion_hz > 0 && self.is_due(SECOND_US / u64::from(self.streams.propulsion_hz)) {
            self.propulsion(&mut sent)?;
        }
        if self.is_due(self.streams.dataset_interval_us) {
            let currents_a: Vec<f32> = self.motors.iter().map(Motor::current_a).collect();
            let measured = Measured { battery_v: self.battery_v, flight_us: self.elapsed_us, currents_a: &currents_a };
            let datasets = self.streams.datasets.iter().map(|&index| dataset(index, &self.moment, &measured));
            sent.extend(datasets.map(Autoquad::from));
        }
        self.elapsed_us += STEP_US;
        Ok(sent)
    }

    fn is_due(&self, interval_us: u64) -> bool {
        self.elapsed_us.is_multiple_of(interval_us.next_multiple_of(STEP_US).max(STEP_US))
    }

    const fn uptime_us(&self) -> u64 {
        SWITCHED_ON_US + self.elapsed_us
    }

    /// As AutoQuad has it: a counter of 32 bits.
    fn clock_us(&self) -> u32 {
        self.uptime_us() as u32
    }

    fn fly(&mut self, sent: &mut Vec<Autoquad>) {
        let (second, step_s) = (self.elapsed_us as f32 / SECOND_US as f32, STEP_US as f32 / SECOND_US as f32);
        let before = self.moment.share;
        self.moment = Moment::at(second, self.flight_s);
        let (share, has_passed) = (self.moment.share, |at: f32| before < at && at <= self.moment.share);
        let throttle = Some(self.moment.throttle).filter(|_| self.moment.is_armed());
        let count = self.motors.len() as f32;
        // The others carry what the failed one did.
        let shared = if share >= FAILS_AT && count > 1.0 { (count / (count - 1.0)).min(1.2) } else { 1.0 };
        let mut total_a = 0.0;
        for motor in &mut self.motors {
            if motor.port == self.failing {
                motor.health = match share {
                    _ if share >= FAILS_AT => Health::Failed,
                    _ if share >= WEAKENS_AT => Health::Weak,
                    _ => Health::Sound,
                };
            }
            motor.silent = motor.port == self.silent && share >= FALLS_SILENT_AT;
            let gust = 1.0 + 0.012 * noise(&mut self.rng);
            motor.step(throttle.map(|throttle| throttle * shared * gust), self.battery_v, step_s, &mut self.rng);
            total_a += motor.current_a();
        }
        self.used_ah += total_a * step_s / 3600.0;
        let capacity_ah = 1.3 * count * self.flight_s / 300.0;
        let charge = (1.0 - self.used_ah / capacity_ah).max(0.0);
        self.battery_v = 14.0 + 2.6 * charge - 0.05 * total_a / count;
        for (at, port, what) in [(FAILS_AT, self.failing, "stopped"), (FALLS_SILENT_AT, self.silent, "telemetry lost")]
        {
            if has_passed(at) {
                sent.push(text(&format!("Motor {port}: {what}")).into());
            }
        }
    }

    fn heartbeat(&self) -> Heartbeat {
        let armed = self.moment.is_armed();
        Heartbeat {
            r#type: kind(self.motors.len()),
            autopilot: MavAutopilot::AUTOQUAD,
            base_mode: match armed {
                true => MavModeFlag::CUSTOM_MODE_ENABLED | MavModeFlag::SAFETY_ARMED,
                false => MavModeFlag::CUSTOM_MODE_ENABLED,
            },
            custom_mode: self.moment.nav_status().bits(),
            system_status: if armed { MavState::ACTIVE } else { MavState::STANDBY },
            ..Heartbeat::DEFAULT
        }
    }

    fn sys_status(&self) -> SysStatus {
        let sensors =
            MavSysStatusSensor::SENSOR_3D_GYRO | MavSysStatusSensor::SENSOR_3D_ACCEL | MavSysStatusSensor::SENSOR_GPS;
        let total_a: f32 = self.motors.iter().map(Motor::current_a).sum();
        SysStatus {
            onboard_control_sensors_present: sensors,
            onboard_control_sensors_enabled: sensors,
            onboard_control_sensors_health: sensors,
            load: 420,
            voltage_battery: (self.battery_v * 1000.0) as u16,
            current_battery: (total_a * 100.0).min(32_767.0) as i16,
            battery_remaining: ((self.battery_v - 14.0) / 2.6 * 100.0).clamp(0.0, 100.0) as i8,
            ..SysStatus::DEFAULT
        }
    }

    /// AutoQuad puts microseconds into the `time_boot_ms` of all messages but `AQ_ESC_TELEMETRY`.
    fn attitude(&self) -> Attitude {
        let [roll, pitch, yaw] = self.moment.attitude;
        Attitude { time_boot_ms: self.clock_us(), roll, pitch, yaw, ..Attitude::DEFAULT }
    }

    fn global_position(&self) -> GlobalPositionInt {
        let (lat, lon, alt) = self.position();
        GlobalPositionInt {
            time_boot_ms: self.clock_us(),
            lat,
            lon,
            alt,
            relative_alt: (self.moment.altitude_m * 1000.0) as i32,
            vz: (-self.moment.climb_mps * 100.0) as i16,
            hdg: (self.moment.attitude[2].to_degrees().rem_euclid(360.0) * 100.0) as u16,
            ..GlobalPositionInt::DEFAULT
        }
    }

    fn gps_raw(&self) -> GpsRawInt {
        let (lat, lon, alt) = self.position();
        let (eph, epv) = (90, 140);
        GpsRawInt {
            time_usec: self.uptime_us(),
            fix_type: GpsFixType::TYPE_3D_FIX,
            lat,
            lon,
            alt,
            eph,
            epv,
            satellites_visible: 14,
            ..GpsRawInt::DEFAULT
        }
    }

    fn position(&self) -> (i32, i32, i32) {
        let (lat, lon, alt) = HOME;
        let east = self.moment.east_m / METRES / (lat as f32 / 1e7).to_radians().cos();
        (lat + (self.moment.north_m / METRES) as i32, lon + east as i32, alt + (self.moment.altitude_m * 1000.0) as i32)
    }

    /// Batches of four, all with the same time.
    fn propulsion(&self, sent: &mut Vec<Autoquad>) -> Result<(), ViewError> {
        for (seq, batch) in (1..).zip(self.motors.chunks(4)) {
            let mut telemetry = AqEscTelemetry {
                time_boot_ms: self.clock_us() / 1000,
                seq,
                num_motors: self.motors.len() as u8,
                ..AqEscTelemetry::DEFAULT
            };
            for motor in batch {
                telemetry.push_esc(motor.report()?)?;
            }
            sent.push(telemetry.into());
        }
        Ok(())
    }
}

fn text(line: &str) -> Statustext {
    Statustext { severity: MavSeverity::CRITICAL, text: Chars::truncated(line), ..Statustext::DEFAULT }
}

fn kind(motors: usize) -> MavType {
    match motors {
        3 => MavType::TRICOPTER,
        4 => MavType::QUADROTOR,
        6 => MavType::HEXAROTOR,
        8 => MavType::OCTOROTOR,
        10 => MavType::DECAROTOR,
        12 => MavType::DODECAROTOR,
        _ => MavType::GENERIC_MULTIROTOR,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flown(motors: u8, seed: u64) -> Vec<Autoquad> {
        let mut vehicle = Vehicle::new(motors, seed, Duration::from_secs(20), Streams::on(20));
        let mut sent = Vec::new();
        while !vehicle.has_landed() {
            sent.extend(vehicle.step().unwrap());
        }
        sent
    }

    #[test]
    fn a_seed_makes_a_flight() {
        let (one, same, other) = (flown(4, 1), flown(4, 1), flown(4, 2));
        assert_eq!(one, same);
        assert_ne!(one, other);
    }

    #[test]
    fn any_number_of_motors_flies_with_one_failing_and_one_silent() {
        for motors in 1..=16 {
            let sent = flown(motors, u64::from(motors));
            let texts: Vec<_> = sent.iter().filter(|message| matches!(message, Autoquad::Statustext(_))).collect();
            assert_eq!(texts.len(), 2, "{motors} motors: {texts:?}");
            let escs = sent.iter().filter_map(|message| match message {
                Autoquad::AqEscTelemetry(telemetry) => Some(telemetry.escs().collect::<Vec<_>>()),
                _ => None,
            });
            let ports: std::collections::BTreeSet<u8> = escs.flatten().map(|esc| esc.id).collect();
            assert_eq!(ports, (1..=motors).collect());
        }
    }

    #[test]
    fn nothing_that_has_to_be_asked_for_comes_by_itself() {
        let mut vehicle = Vehicle::new(4, 1, Duration::from_secs(20), Streams::off());
        let sent: Vec<Autoquad> = (0..1000).flat_map(|_| vehicle.step().unwrap()).collect();
        assert!(sent.iter().any(|message| matches!(message, Autoquad::Heartbeat(_))));
        let asked = |message: &Autoquad| matches!(message, Autoquad::AqEscTelemetry(_) | Autoquad::AqTelemetryF(_));
        assert!(!sent.iter().any(asked));
    }
}
