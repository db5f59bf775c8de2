//! A frame with the time at which it was recorded.

use std::fmt;
use std::time::{Duration, SystemTime};

use mavlink_wire::Frame;
use mavlink_wire::tlog::Entry;

/// 9999-12-31T23:59:59.999999Z, the last time that RFC 3339 can write, in microseconds.
const LAST: u64 = 253_402_300_799_999_999;

/// A frame, and when it was received, where that is known.
#[derive(Clone, Copy)]
pub(super) struct Received<'a> {
    pub(super) time: Option<Time>,
    pub(super) frame: Frame<'a>,
}

impl<'a> From<Entry<'a>> for Received<'a> {
    fn from(entry: Entry<'a>) -> Self {
        Self { time: entry.time_us.map(Time), frame: entry.frame }
    }
}

/// Microseconds since 1970, as a log has them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Time(pub(super) u64);

impl Time {
    /// Seconds since 1970, to the microsecond.
    pub(super) fn unix(self) -> String {
        format!("{}.{:06}", self.0 / 1_000_000, self.0 % 1_000_000)
    }
}

/// As RFC 3339 writes it, or the number where that cannot.
impl fmt::Display for Time {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match SystemTime::UNIX_EPOCH.checked_add(Duration::from_micros(self.0)) {
            Some(time) if self.0 <= LAST => humantime::format_rfc3339_micros(time).fmt(f),
            _ => self.0.fmt(f),
        }
    }
}

/// Bytes as hexadecimal digits.
pub(super) fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times() {
        for (micros, shown) in [
            (0, "1970-01-01T00:00:00.000000Z"),
            (1_400_000_000_123_456, "2014-05-13T16:53:20.123456Z"),
            (LAST, "9999-12-31T23:59:59.999999Z"),
            (LAST + 1, "253402300800000000"),
            (u64::MAX, "18446744073709551615"),
        ] {
            assert_eq!(Time(micros).to_string(), shown);
        }
        assert_eq!(Time(1_400_000_000_000_456).unix(), "1400000000.000456");
        assert_eq!(Time(u64::MAX).unix(), "18446744073709.551615");
    }
}
