//! The time of signatures.

use core::time::Duration;

/// 2015-01-01T00:00:00Z as Unix time, µs.
const START_US: u64 = 1_420_070_400_000_000;
/// Microseconds in a unit.
const UNIT_US: u64 = 10;

/// A time as signatures have it: 48 bits, units of 10 µs since 2015-01-01T00:00:00Z, which lasts until the year 2104
/// (MAVLink guide, "Message Signing").
///
/// ```
/// use mavlink_wire::Timestamp;
///
/// let now = Timestamp::from_unix_micros(1_420_070_401_000_000);
/// assert_eq!(now, Timestamp::new(100_000));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
pub struct Timestamp(u64);

impl Timestamp {
    /// The beginning of 2015: what to give for the time where there is no clock.
    pub const ZERO: Self = Self(0);

    /// The last one.
    pub const MAX: Self = Self((1 << 48) - 1);

    /// A timestamp of this many units of 10 µs; [`MAX`](Self::MAX) if they do not fit 48 bits.
    #[must_use]
    pub const fn new(units: u64) -> Self {
        if units > Self::MAX.0 { Self::MAX } else { Self(units) }
    }

    /// The timestamp of a Unix time in µs: rounded down, and the nearest there is for times before 2015 or after 2104.
    #[must_use]
    pub const fn from_unix_micros(us: u64) -> Self {
        Self::new(us.saturating_sub(START_US) / UNIT_US)
    }

    /// Units of 10 µs, at most 48 bits.
    #[must_use]
    pub const fn units(self) -> u64 {
        self.0
    }

    /// Unix time in µs.
    #[must_use]
    pub const fn to_unix_micros(self) -> u64 {
        START_US + self.0 * UNIT_US
    }

    /// The timestamp this much later, at most [`MAX`](Self::MAX).
    ///
    /// After a restart: the saved timestamp and the interval at which it is saved.
    #[must_use]
    pub fn saturating_add(self, duration: Duration) -> Self {
        let units = u64::try_from(duration.as_micros() / u128::from(UNIT_US)).unwrap_or(u64::MAX);
        Self::new(self.0.saturating_add(units))
    }

    /// Reads what is on the wire: the lowest byte first.
    pub(crate) const fn from_bytes([a, b, c, d, e, f]: [u8; 6]) -> Self {
        Self(u64::from_le_bytes([a, b, c, d, e, f, 0, 0]))
    }

    /// What [`from_bytes`](Self::from_bytes) reads.
    #[cfg(feature = "signing")]
    pub(crate) const fn to_bytes(self) -> [u8; 6] {
        let [a, b, c, d, e, f, ..] = self.0.to_le_bytes();
        [a, b, c, d, e, f]
    }

    /// One unit later, at most [`MAX`](Self::MAX): zero after it, as pymavlink counts, would be older than all before.
    #[cfg(feature = "signing")]
    pub(crate) const fn next(self) -> Self {
        Self::new(self.0 + 1)
    }
}
