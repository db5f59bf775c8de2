//! All controllers of a vehicle, put together from batches of four.

use super::clock::{Report, UptimeClock, true_age_ms};
use crate::autoquad::{AqEscTelemetry, Esc, Esc32Status};
use crate::wire;

/// Controllers that one vehicle can have: motor ports 1 to 16.
pub const MAX_ESCS: usize = 16;

/// The age from which PX4 takes a controller on CAN for offline (`uavcan/actuators/esc.cpp`), in milliseconds.
pub const ONLINE_LIMIT_MS: u64 = 1200;

/// Controllers in a message.
const BATCH: u8 = 4;

/// Batches of one cycle carry the same time (`aq_mavlink.c`); a simulator may take it anew for each. Cycles are 5 ms apart
/// or more, the rate being 200 Hz at most.
const CYCLE_US: u64 = 2_000;

/// The controllers of one vehicle: for each its place, its last status and how old that is.
///
/// The table is fed with every [`AqEscTelemetry`] of one system, in the order of arrival. Batches may be lost, repeated or
/// out of order. All times are the vehicle's uptime in microseconds. For ages on a link that may fall silent, take
/// [`EscTable::uptime_us`] plus what has passed since the last message by a clock of your own.
///
/// A vehicle that restarts is noticed at its second or third message, by the rules of [`UptimeClock`]: what was known of its
/// controllers is void then.
#[derive(Clone, Copy, Debug)]
pub struct EscTable {
    /// By index.
    rows: [Option<EscRow>; MAX_ESCS],
    clock: UptimeClock,
    cycle: Cycle,
    counts: Counts,
}

/// One controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EscRow {
    /// Motor port, 1 to 16.
    pub id: u8,
    /// Place among the motors in use, from 0; the index that common's messages mean.
    pub index: u8,
    /// The last known status; `None` if there has been none yet.
    pub status: Option<Esc32Status>,
    /// The vehicle's uptime when the flight controller received that status, in microseconds; 0 if there has been none.
    pub received_us: u64,
    /// The newest report has no status: the controller has been silent for a second or more, or has no telemetry.
    pub silent: bool,
    reported_us: u64,
}

/// The batches that belong together.
#[derive(Clone, Copy, Debug)]
struct Cycle {
    /// Of its first batch.
    uptime_us: u64,
    /// 0 before the first.
    num_motors: u8,
    /// One bit a batch.
    seen: u8,
}

/// What an [`EscTable`] did with a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Update {
    /// Rows are new, and other batches of the cycle are missing.
    Partial,
    /// Rows are new, and with them the cycle is complete.
    Complete,
    /// Nothing is new: the batch was there already.
    Repeated,
    /// The batch belongs to an earlier cycle. Of its rows those are new that have not been reported since.
    Late,
    /// Nothing is new: the message is dated more than a minute away from the others. It is believed when the next one agrees.
    Doubted,
    /// The vehicle has restarted: what was known is void, and the rows of this message are all.
    Restarted,
    /// Nothing is new: the message contradicts itself.
    Invalid,
}

/// What an [`EscTable`] has seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Counts {
    /// Complete cycles; after 65535 comes 0.
    pub cycles: u16,
    /// Batches that were missing when the next cycle began, those that came late after all included. Cycles that are
    /// missing as a whole are not known of.
    pub lost: u32,
    /// Batches that came again.
    pub repeated: u32,
    /// Batches that came after a batch of a later cycle.
    pub late: u32,
    /// Messages that were dated more than a minute away from the others.
    pub doubted: u32,
    /// Restarts of the vehicle.
    pub restarts: u32,
    /// Messages that contradict themselves, and controllers with a motor port that does not exist.
    pub invalid: u32,
}

wire::record!(EscRow { id, index, status, received_us, silent, reported_us });
wire::variants!(Update { Partial, Complete, Repeated, Late, Doubted, Restarted, Invalid });
wire::record!(Counts { cycles, lost, repeated, late, doubted, restarts, invalid });

impl Default for EscTable {
    fn default() -> Self {
        Self::new()
    }
}

impl EscTable {
    /// A table without controllers.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            rows: [None; MAX_ESCS],
            clock: UptimeClock::new(),
            cycle: Cycle { uptime_us: 0, num_motors: 0, seen: 0 },
            counts: Counts { cycles: 0, lost: 0, repeated: 0, late: 0, doubted: 0, restarts: 0, invalid: 0 },
        }
    }

    /// Takes a message in.
    pub fn update(&mut self, telemetry: &AqEscTelemetry) -> Update {
        if !is_consistent(telemetry) {
            return self.invalid();
        }
        let (uptime, report) = self.clock.judge(telemetry.time_boot_ms);
        match report {
            Report::Newest | Report::Late => self.update_at(uptime, telemetry),
            Report::Doubted => {
                self.counts.doubted = self.counts.doubted.saturating_add(1);
                Update::Doubted
            }
            Report::Restarted => {
                let restarts = self.counts.restarts.saturating_add(1);
                *self = Self { clock: self.clock, counts: Counts { restarts, ..self.counts }, ..Self::new() };
                self.update_at(uptime, telemetry);
                Update::Restarted
            }
        }
    }

    fn update_at(&mut self, uptime: u64, telemetry: &AqEscTelemetry) -> Update {
        let known = self.cycle.num_motors != 0;
        if known && uptime.saturating_add(CYCLE_US) < self.cycle.uptime_us {
            self.counts.late = self.counts.late.saturating_add(1);
            if telemetry.num_motors == self.cycle.num_motors {
                self.report(telemetry, uptime);
            }
            return Update::Late;
        }
        if !known || uptime > self.cycle.uptime_us.saturating_add(CYCLE_US) {
            self.begin_cycle(telemetry, uptime);
        } else if telemetry.num_motors != self.cycle.num_motors {
            return self.invalid();
        }
        self.take(telemetry, uptime)
    }

    /// The controller at a motor port; `None` if it has not been reported.
    #[must_use]
    pub fn get(&self, id: u8) -> Option<&EscRow> {
        self.iter_by_index().find(|row| row.id == id)
    }

    /// The controller at a place among the motors in use, from 0; `None` if it has not been reported.
    #[must_use]
    pub fn at_index(&self, index: u8) -> Option<&EscRow> {
        self.rows.get(usize::from(index))?.as_ref()
    }

    /// All controllers that have been reported, by motor port.
    pub fn iter(&self) -> impl Iterator<Item = &EscRow> {
        (1..=MAX_ESCS as u8).filter_map(|id| self.get(id))
    }

    /// All controllers that have been reported, by their place among the motors in use.
    pub fn iter_by_index(&self) -> impl Iterator<Item = &EscRow> {
        self.rows.iter().flatten()
    }

    /// Motors in use, 1 to 16; 0 before the first message.
    #[must_use]
    pub const fn num_motors(&self) -> u8 {
        self.cycle.num_motors
    }

    /// The vehicle's uptime at the newest message, in microseconds; 0 before the first.
    #[must_use]
    pub fn uptime_us(&self) -> u64 {
        self.clock.newest_us().unwrap_or_default()
    }

    /// What the table has seen.
    #[must_use]
    pub const fn counts(&self) -> Counts {
        self.counts
    }

    fn invalid(&mut self) -> Update {
        self.counts.invalid = self.counts.invalid.saturating_add(1);
        Update::Invalid
    }

    /// Other motors in use are other places: what is known of them is void.
    fn begin_cycle(&mut self, telemetry: &AqEscTelemetry, uptime: u64) {
        if self.cycle.num_motors != 0 {
            let missing = batches(self.cycle.num_motors).saturating_sub(self.cycle.seen.count_ones() as u8);
            self.counts.lost = self.counts.lost.saturating_add(u32::from(missing));
        }
        if telemetry.num_motors != self.cycle.num_motors {
            self.rows = [None; MAX_ESCS];
        }
        self.cycle = Cycle { uptime_us: uptime, num_motors: telemetry.num_motors, seen: 0 };
    }

    /// Takes a batch of the cycle.
    fn take(&mut self, telemetry: &AqEscTelemetry, uptime: u64) -> Update {
        let bit = 1 << (telemetry.seq - 1);
        if self.cycle.seen & bit != 0 {
            self.counts.repeated = self.counts.repeated.saturating_add(1);
            return Update::Repeated;
        }
        self.cycle.seen |= bit;
        self.report(telemetry, uptime);
        if self.cycle.seen.count_ones() < u32::from(batches(telemetry.num_motors)) {
            return Update::Partial;
        }
        self.counts.cycles = self.counts.cycles.wrapping_add(1);
        Update::Complete
    }

    fn report(&mut self, telemetry: &AqEscTelemetry, uptime: u64) {
        for (index, esc) in ((telemetry.seq - 1) * BATCH..).zip(telemetry.escs()) {
            if (1..=MAX_ESCS).contains(&usize::from(esc.id)) {
                self.report_one(index, &esc, uptime);
            } else {
                self.invalid();
            }
        }
    }

    fn report_one(&mut self, index: u8, esc: &Esc, uptime: u64) {
        let known = self.get(esc.id).copied();
        let newest = [known.as_ref(), self.at_index(index)].into_iter().flatten().map(|row| row.reported_us).max();
        if newest.is_some_and(|newest| newest > uptime) {
            return;
        }
        // The same motor port is not at two places.
        for row in &mut self.rows {
            *row = row.filter(|row| row.id != esc.id);
        }
        let (status, received_us) = match (esc.status, known) {
            (Some(status), _) => (Some(status), uptime.saturating_sub(age_us(esc))),
            (None, Some(row)) => (row.status, row.received_us),
            (None, None) => (None, 0),
        };
        if let Some(row) = self.rows.get_mut(usize::from(index)) {
            let silent = esc.status.is_none();
            *row = Some(EscRow { id: esc.id, index, status, received_us, silent, reported_us: uptime });
        }
    }
}

impl EscRow {
    /// How old the last known status is at an uptime in microseconds, in milliseconds; `None` if there has been none.
    #[must_use]
    pub fn age_ms(&self, now_us: u64) -> Option<u64> {
        self.status.map(|_| now_us.saturating_sub(self.received_us) / 1000)
    }

    /// Whether the controller is reported with a status, and that is younger than the limit, at an uptime in microseconds.
    ///
    /// The flight controller makes the words of a silent controller zero after a second and its age 65535 after three
    /// (`motors.c`): what is between looks fresher than it is, but has no status.
    #[must_use]
    pub fn is_online(&self, now_us: u64, limit_ms: u64) -> bool {
        !self.silent && self.age_ms(now_us).is_some_and(|age| age < limit_ms)
    }
}

fn age_us(esc: &Esc) -> u64 {
    u64::from(true_age_ms(esc.age_ms.unwrap_or_default())) * 1000
}

/// Batches of a cycle.
const fn batches(num_motors: u8) -> u8 {
    num_motors.div_ceil(BATCH)
}

/// Whether a batch of these motors has this number, and no more elements than there are.
fn is_consistent(telemetry: &AqEscTelemetry) -> bool {
    let AqEscTelemetry { seq, num_motors, num_in_seq, .. } = *telemetry;
    (1..=MAX_ESCS).contains(&usize::from(num_motors))
        && (1..=batches(num_motors)).contains(&seq)
        && (1..=BATCH).contains(&num_in_seq)
}
