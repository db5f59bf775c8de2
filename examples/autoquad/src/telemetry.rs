//! Motor telemetry as all subcommands read it.

use clap::Args;
use mavlink_autoquad::autoquad::{AqEscTelemetry, Esc, Esc32State, Esc32Status, LegacyEsc};
use mavlink_autoquad::esc::DisarmReason;
use mavlink_autoquad::wire::{Frame, ViewError};

/// What somebody has to know of the controllers, because they do not tell.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct Firmware {
    /// Reads the bit layout of controllers with firmware from before 2014-12-09.
    #[arg(long)]
    pub(crate) legacy: bool,
}

impl Firmware {
    /// The motor telemetry of a frame, in the layout of today; `None` if it is something else.
    pub(crate) fn telemetry(self, frame: &Frame<'_>) -> Option<AqEscTelemetry> {
        let telemetry = frame.decode::<AqEscTelemetry>()?;
        if self.legacy { modernised(&telemetry).ok() } else { Some(telemetry) }
    }
}

/// The same telemetry, with the bits where later firmware has them.
fn modernised(telemetry: &AqEscTelemetry) -> Result<AqEscTelemetry, ViewError> {
    let mut modern = AqEscTelemetry { num_in_seq: 0, ..*telemetry };
    for LegacyEsc { id, age_ms, status: old } in telemetry.legacy_escs() {
        let status = match old {
            None => None,
            Some(old) => {
                let mut status = Esc32Status::from_bits(0, 20).with_state(old.state())?.with_rpm(old.rpm())?;
                status.set_voltage_raw(old.voltage_raw())?;
                status.set_current_raw(old.current_raw())?;
                status.set_duty_raw(old.duty_raw());
                Some(status.with_errors(old.errors())?)
            }
        };
        modern.push_esc(Esc { id, age_ms, status })?;
    }
    Ok(modern)
}

/// The state without the prefix of its enum: `RUNNING`.
pub(crate) fn state(state: Esc32State) -> String {
    state.to_string().trim_start_matches("ESC32_STATE_").to_owned()
}

/// Why a controller is disarmed, if that is a fault.
pub(crate) fn fault(status: Esc32Status) -> Option<DisarmReason> {
    DisarmReason::of(status).filter(|reason| reason.is_fault())
}

/// In watts.
pub(crate) fn power_w(status: Esc32Status) -> f32 {
    status.voltage() * status.current()
}

#[cfg(test)]
mod tests {
    use super::*;
    use mavlink_autoquad::autoquad::{Autoquad, Esc32StatusUnpacked};
    use mavlink_autoquad::wire::{Dialect, MAX_FRAME, Message, Sender};

    #[test]
    fn old_firmware_reads_as_new() {
        let status = Esc32StatusUnpacked::from_bits(0)
            .with_state(Esc32State::RUNNING)
            .and_then(|status| status.with_voltage(15.12)?.with_current(8.73)?.with_rpm(6543)?.with_errors(17))
            .unwrap();
        let mut old = AqEscTelemetry { seq: 1, num_motors: 2, ..AqEscTelemetry::DEFAULT };
        old.push_legacy_esc(LegacyEsc { id: 1, age_ms: Some(4), status: Some(status) }).unwrap();
        old.push_legacy_esc(LegacyEsc { id: 2, age_ms: None, status: None }).unwrap();
        let mut buffer = [0; MAX_FRAME];
        let bytes = Sender::v1(1, 1).encode(&old, &mut buffer).unwrap();
        let frame = Frame::parse(bytes, Autoquad::TABLE).unwrap();
        assert_eq!(Firmware { legacy: false }.telemetry(&frame), Some(old));
        let new = Firmware { legacy: true }.telemetry(&frame).unwrap();
        let escs: Vec<Esc> = new.escs().collect();
        let read = escs[0].status.unwrap();
        assert_eq!((escs.len(), read.rpm(), read.voltage_mv(), read.current_ma()), (2, 6543, 15_120, 8_730));
        assert_eq!((read.errors(), escs[1].status, escs[1].age_ms), (Some(17), None, None));
    }
}
