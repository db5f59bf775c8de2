//! AutoQuad's controllers as PX4 reports its own.

use super::{EscConnectionType, EscFailures, EscReport, EscStatus};
use crate::autoquad::{Esc32State, Esc32Status};
use crate::esc::{Conversion, DisarmReason, EscRow, EscTable, Silent};

/// Controllers that an [`EscStatus`] can have.
pub const MAX_ESCS: u8 = EscStatus::CONNECTED_ESC_MAX;

impl EscTable {
    /// All controllers at an uptime in microseconds, as PX4 reports its own: motor k + 1 at place k, connected by CAN.
    ///
    /// There is room for 12 of AutoQuad's 16: what [`num_motors`](Self::num_motors) has beyond [`MAX_ESCS`] is left out. Of the
    /// conversion, what concerns `info` does not matter here.
    ///
    /// The version of the firmware decides on what is not known: version 2 counts errors, version 3 measures the temperature.
    /// `esc_power` is the duty, of which version 2.1 since June 2014 sends 0 to 2 of 255, whatever it is.
    #[must_use]
    pub fn to_px4(&self, now_us: u64, conversion: &Conversion) -> EscStatus {
        let count = self.num_motors().min(MAX_ESCS);
        let mut status = EscStatus {
            timestamp: self.uptime_us(),
            counter: self.counts().cycles,
            esc_count: count,
            esc_connectiontype: EscConnectionType::CAN,
            // As PX4 leaves places that are not in use.
            esc: [silent(Silent::Zero); MAX_ESCS as usize],
            ..EscStatus::UNKNOWN
        };
        for (index, report) in (0..count).zip(&mut status.esc) {
            let row = self.at_index(index);
            let online = row.filter(|row| row.is_online(now_us, conversion.online_limit_ms));
            *report = EscReport {
                actuator_function: EscReport::ACTUATOR_FUNCTION_MOTOR1 + index,
                ..row
                    .map_or_else(|| silent(conversion.silent), |row| reported(row, online.is_some(), conversion.silent))
            };
            let armed = online.and_then(|row| row.status).is_some_and(|status| status.state() != Esc32State::DISARMED);
            status.esc_online_flags |= u16::from(online.is_some()) << index;
            status.esc_armed_flags |= u16::from(armed) << index;
        }
        status
    }
}

fn reported(row: &EscRow, online: bool, when_silent: Silent) -> EscReport {
    let report = EscReport { timestamp: row.received_us, esc_address: row.id, ..silent(when_silent) };
    match row.status {
        Some(status) if online => measured(status, &report),
        // What has been counted stays true of a controller that falls silent.
        Some(status) if when_silent == Silent::Unknown => EscReport { esc_errorcount: errors(status), ..report },
        _ => report,
    }
}

fn measured(status: Esc32Status, report: &EscReport) -> EscReport {
    let flags = DisarmReason::of(status).map_or(0, |reason| reason.failure_flags().bits());
    EscReport {
        esc_errorcount: errors(status),
        esc_rpm: status.rpm().into(),
        esc_voltage: status.voltage(),
        esc_current: status.current(),
        esc_temperature: status.temperature().unwrap_or(f32::NAN),
        esc_state: status.state().into(),
        // MAVLink has the bits of PX4.
        failures: EscFailures::from_bits_retain(flags),
        esc_power: percent(status.duty_raw()),
        ..*report
    }
}

fn errors(status: Esc32Status) -> u32 {
    status.errors().map_or(0, u32::from)
}

/// A part of 255 in percent, to the nearest.
fn percent(raw: u8) -> i8 {
    i8::try_from((u16::from(raw) * 100 + 127) / 255).unwrap_or(i8::MAX)
}

/// A controller that says nothing.
fn silent(silent: Silent) -> EscReport {
    match silent {
        Silent::Unknown => EscReport::UNKNOWN,
        Silent::Zero => EscReport { esc_voltage: 0.0, esc_current: 0.0, esc_temperature: 0.0, ..EscReport::UNKNOWN },
    }
}
