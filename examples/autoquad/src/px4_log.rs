//! `autoquad px4-log`: the motor controllers in a log of PX4.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use mavlink_autoquad::px4::{EscStatus, Motor};
use mavlink_autoquad::wire::uorb::ulog::{End, Log, LogError, Samples};

use crate::csv::finish_table;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{Output, Overwriting};
use crate::time;

/// Shows the motor controllers in a PX4 ULog (.ulg) of any release: a summary of each, or every report as CSV.
///
/// A value that the log lacks is empty. Motor numbers exist since PX4 1.14; older logs have only the slot of a controller. Logs from
/// before August 2019 do not say which controllers answer. In logs of PX4 1.9, temperatures of DroneCAN controllers are in kelvin.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Px4Log {
    /// The ULog to read; `-` is standard input.
    log: PathBuf,
    /// Writes every report as CSV to standard output.
    #[arg(long)]
    csv: bool,
    /// Writes every report as CSV to this file; `-` is standard output.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    overwriting: Overwriting,
}

const AFTER_HELP: &str = "\
Examples:
  autoquad px4-log flight.ulg
  autoquad px4-log flight.ulg --csv > escs.csv
  autoquad px4-log flight.ulg --out escs.csv";

/// The columns of the CSV.
const HEADER: [&str; 15] = [
    "time (s)",
    "instance",
    "slot",
    "motor",
    "online",
    "armed",
    "speed (rpm)",
    "voltage (V)",
    "current (A)",
    "temperature (degC)",
    "motor temperature (degC)",
    "errors",
    "failures",
    "power (%)",
    "reported (s)",
];

impl Px4Log {
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let input = Input::open(&self.log)?;
        let name = input.name.clone();
        let bytes = input.read_whole()?;
        let log = Log::new(&bytes).map_err(|error| match error {
            LogError::NotALog => Failure::with(&name, format!("{error}; `autoquad csv` reads tlogs")),
            _ => Failure::with(&name, error),
        })?;
        let mut statuses = log.read::<EscStatus>();
        if self.csv || self.out.is_some() {
            let out = self.out.as_deref().unwrap_or(Path::new("-"));
            csv(&mut statuses, self.overwriting.whole(out, Some(&self.log))?)?;
        } else {
            let mut output = Output::standard();
            summary(&mut statuses, &mut output).and_then(|()| output.flush()).map_err(Failure::written)?;
        }
        say(&name, &statuses);
        Ok(())
    }
}

/// Says what could not be read of a log.
fn say(log: &str, statuses: &Samples<'_, EscStatus>) {
    let fit = statuses.fit();
    if !fit.is_exact() {
        eprintln!("autoquad: {log}: {fit}");
    }
    if statuses.unreadable() > 0 {
        eprintln!("autoquad: {log}: {} records could not be read", statuses.unreadable());
    }
    match statuses.end() {
        End::Truncated => eprintln!("autoquad: {log}: ends within a record, as after a crash"),
        End::Damaged { at } => {
            eprintln!("autoquad: {log}: is damaged at byte {at}; what follows was found again if it could be")
        }
        _ => {}
    }
}

/// Writes a row for each report.
fn csv(statuses: &mut Samples<'_, EscStatus>, output: Output) -> Result<(), Failure> {
    let mut table = ::csv::Writer::from_writer(output);
    table.write_record(HEADER).map_err(Failure::table)?;
    let mut rows = 0_u64;
    for (instance, status) in statuses {
        for motor in status.motors() {
            table.write_record(row(instance, &status, &motor)).map_err(Failure::table)?;
            rows += 1;
        }
    }
    finish_table(table, rows)
}

fn row(instance: u8, status: &EscStatus, motor: &Motor<'_>) -> [String; 15] {
    let report = motor.report;
    let known = |value: Option<f32>| value.map(|value| value.to_string()).unwrap_or_default();
    [
        time::seconds(status.timestamp),
        instance.to_string(),
        motor.slot.to_string(),
        motor.number.map(|number| number.to_string()).unwrap_or_default(),
        u8::from(motor.online).to_string(),
        u8::from(motor.armed).to_string(),
        report.esc_rpm.to_string(),
        known(report.esc_voltage()),
        known(report.esc_current()),
        known(report.esc_temperature()),
        report.motor_temperature.to_string(),
        report.esc_errorcount.to_string(),
        report.failures.to_string(),
        report.esc_power.to_string(),
        time::seconds(report.timestamp),
    ]
}

/// What a controller said in the whole log.
#[derive(Default)]
struct Summary {
    number: Option<u8>,
    reports: u64,
    online: u64,
    speed_sum: i64,
    speed_max: i32,
    voltage_min: Option<f32>,
    current_max: Option<f32>,
    temperature_max: Option<f32>,
    errors: u32,
    failures: String,
}

impl Summary {
    fn add(&mut self, status: &EscStatus, motor: &Motor<'_>) {
        let report = motor.report;
        // A log that does not say who answers says so of nobody.
        let answers = motor.online || status.esc_online_flags == 0;
        self.number = motor.number;
        self.reports += 1;
        self.online += u64::from(motor.online);
        self.speed_sum += i64::from(report.esc_rpm);
        self.speed_max = self.speed_max.max(report.esc_rpm);
        self.voltage_min = least(self.voltage_min, report.esc_voltage().filter(|_| answers), f32::min);
        self.current_max = least(self.current_max, report.esc_current(), f32::max);
        self.temperature_max = least(self.temperature_max, report.esc_temperature(), f32::max);
        self.errors = self.errors.max(report.esc_errorcount);
        if !report.failures.is_empty() {
            self.failures = report.failures.to_string();
        }
    }

    /// How often it answered, in percent, to the nearest; empty if it never did.
    fn percent_online(&self) -> String {
        match (self.online * 100 + self.reports / 2) / self.reports.max(1) {
            0 => String::new(),
            percent => format!("{percent}%"),
        }
    }
}

fn least(so_far: Option<f32>, value: Option<f32>, choose: fn(f32, f32) -> f32) -> Option<f32> {
    match (so_far, value) {
        (Some(one), Some(other)) => Some(choose(one, other)),
        (one, other) => one.or(other),
    }
}

/// Writes a line for each controller.
fn summary(statuses: &mut Samples<'_, EscStatus>, mut output: impl Write) -> io::Result<()> {
    let mut all = BTreeMap::<(u8, u8), Summary>::new();
    let (mut first_us, mut last_us) = (None, 0);
    for (instance, status) in statuses {
        first_us = first_us.or(Some(status.timestamp));
        last_us = status.timestamp;
        for motor in status.motors() {
            all.entry((instance, motor.slot)).or_default().add(&status, &motor);
        }
    }
    let Some(first_us) = first_us else { return writeln!(output, "no esc_status") };
    writeln!(output, "esc_status from {} to {} s", time::seconds(first_us), time::seconds(last_us))?;
    writeln!(
        output,
        "instance slot motor reports online  mean rpm   max rpm  min V  max A  max °C  errors  last failures"
    )?;
    let number = |value: Option<f32>| value.map(|value| format!("{value:.1}")).unwrap_or_default();
    for ((instance, slot), esc) in &all {
        let motor = esc.number.map(|number| number.to_string()).unwrap_or_default();
        let mean = esc.speed_sum / i64::try_from(esc.reports).unwrap_or(i64::MAX).max(1);
        writeln!(
            output,
            "{instance:>8} {slot:>4} {motor:>5} {:>7} {:>6} {mean:>9} {:>9} {:>6} {:>6} {:>7} {:>7}  {}",
            esc.reports,
            esc.percent_online(),
            esc.speed_max,
            number(esc.voltage_min),
            number(esc.current_max),
            number(esc.temperature_max),
            esc.errors,
            esc.failures
        )?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use mavlink_autoquad::wire::uorb::ulog::Writer;

    use super::*;

    /// A log of two reports of two motors, of which one has a fault.
    fn log() -> Vec<u8> {
        let mut log = Writer::new(Vec::new(), 0).topic::<EscStatus>().begin().unwrap();
        for (timestamp, rpm) in [(1_000_000, 4_000), (2_500_000, 6_001)] {
            let mut status = EscStatus { timestamp, esc_online_flags: 0b01, ..EscStatus::UNKNOWN };
            for (slot, function) in [102, 101].into_iter().enumerate() {
                status.esc[slot].actuator_function = function;
                status.esc[slot].esc_rpm = rpm;
            }
            status.esc[0].esc_voltage = 15.5;
            status.esc[1].failures = mavlink_autoquad::px4::EscFailures::MOTOR_STUCK;
            log.write(0, &status).unwrap();
        }
        log.finish().unwrap()
    }

    #[test]
    fn every_report_is_a_row() {
        let folder = tempfile::tempdir().unwrap();
        let (log, out) = (folder.path().join("flight.ulg"), folder.path().join("escs.csv"));
        std::fs::write(&log, self::log()).unwrap();
        Px4Log { log, csv: false, out: Some(out.clone()), overwriting: Overwriting::default() }.run().unwrap();
        let text = std::fs::read_to_string(out).unwrap();
        let rows: Vec<&str> = text.lines().collect();
        assert_eq!(rows.len(), 1 + 4);
        assert_eq!(rows[0].split(',').count(), HEADER.len());
        assert_eq!(rows[1], "1.000000,0,0,2,1,0,4000,15.5,,,0,0,0,0,0.000000");
        assert_eq!(rows[4], "2.500000,0,1,1,0,0,6001,,,,0,0,FAILURE_MOTOR_STUCK,0,0.000000");
    }

    #[test]
    fn the_log_is_not_overwritten() {
        let (folder, bytes) = (tempfile::tempdir().unwrap(), log());
        let log = folder.path().join("flight.ulg");
        std::fs::write(&log, &bytes).unwrap();
        let (out, overwriting) = (Some(log.clone()), Overwriting { force: true });
        assert!(Px4Log { log: log.clone(), csv: false, out, overwriting }.run().is_err());
        assert_eq!(std::fs::read(&log).unwrap(), bytes);
    }

    #[test]
    fn a_line_for_each_controller() {
        let (bytes, mut lines) = (log(), Vec::new());
        summary(&mut Log::new(&bytes).unwrap().read::<EscStatus>(), &mut lines).unwrap();
        let text = String::from_utf8(lines).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "esc_status from 1.000000 to 2.500000 s");
        assert_eq!(
            lines[2].split_whitespace().collect::<Vec<_>>(),
            ["0", "0", "2", "2", "100%", "5000", "6001", "15.5", "0"]
        );
        assert!(lines[3].ends_with("FAILURE_MOTOR_STUCK"), "{text}");
    }

    #[test]
    fn a_log_without_the_topic_says_so() {
        let (bytes, mut lines) = (Writer::new(Vec::new(), 0).begin().unwrap().finish().unwrap(), Vec::new());
        summary(&mut Log::new(&bytes).unwrap().read::<EscStatus>(), &mut lines).unwrap();
        assert_eq!(lines, b"no esc_status\n");
    }
}
