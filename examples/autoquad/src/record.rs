//! `autoquad record`: what a link carries, in a log.

mod files;

use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::Args;

use crate::failure::Failure;
use crate::output::Overwriting;
use crate::station::{Asking, Run, Running, Station};
use crate::time;
use files::{Files, Rotation};

/// How often what was received is given to the system.
const FLUSH: Duration = Duration::from_secs(1);

/// Records everything that a link carries as a tlog, which ground stations can read.
///
/// It requests motor telemetry from AutoQuads. Received frames are written every second; Ctrl-C ends the recording without loss.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Record {
    /// The vehicle's address: udpin:, udpout:, udpbcast:, tcpin:, tcpout:HOST:PORT or serial:DEVICE:BAUD.
    address: String,
    /// The tlog to write; `-` is standard output.
    log: PathBuf,
    #[command(flatten)]
    overwriting: Overwriting,
    /// Starts a new file after this many megabytes: flight.tlog, flight-2.tlog and so on.
    #[arg(long, value_name = "MB", value_parser = clap::value_parser!(u64).range(1..))]
    rotate_size: Option<u64>,
    /// Starts a new file after this time.
    #[arg(long, value_name = "TIME", value_parser = rotation_time)]
    rotate_time: Option<Duration>,
    #[command(flatten)]
    running: Running,
    #[command(flatten)]
    asking: Asking,
}

const AFTER_HELP: &str = "\
Examples:
  autoquad record udpin:0.0.0.0:14550 flight.tlog
  autoquad record serial:/dev/ttyUSB0:57600 flight.tlog --for 20m
  autoquad record serial:/dev/ttyUSB0:57600 - --for 20m | zstd > flight.tlog.zst
  autoquad record tcpout:192.168.0.7:5760 fleet.tlog --rotate-time 1h --rotate-size 500";

fn rotation_time(text: &str) -> Result<Duration, String> {
    let time = humantime::parse_duration(text).map_err(|error| error.to_string())?;
    if time.as_secs() == 0 { Err("a file takes a second at least".to_owned()) } else { Ok(time) }
}

impl Record {
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let run = self.running.start()?;
        let rotation = Rotation {
            bytes: self.rotate_size.map(|megabytes| megabytes.saturating_mul(1_000_000)),
            time: self.rotate_time,
        };
        let mut station = Station::connect(&self.address, self.asking)?;
        let read = self.address.strip_prefix("file:").map(PathBuf::from);
        let mut files = Files::create(&self.log, read, self.overwriting, rotation)?;
        let name = files.name().to_owned();
        eprintln!("autoquad: records {} into {name}; Ctrl-C ends it", self.address);
        let received = receive(run, &mut station, &mut files);
        let finished = files.finish();
        received?;
        let frames = finished?;
        eprintln!("autoquad: {name}: {frames} frames recorded");
        Ok(())
    }
}

/// Writes what comes, until there is no more or somebody ends it.
fn receive(run: Run, station: &mut Station, files: &mut Files) -> Result<(), Failure> {
    let mut flushed = Instant::now();
    while run.goes_on() && !station.has_ended() {
        if let Some(frame) = station.receive_until(flushed + FLUSH)? {
            files.write(time::now_us(), &frame)?;
        }
        if flushed.elapsed() >= FLUSH {
            files.flush()?;
            flushed = Instant::now();
        }
        station.say_silence();
    }
    Ok(())
}
