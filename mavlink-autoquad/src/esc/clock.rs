//! Time: the vehicle's clock, and the age of a status.

/// After how many microseconds the vehicle's clock starts again: 2³², which is 71 min 35 s.
const PERIOD_US: u64 = 1 << 32;

/// How far a report may lie from the newest, in microseconds, and be believed by itself.
const NEAR_US: u32 = 60_000_000;

/// From how many microseconds of delay on a report may be the first after a restart. A shorter delay does no harm.
const LONG_DELAY_US: u32 = 1_000_000;

/// Late reports in a row, each later than the one before, that are a restart.
const RUN: u8 = 3;

/// The longest silence, in microseconds, that is likelier than a restart when the vehicle's clock is near zero.
const SILENCE_US: u32 = 600_000_000;

/// The oldest status that the flight controller reports, in milliseconds: an older one becomes 65535.
const OLDEST_MS: u16 = 3000;

/// Makes the vehicle's uptime of [`AqEscTelemetry::time_boot_ms`](field@crate::autoquad::AqEscTelemetry::time_boot_ms),
/// which starts again every 71 min 35 s.
///
/// AutoQuad counts microseconds in 32 bits and divides by 1000 (`aq_mavlink.c`), so the field counts to 4294967 and not to
/// 2³². What a report means follows from where it lies beside the newest:
///
/// | the report is | it means |
/// |---|---|
/// | up to a minute ahead | the time has run on |
/// | up to a minute older | it comes late; three in a row with rising times, each more than a second late, are a restart of the vehicle |
/// | farther away | nothing; if the next report agrees, the time has run on or the vehicle has restarted, whichever is nearer |
///
/// One thing cannot be told from reports: a silence of more than half a turn of the clock. It looks like a restart.
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
    /// The clock of the last report, if that was too far away to be believed.
    doubted: Option<u32>,
    /// The clock of the last report that came late, and how many times the reports in a row had.
    late: Option<(u32, u8)>,
}

/// What a report says of the time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Report {
    /// It is the newest.
    Newest,
    /// It comes late, or with the newest.
    Late,
    /// It is far away from the others.
    Doubted,
    /// It is the newest, and the vehicle has restarted.
    Restarted,
}

impl UptimeClock {
    /// A clock that takes the first report as it is.
    #[must_use]
    pub const fn new() -> Self {
        Self { newest_us: None, doubted: None, late: None }
    }

    /// The uptime of a report in microseconds: exact to the millisecond, like the report.
    pub const fn update(&mut self, time_boot_ms: u32) -> u64 {
        self.judge(time_boot_ms).0
    }

    /// The newest uptime so far, in microseconds. It falls when the vehicle restarts.
    #[must_use]
    pub const fn newest_us(&self) -> Option<u64> {
        self.newest_us
    }

    /// The uptime of a report, and what it says.
    pub(super) const fn judge(&mut self, time_boot_ms: u32) -> (u64, Report) {
        let Some(newest) = self.newest_us else {
            return self.run_on(time_boot_ms as u64 * 1000, Report::Newest);
        };
        // Modulo 2^32 µs. A sender with a true clock of milliseconds is followed as well: its period of 2^32 ms is a
        // multiple.
        let (now, then) = (time_boot_ms.wrapping_mul(1000), (newest % PERIOD_US) as u32);
        let (ahead, behind) = (now.wrapping_sub(then), then.wrapping_sub(now));
        if behind <= NEAR_US {
            return self.come_late(time_boot_ms, newest, behind);
        }
        let uptime = newest.saturating_add(ahead as u64);
        if ahead <= NEAR_US {
            return self.run_on(uptime, Report::Newest);
        }
        let restarted = behind < ahead || (now <= NEAR_US && ahead > SILENCE_US);
        let (uptime, report) =
            if restarted { (time_boot_ms as u64 * 1000, Report::Restarted) } else { (uptime, Report::Newest) };
        match self.doubted {
            Some(first) if now.wrapping_sub(first) <= NEAR_US => self.run_on(uptime, report),
            _ => {
                self.doubted = Some(now);
                (uptime, Report::Doubted)
            }
        }
    }

    const fn run_on(&mut self, uptime: u64, report: Report) -> (u64, Report) {
        *self = Self { newest_us: Some(uptime), doubted: None, late: None };
        (uptime, report)
    }

    const fn come_late(&mut self, time_boot_ms: u32, newest: u64, behind: u32) -> (u64, Report) {
        let now = time_boot_ms.wrapping_mul(1000);
        self.doubted = None;
        if behind == 0 {
            self.late = None;
        } else if behind > LONG_DELAY_US {
            let times = match self.late {
                Some((last, times)) if last == now => times,
                // Both lie within the minute before the newest: the difference is small, or wraps.
                Some((last, times)) if now.wrapping_sub(last) <= NEAR_US => times + 1,
                _ => 1,
            };
            if times >= RUN {
                return self.run_on(time_boot_ms as u64 * 1000, Report::Restarted);
            }
            self.late = Some((now, times));
        }
        (newest.saturating_sub(behind as u64), Report::Late)
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
