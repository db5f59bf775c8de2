//! PX4's controllers as MAVLink messages.

use core::array;

use super::{EscReport, EscStatus, Motor};
use crate::autoquad::{self, EscFailureFlags, EscInfo};

/// Controllers in a message.
const BATCH: u8 = 4;

/// How PX4's controllers are shown in `ESC_INFO` and `ESC_STATUS`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ToMavlink {
    /// What stands at an index of the messages.
    pub order: Order,
}

/// What stands at an index of `ESC_INFO` and `ESC_STATUS`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Order {
    /// Motor k + 1 at index k, as MAVLink demands and PX4 sends since November 2025. What drives no motor is left out, and so is
    /// all of PX4 before 1.14, which does not say what drives what.
    #[default]
    Motor,
    /// Place k at index k, as PX4 sent before.
    Slot,
}

impl ToMavlink {
    /// By motor.
    pub const DEFAULT: Self = Self { order: Order::Motor };
}

impl Default for ToMavlink {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl EscStatus {
    /// Failures, errors and temperatures of four controllers; batch 0 is the first four. `None` if none of them is reported.
    ///
    /// Failures go bit by bit. MAVLink has no names for those of bits 7 to 9, and calls bit 2 too high a temperature of
    /// anything, where PX4 means the motor's.
    #[must_use]
    pub fn to_esc_info(&self, batch: u8, options: &ToMavlink) -> Option<EscInfo> {
        let (index, motors) = self.batch(batch, *options)?;
        let report = |motor: Option<Motor<'_>>| motor.map(|motor| *motor.report);
        Some(EscInfo {
            index,
            time_usec: self.timestamp,
            counter: self.counter,
            count: self.esc_count,
            connection_type: autoquad::EscConnectionType(self.esc_connectiontype.into()),
            info: (0..)
                .zip(motors)
                .fold(0, |bits, (bit, motor)| bits | u8::from(motor.is_some_and(|one| one.online)) << bit),
            failure_flags: motors.map(|motor| {
                EscFailureFlags::from_bits_retain(report(motor).map_or(0, |report| report.failures.bits()))
            }),
            error_count: motors.map(|motor| report(motor).map_or(0, |report| report.esc_errorcount)),
            temperature: motors.map(|motor| report(motor).map_or(i16::MAX, |report| cdegc(report.esc_temperature))),
        })
    }

    /// Speed, voltage and current of four controllers, as [`EscStatus::to_esc_info`].
    #[must_use]
    pub fn to_esc_status(&self, batch: u8, options: &ToMavlink) -> Option<autoquad::EscStatus> {
        let (index, motors) = self.batch(batch, *options)?;
        let value =
            |motor: Option<Motor<'_>>, of: fn(&EscReport) -> f32| motor.map_or(f32::NAN, |motor| of(motor.report));
        Some(autoquad::EscStatus {
            index,
            time_usec: self.timestamp,
            rpm: motors.map(|motor| motor.map_or(0, |motor| motor.report.esc_rpm)),
            voltage: motors.map(|motor| value(motor, |report| report.esc_voltage)),
            current: motors.map(|motor| value(motor, |report| report.esc_current)),
        })
    }

    /// Four controllers, and the index of the first.
    fn batch(&self, batch: u8, options: ToMavlink) -> Option<(u8, [Option<Motor<'_>>; BATCH as usize])> {
        let index = batch.checked_mul(BATCH)?;
        let is_at = |motor: &Motor<'_>, index: u8| match options.order {
            Order::Motor => motor.number == index.checked_add(1),
            Order::Slot => motor.slot == index,
        };
        let found = array::from_fn(|offset| {
            let index = index.checked_add(u8::try_from(offset).ok()?)?;
            self.motors().find(|motor| is_at(motor, index))
        });
        found.iter().any(Option::is_some).then_some((index, found))
    }
}

/// Hundredths of a degree, to the nearest; the largest number if it is not known or beyond them.
fn cdegc(degrees: f32) -> i16 {
    let hundredths = degrees * 100.0;
    let nearest = hundredths + if hundredths < 0.0 { -0.5 } else { 0.5 };
    // The conversion cuts the fraction off, and stops at the ends.
    if nearest.is_nan() { i16::MAX } else { nearest as i16 }
}
