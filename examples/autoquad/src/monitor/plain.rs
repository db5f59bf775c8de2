//! Lines instead of a screen, for pipes and files.

use std::io::{self, Write};

use mavlink_autoquad::esc::Update;
use mavlink_autoquad::wire::SystemId;

use super::fleet::{Fleet, Shown, age_text};
use super::limits::Limits;
use crate::telemetry::power_w;
use crate::time::{self, SECOND_US};

/// Prints each vehicle once a second.
pub(super) struct Plain<W> {
    output: W,
    limits: Limits,
    /// When each vehicle was printed last.
    printed: std::collections::BTreeMap<SystemId, u64>,
}

impl<W: Write> Plain<W> {
    pub(super) const fn new(output: W, limits: Limits) -> Self {
        Self { output, limits, printed: std::collections::BTreeMap::new() }
    }

    /// Prints a vehicle that was updated at a time, if it is due.
    pub(super) fn updated(
        &mut self,
        fleet: &Fleet,
        (system, update): (SystemId, Update),
        now_us: u64,
    ) -> io::Result<()> {
        // With a batch missing, a cycle is never complete.
        let patience_us = if update == Update::Complete { SECOND_US } else { 2 * SECOND_US };
        let last_us = self.printed.get(&system).copied();
        if update == Update::Restarted || last_us.is_none_or(|last| now_us.abs_diff(last) >= patience_us) {
            self.print(fleet, system, now_us)?;
        }
        Ok(())
    }

    /// Prints the vehicles that have not been heard for a while: how they age.
    pub(super) fn silent(&mut self, fleet: &Fleet, now_us: u64) -> io::Result<()> {
        let due: Vec<SystemId> =
            self.printed.iter().filter(|&(_, &then)| now_us >= then + 2 * SECOND_US).map(|(&id, _)| id).collect();
        due.into_iter().try_for_each(|system| self.print(fleet, system, now_us))
    }

    fn print(&mut self, fleet: &Fleet, system: SystemId, now_us: u64) -> io::Result<()> {
        let Some(vehicle) = fleet.vehicles.get(&system) else { return Ok(()) };
        self.printed.insert(system, now_us);
        let (time, shown) = (time::iso(now_us).unwrap_or_default(), vehicle.shown(now_us, &self.limits));
        let totals = vehicle.totals(&shown);
        let (rate, _) = fleet.rate(now_us);
        writeln!(
            self.output,
            "{time} vehicle {system}: {}/{} on, {:.2} A, {:.1} W, mean {:.2} V; {}; {rate:.0} msg/s, {:.1} % lost",
            totals.online,
            totals.motors,
            totals.current_a,
            totals.power_w,
            totals.mean_v,
            vehicle.summary(now_us).replace("  ", ", "),
            fleet.lost_percent(),
        )?;
        for shown in &shown {
            writeln!(self.output, "{time} vehicle {system} esc {}: {}", shown.port, line(shown))?;
        }
        self.output.flush()
    }
}

/// `RUNNING 15.12 V 8.73 A 132.0 W 6543 rpm 50 % 31.25 °C 4 ms`
fn line(shown: &Shown) -> String {
    let mut parts = vec![shown.state.clone()];
    if let Some(status) = shown.status {
        let (volts, amperes, watts) = (status.voltage(), status.current(), power_w(status));
        parts.push(format!("{volts:.2} V {amperes:.2} A {watts:.1} W {} rpm {:.0} %", status.rpm(), status.duty()));
        parts.extend(status.temperature().map(|degrees| format!("{degrees:.2} °C")));
        parts.extend(status.errors().map(|errors| format!("{errors} errors")));
        parts.extend(shown.age_ms.map(age_text));
    }
    parts.extend(shown.trouble.as_ref().map(|trouble| format!("WARNING: {trouble}")));
    parts.join(" ")
}
