//! A table for each vehicle, shown once a second of its clock.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::time::{Duration, Instant};

use mavlink_autoquad::autoquad::{AqEscTelemetry, Esc32Status};
use mavlink_autoquad::esc::{DisarmReason, EscRow, EscTable, ONLINE_LIMIT_MS, Update};
use mavlink_autoquad::wire::{Frame, SystemId};

const SECOND_US: u64 = 1_000_000;

/// The vehicles, by system id, and where they are shown.
pub(crate) struct Display<W> {
    vehicles: BTreeMap<SystemId, Vehicle>,
    output: W,
}

struct Vehicle {
    table: EscTable,
    shown_us: Option<u64>,
    heard: Instant,
}

impl<W: Write> Display<W> {
    pub(crate) fn new(output: W) -> Self {
        Self { vehicles: BTreeMap::new(), output }
    }

    /// Takes a frame in, and shows its vehicle if it is time to.
    pub(crate) fn receive(&mut self, frame: &Frame<'_>) -> io::Result<()> {
        let Some(telemetry) = frame.decode::<AqEscTelemetry>() else { return Ok(()) };
        let heard = Instant::now();
        let vehicle = self.vehicles.entry(frame.system_id());
        let vehicle = vehicle.or_insert_with(|| Vehicle { table: EscTable::new(), shown_us: None, heard });
        vehicle.heard = heard;
        let update = vehicle.table.update(&telemetry);
        let now_us = vehicle.table.uptime_us();
        if update == Update::Restarted {
            vehicle.shown_us = None;
        }
        // With a batch missing, a cycle is never complete.
        let patience = if update == Update::Complete { SECOND_US } else { 2 * SECOND_US };
        if *vehicle.shown_us.get_or_insert(now_us.saturating_sub(SECOND_US)) + patience > now_us {
            return Ok(());
        }
        vehicle.shown_us = Some(now_us);
        show(&mut self.output, frame.system_id(), &vehicle.table, now_us)
    }

    /// Shows the vehicles that have not been heard for so long.
    pub(crate) fn show_silent(&mut self, limit: Duration) -> io::Result<()> {
        for (&system_id, Vehicle { table, heard, .. }) in &self.vehicles {
            let silence = heard.elapsed();
            if silence >= limit {
                let silence_us = u64::try_from(silence.as_micros()).unwrap_or(u64::MAX);
                show(&mut self.output, system_id, table, table.uptime_us().saturating_add(silence_us))?;
            }
        }
        Ok(())
    }
}

fn show(output: &mut impl Write, system_id: SystemId, table: &EscTable, now_us: u64) -> io::Result<()> {
    let (seconds, counts) = (now_us / SECOND_US, table.counts());
    let (hours, minutes, seconds) = (seconds / 3600, seconds / 60 % 60, seconds % 60);
    let (motors, cycles, lost) = (table.num_motors(), counts.cycles, counts.lost);
    writeln!(
        output,
        "vehicle {system_id}, up {hours}:{minutes:02}:{seconds:02}: {motors} motors, cycle {cycles}, {lost} batches lost"
    )?;
    for row in table.iter() {
        show_row(output, row, now_us)?;
    }
    output.flush()
}

fn show_row(output: &mut impl Write, row: &EscRow, now_us: u64) -> io::Result<()> {
    let (id, Some(status), Some(age)) = (row.id, row.status, row.age_ms(now_us)) else {
        return writeln!(output, "{:>4}  no telemetry", row.id);
    };
    let state = status.state().to_string();
    let (state, volts, amperes) = (state.trim_start_matches("ESC32_STATE_"), status.voltage(), status.current());
    let (rpm, duty, third) = (status.rpm(), status.duty(), temperature_or_errors(status));
    write!(
        output,
        "{id:>4}  {volts:5.2} V  {amperes:6.2} A  {rpm:>5} rpm  {duty:3.0} %  {third:>10}  {state:<8}  {age:>4} ms old"
    )?;
    if !row.is_online(now_us, ONLINE_LIMIT_MS) {
        write!(output, "  WARNING: silent")?;
    } else if let Some(reason) = DisarmReason::of(status).filter(|reason| reason.is_fault()) {
        write!(output, "  WARNING: disarmed, {reason}")?;
    }
    writeln!(output)
}

/// Version 3 measures the one, version 2 counts the other.
fn temperature_or_errors(status: Esc32Status) -> String {
    let temperature = status.temperature().map(|degrees| format!("{degrees:.2} °C"));
    temperature.or_else(|| status.errors().map(|errors| format!("{errors} errors"))).unwrap_or_default()
}
