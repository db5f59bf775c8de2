//! The caller's clock.

use core::fmt;
use core::ops::{Add, AddAssign, Sub};
use core::time::Duration;

/// A time of a clock that never goes back, in nanoseconds since whenever the caller started it. It lasts for 584 years.
///
/// ```
/// use core::time::Duration;
/// use mavlink_services::Instant;
///
/// let now = Instant::from_millis(1500);
/// assert_eq!(now + Duration::from_micros(7), Instant::from_micros(1_500_007));
/// assert_eq!(now - Instant::from_millis(1000), Duration::from_millis(500));
/// assert_eq!(Instant::ZERO - now, Duration::ZERO);
/// ```
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Instant(u64);

impl Instant {
    /// When the clock was started.
    pub const ZERO: Self = Self(0);

    /// The last time that there is. A deadline that would be later is this one.
    pub const MAX: Self = Self(u64::MAX);

    /// This many nanoseconds after the start.
    #[must_use]
    pub const fn from_nanos(nanos: u64) -> Self {
        Self(nanos)
    }

    /// This many microseconds after the start; what is too much is [`MAX`](Self::MAX).
    #[must_use]
    pub const fn from_micros(micros: u64) -> Self {
        Self(micros.saturating_mul(1_000))
    }

    /// This many milliseconds after the start; what is too much is [`MAX`](Self::MAX).
    #[must_use]
    pub const fn from_millis(millis: u64) -> Self {
        Self(millis.saturating_mul(1_000_000))
    }

    /// Nanoseconds since the start.
    #[must_use]
    pub const fn to_nanos(self) -> u64 {
        self.0
    }
}

/// The nanoseconds of a duration, at most what a `u64` holds. `Duration::as_nanos` is a division of 128 bits on small machines.
const fn nanos(duration: Duration) -> u64 {
    duration.as_secs().saturating_mul(1_000_000_000).saturating_add(duration.subsec_nanos() as u64)
}

/// Later by this, at most [`MAX`](Instant::MAX).
impl Add<Duration> for Instant {
    type Output = Self;

    fn add(self, duration: Duration) -> Self {
        Self(self.0.saturating_add(nanos(duration)))
    }
}

impl AddAssign<Duration> for Instant {
    fn add_assign(&mut self, duration: Duration) {
        *self = *self + duration;
    }
}

/// How much later this is than the other; zero if it is earlier.
impl Sub for Instant {
    type Output = Duration;

    fn sub(self, earlier: Self) -> Duration {
        Duration::from_nanos(self.0.saturating_sub(earlier.0))
    }
}

/// As a duration since the start.
impl fmt::Debug for Instant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&Duration::from_nanos(self.0), f)
    }
}
