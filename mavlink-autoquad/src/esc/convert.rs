//! The messages that ground stations of today show: `ESC_INFO` and `ESC_STATUS` of `common.xml`.

use core::array;

use super::disarm::DisarmReason;
use super::table::{EscRow, EscTable, MAX_ESCS, ONLINE_LIMIT_MS};
use crate::autoquad::{EscConnectionType, EscFailureFlags, EscInfo, EscStatus};

/// Controllers in a message.
const BATCH: u8 = 4;

/// How controllers are shown in `ESC_INFO` and `ESC_STATUS`: the choices in which senders differ.
///
/// A bridge sends one of each for every four motors ([`EscTable::to_esc_info`], [`EscTable::to_esc_status`]), `ESC_INFO` about
/// once a second and `ESC_STATUS` about ten times, as MAVLink 2 under the vehicle's system id.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Conversion {
    /// A status of this age or older is that of a silent controller. In milliseconds.
    pub online_limit_ms: u64,
    /// What stands for the values of a silent controller.
    pub silent: Silent,
    /// Which controllers the bits of `info` mean.
    pub info: InfoBits,
}

/// What stands for the values of a silent controller.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Silent {
    /// Temperature 32767, voltage and current NaN: "not known". The speed, which has no such value, is 0; the count of
    /// errors stays.
    #[default]
    Unknown,
    /// Zeros, as PX4 sends since 2025-11. A ground station may take them for measured.
    Zero,
}

/// Which controllers the bits of `info` mean.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum InfoBits {
    /// Bit 0 is the first controller of the message, as in PX4 since 2025-11.
    #[default]
    Batch,
    /// Bit 0 is the first controller of the vehicle, as in PX4 before. Controllers 9 to 16 have no bit.
    Vehicle,
}

impl Conversion {
    /// The limit of PX4, "not known" for silent controllers, and bits for the controllers of the message.
    pub const DEFAULT: Self = Self { online_limit_ms: ONLINE_LIMIT_MS, silent: Silent::Unknown, info: InfoBits::Batch };
}

impl Default for Conversion {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl EscTable {
    /// Faults, errors and temperatures of four controllers at an uptime in microseconds; batch 0 is the first four motors in
    /// use. `None` where there are no such motors.
    ///
    /// Firmware of version 2 counts errors, version 3 measures the temperature, so one of both is 0 or not known.
    #[must_use]
    pub fn to_esc_info(&self, batch: u8, now_us: u64, conversion: &Conversion) -> Option<EscInfo> {
        let Batch { index, slots } = self.batch(batch, now_us, conversion)?;
        let unknown = match conversion.silent {
            Silent::Unknown => i16::MAX,
            Silent::Zero => 0,
        };
        Some(EscInfo {
            index,
            time_usec: self.uptime_us(),
            counter: self.counts().cycles,
            count: self.num_motors(),
            connection_type: EscConnectionType::CAN,
            info: self.info(index, now_us, conversion),
            failure_flags: slots.map(|slot| slot.online().map_or(EscFailureFlags::empty(), failure_flags)),
            error_count: slots.map(|slot| slot.error_count(conversion.silent)),
            temperature: slots.map(|slot| slot.online().map_or(unknown, temperature_cdegc)),
        })
    }

    /// Speed, voltage and current of four controllers, as [`EscTable::to_esc_info`].
    #[must_use]
    pub fn to_esc_status(&self, batch: u8, now_us: u64, conversion: &Conversion) -> Option<EscStatus> {
        let Batch { index, slots } = self.batch(batch, now_us, conversion)?;
        let unknown = match conversion.silent {
            Silent::Unknown => f32::NAN,
            Silent::Zero => 0.0,
        };
        let status = |slot: Slot<'_>| slot.online().and_then(|row| row.status);
        Some(EscStatus {
            index,
            time_usec: self.uptime_us(),
            rpm: slots.map(|slot| status(slot).map_or(0, |status| i32::from(status.rpm()))),
            voltage: slots.map(|slot| status(slot).map_or(unknown, |status| status.voltage())),
            current: slots.map(|slot| status(slot).map_or(unknown, |status| status.current())),
        })
    }

    fn batch(&self, batch: u8, now_us: u64, conversion: &Conversion) -> Option<Batch<'_>> {
        let index = batch.checked_mul(BATCH).filter(|&index| index < self.num_motors())?;
        let slots = array::from_fn(|offset| {
            let row = self.at_index(index + offset as u8);
            Slot { row, online: row.is_some_and(|row| row.is_online(now_us, conversion.online_limit_ms)) }
        });
        Some(Batch { index, slots })
    }

    fn info(&self, first: u8, now_us: u64, conversion: &Conversion) -> u8 {
        let (start, end) = match conversion.info {
            InfoBits::Batch => (first, first + BATCH),
            InfoBits::Vehicle => (0, MAX_ESCS as u8),
        };
        let online = |row: &&EscRow| row.is_online(now_us, conversion.online_limit_ms);
        let rows = self.iter_by_index().filter(|row| (start..end).contains(&row.index)).filter(online);
        rows.fold(0, |bits, row| bits | 1_u8.checked_shl(u32::from(row.index - start)).unwrap_or_default())
    }
}

/// Four places among the motors in use.
struct Batch<'t> {
    index: u8,
    slots: [Slot<'t>; BATCH as usize],
}

/// A place, with or without a controller.
#[derive(Clone, Copy)]
struct Slot<'t> {
    row: Option<&'t EscRow>,
    online: bool,
}

impl<'t> Slot<'t> {
    fn online(self) -> Option<&'t EscRow> {
        self.row.filter(|_| self.online)
    }

    /// What has been counted stays true of a controller that falls silent.
    fn error_count(self, silent: Silent) -> u32 {
        let row = match silent {
            Silent::Unknown => self.row,
            Silent::Zero => self.online(),
        };
        row.and_then(|row| row.status?.errors()).map_or(0, u32::from)
    }
}

fn failure_flags(row: &EscRow) -> EscFailureFlags {
    row.status.and_then(DisarmReason::of).map_or(EscFailureFlags::empty(), DisarmReason::failure_flags)
}

/// Version 2 does not measure it: not known, also where silent controllers are shown as zeros.
fn temperature_cdegc(row: &EscRow) -> i16 {
    let temperature = row.status.and_then(|status| status.temperature_cdegc());
    temperature.and_then(|value| i16::try_from(value).ok()).unwrap_or(i16::MAX)
}
