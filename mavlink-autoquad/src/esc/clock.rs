//! Time: the vehicle's clock, and the age of a status.

/// After how many microseconds the vehicle's clock starts again: 2³², which is 71 min 35 s.
const PERIOD_US: u64 = 1 << 32;

/// How far a report may be older than the newest, in microseconds, and still be no new turn of the clock.
const REORDERED_US: u32 = 60_000_000;

/// The oldest status that the flight controller reports, in milliseconds: an older one becomes 65535.
const OLDEST_MS: u16 = 3000;

/// Makes the vehicle's uptime of [`AqEscTelemetry::time_boot_ms`](field@crate::autoquad::AqEscTelemetry::time_boot_ms),
/// which starts again every 71 min 35 s.
///
/// AutoQuad counts microseconds in 32 bits and divides by 1000 (`aq_mavlink.c`), so the field counts to 4294967 and not to
/// 2³². A report that is up to a minute older than the newest counts as one that came late, any other as ahead of it. Two
/// things cannot be told from reports: a silence of more than 70 minutes, and a restart of the vehicle. If you know of one,
/// begin with a new clock.
///
/// ```
/// let mut clock = mavlink_autoquad::esc::UptimeClock::new();
/// assert_eq!(clock.update(4_294_960), 4_294_960_000);
/// assert_eq!(clock.update(3), 4_294_967_296 + 3_000); // it has started again
/// assert_eq!(clock.update(4_294_966), 4_294_966_000); // this one came late
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UptimeClock {
    newest_us: Option<u64>,
}

impl UptimeClock {
    /// A clock that takes the first report as it is.
    #[must_use]
    pub const fn new() -> Self {
        Self { newest_us: None }
    }

    /// The uptime of a report in microseconds: exact to the millisecond, like the report.
    pub const fn update(&mut self, time_boot_ms: u32) -> u64 {
        let Some(newest) = self.newest_us else {
            let first = time_boot_ms as u64 * 1000;
            self.newest_us = Some(first);
            return first;
        };
        // Modulo 2^32 µs. A sender with a true clock of milliseconds is followed as well: its period of 2^32 ms is a
        // multiple.
        let (now, then) = (time_boot_ms.wrapping_mul(1000), (newest % PERIOD_US) as u32);
        let behind = then.wrapping_sub(now);
        if behind <= REORDERED_US {
            return newest.saturating_sub(behind as u64);
        }
        let uptime = newest.saturating_add(now.wrapping_sub(then) as u64);
        self.newest_us = Some(uptime);
        uptime
    }

    /// The newest uptime so far, in microseconds.
    #[must_use]
    pub const fn newest_us(&self) -> Option<u64> {
        self.newest_us
    }
}

/// The true age of a status in milliseconds, from [`Esc::age_ms`](field@crate::autoquad::Esc::age_ms).
///
/// AutoQuad takes the difference of two clocks of milliseconds modulo 2¹⁶ (`aq_mavlink.c`). For a status from before the
/// clock started again, that is 30409 too much. Real ages end at 3000, so it is seen and taken back; what fits neither is
/// given back as it is.
#[must_use]
pub const fn true_age_ms(age_ms: u16) -> u16 {
    let restarted = age_ms.wrapping_add((PERIOD_US / 1000 % (1 << 16)) as u16);
    if age_ms > OLDEST_MS && restarted <= OLDEST_MS { restarted } else { age_ms }
}
