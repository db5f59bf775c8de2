//! What is measured of each controller, and drawn over time.

use mavlink_autoquad::autoquad::Esc32Status;

/// A measured value, drawn in a panel or as a trend of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    Speed,
    Current,
    Voltage,
    Temperature,
}

/// One report, in the order of [`Quantity::ALL`]; what it does not have is `None`.
pub(crate) type Values = [Option<f32>; 4];

impl Quantity {
    pub(crate) const ALL: [Self; 4] = [Self::Speed, Self::Current, Self::Voltage, Self::Temperature];

    /// All values of a status.
    pub(crate) fn values(status: Esc32Status) -> Values {
        [Some(status.rpm().into()), Some(status.current()), Some(status.voltage()), status.temperature()]
    }

    /// This value of a report.
    pub(crate) fn of(self, values: &Values) -> Option<f32> {
        values.get(self as usize).copied().flatten()
    }

    /// What an axis says.
    pub(crate) const fn label(self) -> &'static str {
        match self {
            Self::Speed => "speed (rpm)",
            Self::Current => "current (A)",
            Self::Voltage => "voltage (V)",
            Self::Temperature => "temperature (°C)",
        }
    }

    /// A value as an axis shows it.
    pub(crate) fn number(self, value: f64) -> String {
        match self {
            Self::Speed | Self::Temperature => format!("{value:.0}"),
            Self::Current | Self::Voltage => format!("{value:.1}"),
        }
    }

    /// What is said where a limit is crossed.
    pub(crate) fn beyond_limit(self) -> String {
        let name = self.label().split(' ').next().unwrap_or_default();
        format!("{name} beyond its limit")
    }

    /// The one after it, in a circle.
    pub(crate) const fn next(self) -> Self {
        match self {
            Self::Speed => Self::Current,
            Self::Current => Self::Voltage,
            Self::Voltage => Self::Temperature,
            Self::Temperature => Self::Speed,
        }
    }
}
