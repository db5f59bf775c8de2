//! `autoquad csv`: a recording as a table.

use std::collections::BTreeMap;
use std::path::PathBuf;

use clap::Args;
use mavlink_autoquad::autoquad::{AqEscTelemetry, Esc};
use mavlink_autoquad::esc::{UptimeClock, true_age_ms};
use mavlink_autoquad::wire::SystemId;

use crate::failure::Failure;
use crate::output::{Output, Overwriting};
use crate::recording::Recording;
use crate::telemetry::{Firmware, fault, power_w, state};
use crate::time;

/// Writes the motor telemetry of a recording as a table: a row for each report of each controller.
///
/// The header has the units. Each row has its time twice, in ISO 8601 and as seconds since 1970, both in UTC, and the vehicle's
/// uptime, which is corrected for the wrap of its clock after 71 minutes. Values that a controller did not report are empty: a
/// silent one has no values, and firmware 2 has no temperature.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Csv {
    /// The recording, a tlog; `-` is standard input.
    log: PathBuf,
    /// The table to write; `-` is standard output.
    #[arg(long, value_name = "FILE", default_value = "-")]
    out: PathBuf,
    #[command(flatten)]
    overwriting: Overwriting,
    /// The time when the recording began, if the recorder's clock was wrong. The first entry gets this time; the others keep
    /// their distance from it.
    #[arg(long, value_name = "TIME", value_parser = time::parse)]
    epoch: Option<u64>,
    #[command(flatten)]
    firmware: Firmware,
}

const AFTER_HELP: &str = "\
Examples:
  autoquad csv flight.tlog > flight.csv
  autoquad csv flight.tlog --out flight.csv --epoch 2016-04-30T12:00:00Z
  autoquad csv flight.tlog --epoch 0          (seconds since the recording began)
  gunzip -c flight.tlog.gz | autoquad csv -";

/// The columns.
const HEADER: [&str; 15] = [
    "time",
    "unix_time (s)",
    "uptime (s)",
    "system_id",
    "esc",
    "state",
    "voltage (V)",
    "current (A)",
    "power (W)",
    "speed (rpm)",
    "duty (%)",
    "temperature (degC)",
    "errors",
    "fault",
    "age (ms)",
];

impl Csv {
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let mut recording = Recording::open(&self.log)?;
        let mut table = ::csv::Writer::from_writer(self.overwriting.whole(&self.out, Some(&self.log))?);
        table.write_record(HEADER).map_err(Failure::table)?;
        let (mut rows, mut begin_us) = (0_u64, None);
        let mut clocks = BTreeMap::<SystemId, UptimeClock>::new();
        while let Some(entry) = recording.read()? {
            begin_us = begin_us.or(entry.time_us);
            let Some(telemetry) = self.firmware.telemetry(&entry.frame) else { continue };
            let system = entry.frame.system_id();
            let uptime_us = clocks.entry(system).or_default().update(telemetry.time_boot_ms);
            let time_us = entry.time_us.map(|time_us| self.shifted(time_us, begin_us));
            for row in rows_of(&telemetry, time_us, uptime_us, system) {
                table.write_record(row).map_err(Failure::table)?;
                rows += 1;
            }
        }
        let name = recording.name.clone();
        recording.finish();
        if rows == 0 {
            eprintln!("autoquad: {name}: has no motor telemetry (AQ_ESC_TELEMETRY)");
        }
        finish_table(table, rows)
    }

    /// The time of an entry, as if the recording had begun when the user says.
    fn shifted(&self, time_us: u64, begin_us: Option<u64>) -> u64 {
        match (self.epoch, begin_us) {
            (Some(epoch), Some(begin)) => epoch.saturating_add(time_us).saturating_sub(begin),
            _ => time_us,
        }
    }
}

/// Ends a table, and says how many rows it has.
pub(crate) fn finish_table(table: ::csv::Writer<Output>, rows: u64) -> Result<(), Failure> {
    let output = table.into_inner().map_err(|error| Failure::written(error.into_error()))?;
    output.finish_saying(format_args!("{rows} rows written"))
}

fn rows_of(
    telemetry: &AqEscTelemetry,
    time_us: Option<u64>,
    uptime_us: u64,
    system: SystemId,
) -> impl Iterator<Item = [String; 15]> {
    let (iso, unix) = (time_us.and_then(time::iso).unwrap_or_default(), time_us.map(time::seconds).unwrap_or_default());
    let front = [iso, unix, time::seconds(uptime_us), system.to_string()];
    telemetry.escs().map(move |esc| row(front.clone(), &esc))
}

fn row([iso, unix, uptime, system]: [String; 4], esc: &Esc) -> [String; 15] {
    let value = |text: Option<String>| text.unwrap_or_default();
    let status = esc.status;
    [
        iso,
        unix,
        uptime,
        system,
        esc.id.to_string(),
        status.map_or_else(|| "SILENT".to_owned(), |status| state(status.state())),
        value(status.map(|status| format!("{:.2}", status.voltage()))),
        value(status.map(|status| format!("{:.2}", status.current()))),
        value(status.map(|status| format!("{:.1}", power_w(status)))),
        value(status.map(|status| status.rpm().to_string())),
        value(status.map(|status| format!("{:.1}", status.duty()))),
        value(status.and_then(|status| status.temperature()).map(|degrees| format!("{degrees:.2}"))),
        value(status.and_then(|status| status.errors()).map(|errors| errors.to_string())),
        value(status.and_then(fault).map(|reason| reason.to_string())),
        value(esc.age_ms.map(|age| true_age_ms(age).to_string())),
    ]
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::simulate::flight;

    fn table(arguments: impl FnOnce(&mut Csv)) -> Vec<BTreeMap<String, String>> {
        let folder = tempfile::tempdir().unwrap();
        let (log, out) = (folder.path().join("flight.tlog"), folder.path().join("flight.csv"));
        flight(&log, 6, 20, 1_462_017_600_000_000);
        let mut csv = Csv {
            log,
            out: out.clone(),
            overwriting: Overwriting::default(),
            epoch: None,
            firmware: Firmware::default(),
        };
        arguments(&mut csv);
        csv.run().unwrap();
        let mut reader = ::csv::Reader::from_reader(fs::File::open(out).unwrap());
        let header = reader.headers().unwrap().clone();
        assert_eq!(header.iter().collect::<Vec<_>>(), HEADER);
        let pairs =
            |row: ::csv::StringRecord| header.iter().map(str::to_owned).zip(row.iter().map(str::to_owned)).collect();
        reader.records().map(|row| pairs(row.unwrap())).collect()
    }

    #[test]
    fn a_row_for_each_report_of_each_controller() {
        let rows = table(|_| ());
        // Ten times a second for twenty seconds, and once at their end.
        assert_eq!(rows.len(), 201 * 6);
        assert_eq!(
            (rows[0]["time"].as_str(), rows[0]["unix_time (s)"].as_str()),
            ("2016-04-30T12:00:00.000000Z", "1462017600.000000")
        );
        assert_eq!(rows[6]["uptime (s)"], "12.100000");
        for row in &rows {
            let counts = row["esc"] == "4";
            match row["state"].as_str() {
                "SILENT" => assert!(row["voltage (V)"].is_empty() && row["speed (rpm)"].is_empty()),
                _ => assert_eq!((row["errors"].is_empty(), row["temperature (degC)"].is_empty()), (!counts, counts)),
            }
        }
        for state in ["DISARMED", "STARTING", "RUNNING", "SILENT"] {
            assert!(rows.iter().any(|row| row["state"] == state), "{state}");
        }
        assert!(
            rows.iter()
                .any(|row| row["fault"] == "no zero crossing in time" || row["fault"] == "zero crossings missed")
        );
    }

    #[test]
    fn a_recording_begins_when_the_user_says() {
        let rows = table(|csv| csv.epoch = Some(0));
        assert_eq!(
            (rows[0]["time"].as_str(), rows[0]["unix_time (s)"].as_str()),
            ("1970-01-01T00:00:00.000000Z", "0.000000")
        );
        assert_eq!(rows[6]["unix_time (s)"], "0.100000");
    }

    #[test]
    fn what_is_no_recording_is_said() {
        let folder = tempfile::tempdir().unwrap();
        for (bytes, said) in [(&b""[..], "is empty"), (b"a diary", "no MAVLink frame in 7 bytes")] {
            let log = folder.path().join("flight.tlog");
            fs::write(&log, bytes).unwrap();
            let out = folder.path().join(format!("{}.csv", bytes.len()));
            let csv = Csv { log, out, overwriting: Overwriting::default(), epoch: None, firmware: Firmware::default() };
            let Err(Failure::Sentence(sentence)) = csv.run() else { panic!("read") };
            assert!(sentence.contains(said), "{sentence}");
            assert!(!csv.out.exists());
        }
    }
}
