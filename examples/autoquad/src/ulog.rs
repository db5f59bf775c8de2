//! `autoquad ulog`: a recording as a log of PX4.

use std::collections::BTreeMap;
use std::path::PathBuf;

use clap::Args;
use mavlink_autoquad::autoquad::AqEscTelemetry;
use mavlink_autoquad::esc::{Conversion, EscTable, Update};
use mavlink_autoquad::px4::{EscStatus, MAX_ESCS};
use mavlink_autoquad::wire::SystemId;
use mavlink_autoquad::wire::uorb::ulog::{DataWriter, Writer};

use crate::failure::Failure;
use crate::input::named_after;
use crate::output::{Output, Overwriting};
use crate::recording::Recording;
use crate::telemetry::Firmware;

/// Instances of a topic that PX4's tools read.
const INSTANCES: u8 = 10;

/// Writes the motor telemetry of a recording as a PX4 ULog, for PlotJuggler, pyulog or Flight Review.
///
/// The log has the topic `esc_status`, with one instance for each AutoQuad. Its times count from the vehicle's start. PX4 knows 12
/// motors: of more than 12, the first 12 are written.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Ulog {
    /// The recording, a tlog; `-` is standard input.
    log: PathBuf,
    /// The ULog to write; `-` is standard output. By default, the recording's name with .ulg.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    overwriting: Overwriting,
    #[command(flatten)]
    firmware: Firmware,
}

const AFTER_HELP: &str = "\
Examples:
  autoquad ulog flight.tlog                   (flight.ulg)
  autoquad ulog flight.tlog --out px4.ulg --force";

/// A vehicle of the recording.
#[derive(Default)]
struct Vehicle {
    table: EscTable,
    /// What is added to its uptime, so that the log's time runs on where the vehicle has restarted. In µs.
    offset_us: u64,
    /// The time of the last message that was written.
    last_us: u64,
}

impl Ulog {
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let mut recording = Recording::open(&self.log)?;
        let mut vehicles = BTreeMap::<SystemId, (usize, Vehicle)>::new();
        let (mut log, mut written) = (None::<DataWriter<Output>>, 0_u64);
        while let Some(entry) = recording.read()? {
            let Some(telemetry) = self.firmware.telemetry(&entry.frame) else { continue };
            let known = vehicles.len();
            let (instance, vehicle) =
                vehicles.entry(entry.frame.system_id()).or_insert_with(|| (known, Vehicle::default()));
            let Some(instance) = u8::try_from(*instance).ok().filter(|instance| *instance < INSTANCES) else {
                continue;
            };
            let Some(status) = vehicle.update(&telemetry) else { continue };
            let log = match &mut log {
                Some(log) => log,
                None => log.insert(self.begin(status.timestamp)?),
            };
            log.write(instance, &status).map_err(Failure::written)?;
            written += 1;
        }
        let name = recording.name.clone();
        recording.finish();
        let Some(log) = log else {
            return Err(Failure::with(name, "has no motor telemetry (AQ_ESC_TELEMETRY)"));
        };
        log.finish().map_err(Failure::written)?.finish_saying(format_args!("{written} messages written"))?;
        for (system, (_, vehicle)) in vehicles {
            let motors = vehicle.table.num_motors();
            if motors > MAX_ESCS {
                eprintln!("autoquad: system {system} has {motors} motors, of which PX4 knows {MAX_ESCS}");
            }
        }
        Ok(())
    }

    fn begin(&self, start_us: u64) -> Result<DataWriter<Output>, Failure> {
        let out = self.out.clone().unwrap_or_else(|| named_after(&self.log, "ulg"));
        let output = self.overwriting.whole(&out, Some(&self.log))?.of_bytes()?;
        let log = Writer::new(output, start_us).info("sys_name", "AutoQuad").topic::<EscStatus>();
        log.begin().map_err(Failure::written)
    }
}

impl Vehicle {
    /// Takes telemetry in; gives what PX4 would publish once a round of all controllers is complete, or its last batch is there.
    fn update(&mut self, telemetry: &AqEscTelemetry) -> Option<EscStatus> {
        let update = self.table.update(telemetry);
        if update == Update::Restarted {
            self.offset_us = self.last_us;
        }
        let is_last = telemetry.seq == telemetry.num_motors.div_ceil(4);
        let is_round = matches!(update, Update::Complete | Update::Restarted) || update == Update::Partial && is_last;
        if !is_round {
            return None;
        }
        let mut status = self.table.to_px4(self.table.uptime_us(), &Conversion::DEFAULT);
        for time in std::iter::once(&mut status.timestamp).chain(status.esc.iter_mut().map(|esc| &mut esc.timestamp)) {
            // Zero is what has not been heard.
            *time = if *time == 0 { 0 } else { time.saturating_add(self.offset_us) };
        }
        self.last_us = status.timestamp;
        Some(status)
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use mavlink_autoquad::wire::uorb::ulog::{End, Log};

    use super::*;
    use crate::simulate::flight;

    fn converted(motors: u8) -> (tempfile::TempDir, Vec<u8>) {
        let folder = tempfile::tempdir().unwrap();
        let log = folder.path().join("flight.tlog");
        flight(&log, motors, 20, 1_462_017_600_000_000);
        let ulog = Ulog { log, out: None, overwriting: Overwriting::default(), firmware: Firmware::default() };
        ulog.run().unwrap();
        let bytes = fs::read(folder.path().join("flight.ulg")).unwrap();
        (folder, bytes)
    }

    #[test]
    fn a_message_for_each_round_of_controllers() {
        let (_folder, bytes) = converted(6);
        let mut samples = Log::new(&bytes).unwrap().read::<EscStatus>();
        let read: Vec<_> = samples.by_ref().collect();
        assert_eq!((read.len(), samples.unreadable(), samples.end()), (201, 0, End::Complete));
        assert!(read.is_sorted_by(|(_, one), (_, next)| one.timestamp < next.timestamp));
        assert!(read.iter().all(|(instance, status)| *instance == 0 && status.esc_count == 6));
        assert!(read.iter().any(|(_, status)| status.motors().any(|motor| !motor.report.failures.is_empty())));
    }

    #[test]
    fn the_recording_is_not_overwritten() {
        let (folder, _) = converted(6);
        let log = folder.path().join("flight.tlog");
        let (before, out) = (fs::read(&log).unwrap(), Some(log.clone()));
        let forced = Overwriting { force: true };
        assert!(Ulog { log: log.clone(), out, overwriting: forced, firmware: Firmware::default() }.run().is_err());
        assert_eq!(fs::read(&log).unwrap(), before);
    }

    #[test]
    fn of_many_motors_the_first_are_written() {
        let (_folder, bytes) = converted(16);
        let last = Log::new(&bytes).unwrap().read::<EscStatus>().last().unwrap().1;
        let numbers: Vec<_> = last.motors().filter_map(|motor| motor.number).collect();
        assert_eq!((numbers, last.esc_count), ((1..=12).collect(), 12));
    }

    #[test]
    fn time_runs_on_where_a_vehicle_restarts() {
        let mut vehicle = Vehicle::default();
        let at = |time_boot_ms| AqEscTelemetry {
            time_boot_ms,
            seq: 1,
            num_motors: 1,
            num_in_seq: 1,
            escid: [1, 0, 0, 0],
            ..mavlink_autoquad::wire::Message::DEFAULT
        };
        let times: Vec<_> = [600_000, 600_100, 1_000, 1_100, 1_200]
            .into_iter()
            .filter_map(|time| vehicle.update(&at(time)).map(|status| status.timestamp))
            .collect();
        assert!(times.is_sorted() && times.len() >= 3, "{times:?}");
    }
}
