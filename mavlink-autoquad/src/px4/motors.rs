//! The controllers of an [`EscStatus`], by motor.

use super::{EscReport, EscStatus};

/// The output functions of motors 1 to 12.
const FIRST: u8 = EscReport::ACTUATOR_FUNCTION_MOTOR1;
const LAST: u8 = EscReport::ACTUATOR_FUNCTION_MOTOR_MAX;

/// What is said of a motor's controller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motor<'s> {
    /// The motor, from 1; `None` if the report does not say which motor it drives, or drives none. PX4 says so since 1.14.
    pub number: Option<u8>,
    /// The place in [`EscStatus::esc`], from 0.
    pub slot: u8,
    /// Whether the controller answers.
    pub online: bool,
    /// Whether it is armed, or does not say.
    pub armed: bool,
    /// What it reports.
    pub report: &'s EscReport,
}

impl EscReport {
    /// The motor that the controller drives, 1 to 12; `None` if its output is none of a motor's, or is not said.
    #[must_use]
    pub fn motor(&self) -> Option<u8> {
        (FIRST..=LAST).contains(&self.actuator_function).then(|| self.actuator_function - FIRST + 1)
    }
}

impl EscStatus {
    /// The controllers that are reported, in the order of their places: that of motors in some vehicles, of outputs or of nodes
    /// in others. Left out are places that nothing was said of, and what simulators have behind the last controller.
    ///
    /// Bit k of the flags is that of place k. PX4's `main` calls it the order of motors, and the drivers for DShot and DroneCAN
    /// and the checks before arming go by places. (The driver for ModalAI's controllers goes by motors. It differs where its
    /// places are in another order.)
    pub fn motors(&self) -> impl Iterator<Item = Motor<'_>> {
        let count = self.esc_count;
        let motors = (0_u8..).zip(&self.esc).map(|(slot, report)| self.motor_at(slot, report));
        motors.filter(move |motor| motor.is_reported(count))
    }

    fn motor_at<'s>(&self, slot: u8, report: &'s EscReport) -> Motor<'s> {
        let has = |flags: u16| flags.checked_shr(slot.into()).is_some_and(|flags| flags & 1 != 0);
        let (online, armed) = (has(self.esc_online_flags), has(self.esc_armed_flags));
        Motor { number: report.motor(), slot, online, armed, report }
    }
}

impl Motor<'_> {
    /// Whether it is one of `count` controllers that something is said of. Logs from before 2019-08 do not say who answers, and
    /// those from before 1.14 not which motor it is.
    fn is_reported(&self, count: u8) -> bool {
        let EscReport { timestamp, esc_errorcount, esc_rpm, actuator_function, .. } = *self.report;
        let measured = [self.report.esc_voltage(), self.report.esc_current(), self.report.esc_temperature()];
        let says_something = timestamp != 0
            || esc_errorcount != 0
            || esc_rpm != 0
            || measured.into_iter().flatten().any(|value| value != 0.0);
        self.online || actuator_function != 0 || self.slot < count && says_something
    }
}
