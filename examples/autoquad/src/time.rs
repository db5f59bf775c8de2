//! Points in time as users read and write them.

use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// Microseconds of a second.
pub(crate) const SECOND_US: u64 = 1_000_000;

/// Unix time in µs, now.
pub(crate) fn now_us() -> u64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    u64::try_from(since.as_micros()).unwrap_or(u64::MAX)
}

/// Unix time in µs from which on nothing is a time: the year 10000. Sums of what lies before it do not overflow.
pub(crate) const END_US: u64 = 253_402_300_800 * SECOND_US;

/// Unix time in µs as ISO 8601 with microseconds; `None` past the year 9999.
pub(crate) fn iso(time_us: u64) -> Option<String> {
    let time = UNIX_EPOCH.checked_add(Duration::from_micros(time_us)).filter(|_| time_us < END_US)?;
    Some(humantime::format_rfc3339_micros(time).to_string())
}

/// Seconds with all six decimals, which no float has for times of today.
pub(crate) fn seconds(time_us: u64) -> String {
    format!("{}.{:06}", time_us / SECOND_US, time_us % SECOND_US)
}

/// Hours, minutes and seconds.
pub(crate) fn clock(time_us: u64) -> String {
    let seconds = time_us / SECOND_US;
    match seconds / 3600 {
        0 => format!("{:02}:{:02}", seconds / 60, seconds % 60),
        hours => format!("{hours}:{:02}:{:02}", seconds / 60 % 60, seconds % 60),
    }
}

/// Reads a point in time: ISO 8601 in UTC, like `2016-04-30T12:00:00Z`, or seconds since 1970.
pub(crate) fn parse(text: &str) -> Result<u64, String> {
    let since = match text.parse::<f64>() {
        Ok(seconds) => Duration::try_from_secs_f64(seconds).map_err(|error| error.to_string())?,
        Err(_) => {
            let time = humantime::parse_rfc3339_weak(text)
                .map_err(|_| "write it like 2016-04-30T12:00:00Z, or as seconds since 1970".to_owned())?;
            time.duration_since(UNIX_EPOCH).map_err(|_| "it is before 1970".to_owned())?
        }
    };
    u64::try_from(since.as_micros()).map_err(|_| "it is too late".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_read_as_they_are_written() {
        assert_eq!(parse("2016-04-30T12:00:00Z"), Ok(1_462_017_600_000_000));
        assert_eq!(parse("2016-04-30 12:00:00.25"), Ok(1_462_017_600_250_000));
        assert_eq!(parse("1462017600.5"), Ok(1_462_017_600_500_000));
        assert_eq!(iso(1_462_017_600_500_000).as_deref(), Some("2016-04-30T12:00:00.500000Z"));
        assert_eq!(seconds(1_462_017_600_000_001), "1462017600.000001");
        assert_eq!((clock(61 * SECOND_US), clock(3_600 * SECOND_US)), ("01:01".to_owned(), "1:00:00".to_owned()));
    }

    #[test]
    fn what_is_no_time_is_refused() {
        for text in ["", "yesterday", "-1", "1969-12-31T23:59:59Z", "1e30", "nan", "2016-13-01T00:00:00Z"] {
            assert!(parse(text).is_err(), "{text}");
        }
        assert_eq!(iso(u64::MAX), None);
    }
}
