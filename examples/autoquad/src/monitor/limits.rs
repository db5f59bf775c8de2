//! From which values on something is wrong.

use clap::Args;
use mavlink_autoquad::autoquad::Esc32Status;

use crate::quantity::Quantity;

/// In volts: a full cell.
const FULL_CELL_V: f32 = 4.25;

/// In volts: an empty cell.
const EMPTY_CELL_V: f32 = 3.3;

/// A share of the limit: so near to it is a warning.
const NEAR: f32 = 0.05;

/// The limits of all controllers.
#[derive(Args, Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// The lowest voltage, in V. If it is not given: 3.3 V a cell, with as many cells as the highest voltage so far tells.
    #[arg(long, value_name = "V")]
    min_voltage: Option<f32>,
    /// The highest current of a controller, in A.
    #[arg(long, value_name = "A", default_value_t = 20.0)]
    max_current: f32,
    /// The highest temperature of a controller, in °C.
    #[arg(long, value_name = "DEGC", default_value_t = 80.0)]
    max_temperature: f32,
}

impl Default for Limits {
    fn default() -> Self {
        Self { min_voltage: None, max_current: 20.0, max_temperature: 80.0 }
    }
}

/// How a value, or a controller, is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Level {
    Good,
    /// Near a limit.
    Warning,
    /// Beyond a limit, or out of order.
    Fault,
}

impl Limits {
    /// How a value of a status is. The highest voltage so far tells the number of cells.
    pub(crate) fn level(&self, quantity: Quantity, status: Esc32Status, highest_v: f32) -> Level {
        let (value, limit) = match quantity {
            Quantity::Speed => return Level::Good,
            Quantity::Current => (status.current(), self.max_current),
            Quantity::Temperature => match status.temperature() {
                Some(degrees) => (degrees, self.max_temperature),
                None => return Level::Good,
            },
            // Below zero, the lowest is the highest.
            Quantity::Voltage => {
                let cells = (highest_v / FULL_CELL_V).ceil();
                (-status.voltage(), -self.min_voltage.unwrap_or(EMPTY_CELL_V * cells))
            }
        };
        match value {
            _ if value > limit => Level::Fault,
            _ if value > limit - NEAR * limit.abs() => Level::Warning,
            _ => Level::Good,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_near_and_beyond_a_limit_are_told_apart() {
        let limits = Limits::default();
        let status = |volts, amperes, degrees| {
            let status =
                Esc32Status::from_bits(0, 30).with_voltage(volts).and_then(|status| status.with_current(amperes));
            status.and_then(|status| status.with_temperature(degrees)).unwrap()
        };
        for (volts, expected) in [(16.0, Level::Good), (13.5, Level::Warning), (13.0, Level::Fault)] {
            assert_eq!(limits.level(Quantity::Voltage, status(volts, 0.0, 20.0), 16.8), expected, "{volts} V");
        }
        for (amperes, expected) in [(10.0, Level::Good), (19.5, Level::Warning), (20.5, Level::Fault)] {
            assert_eq!(limits.level(Quantity::Current, status(16.0, amperes, 20.0), 16.8), expected, "{amperes} A");
        }
        for (degrees, expected) in [(40.0, Level::Good), (78.0, Level::Warning), (85.0, Level::Fault)] {
            assert_eq!(limits.level(Quantity::Temperature, status(16.0, 1.0, degrees), 16.8), expected, "{degrees} °C");
        }
        let given = Limits { min_voltage: Some(15.0), ..limits };
        assert_eq!(given.level(Quantity::Voltage, status(14.9, 0.0, 20.0), 16.8), Level::Fault);
    }
}
