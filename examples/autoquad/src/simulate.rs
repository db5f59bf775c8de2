//! `autoquad simulate`: a vehicle that is made up.

mod datasets;
mod flight;
mod motor;
mod streams;
mod vehicle;

use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use clap::Args;
use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::link::Options;
use mavlink_autoquad::wire::{Dialect, Frame, MAX_FRAME, Sender, Version, tlog};

use crate::failure::Failure;
use crate::interrupt;
use crate::output::Overwriting;
use crate::station::{connect, refused, sent};
use crate::time;
use streams::Streams;
use vehicle::{ID, Vehicle};

/// Simulates an AutoQuad in flight: its motors spool up and carry load, one controller fails, one falls silent.
///
/// It sends what an AutoQuad sends: heartbeat, attitude, position, motor telemetry (AQ_ESC_TELEMETRY) and the datasets of
/// AQ_TELEMETRY_F. Over a link, the last two have to be requested, as from a real vehicle: with REQUEST_DATA_STREAM 13 and
/// MAV_CMD_AQ_TELEMETRY. The seed decides which motors fail; the same seed gives the same flight. The controllers on motor ports 4,
/// 8, 12 and 16 have firmware 2.1, which counts errors; the others have 3.0, which measures the temperature.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Simulate {
    /// The address to send to, such as udpout:HOST:PORT; any address of a link works.
    #[arg(required_unless_present = "tlog", conflicts_with = "tlog")]
    address: Option<String>,
    /// Writes the whole flight to this tlog instead, faster than real time; `-` is standard output.
    #[arg(long, value_name = "FILE")]
    tlog: Option<PathBuf>,
    #[command(flatten)]
    overwriting: Overwriting,
    /// The number of motors.
    #[arg(long, value_name = "1-16", default_value_t = 4, value_parser = clap::value_parser!(u8).range(1..=16))]
    motors: u8,
    /// The seed of all random values.
    #[arg(long, value_name = "NUMBER", default_value_t = 1)]
    seed: u64,
    /// How long the flight takes.
    #[arg(long, value_name = "TIME", default_value = "2m", value_parser = flight_time)]
    duration: Duration,
    /// When the flight starts, in UTC. By default, now.
    #[arg(long, value_name = "TIME", value_parser = time::parse)]
    start: Option<u64>,
    /// Motor telemetry in the tlog, times a second.
    #[arg(long, value_name = "HZ", default_value_t = 10, value_parser = clap::value_parser!(u16).range(1..=200))]
    rate: u16,
    /// Over a link: how many times faster than real time.
    #[arg(long, value_name = "TIMES", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100))]
    speed: u32,
}

/// How long a simulated vehicle on a link waits for requests before it goes on.
const MOMENT: Duration = Duration::from_millis(5);

const AFTER_HELP: &str = "\
Examples:
  autoquad simulate udpout:127.0.0.1:14550
  autoquad simulate tcpin:0.0.0.0:5760 --motors 8 --duration 1h
  autoquad simulate --tlog flight.tlog
  autoquad simulate --tlog fleet.tlog --motors 16 --seed 7 --duration 30m --start 2016-04-30T12:00:00Z";

fn flight_time(text: &str) -> Result<Duration, String> {
    let duration = humantime::parse_duration(text).map_err(|error| format!("{error}; write it like 90s or 5m"))?;
    match duration.as_secs() {
        10..=86_400 => Ok(duration),
        _ => Err("a flight takes from 10s to 24h".to_owned()),
    }
}

impl Simulate {
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match (&self.address, &self.tlog) {
            (Some(address), _) => self.fly(address),
            (None, Some(path)) => self.write(path),
            (None, None) => Err(Failure::new("give an address, or --tlog and a file")),
        }
    }

    fn vehicle(&self, streams: Streams) -> Vehicle {
        Vehicle::new(self.motors, self.seed, self.duration, streams)
    }

    fn write(&self, path: &Path) -> Result<(), Failure> {
        let mut writer = tlog::Writer::new(self.overwriting.whole(path, None)?.of_bytes()?);
        let start_us = self.start.unwrap_or_else(time::now_us);
        let written =
            record(self.vehicle(Streams::on(self.rate)), start_us, |time_us, frame| writer.write(time_us, frame))
                .map_err(Failure::written)?;
        writer.into_inner().finish_saying(format_args!("{written} frames written"))
    }

    fn fly(&self, address: &str) -> Result<(), Failure> {
        interrupt::catch()?;
        let mut link =
            connect(address, Options::new(Autoquad::TABLE, Sender::v1(ID.0, ID.1)).with_version(Version::V1))?;
        let (mut vehicle, start) = (self.vehicle(Streams::off()), Instant::now());
        eprintln!("autoquad: {address}: vehicle {}, {} motors; it flies for {:?}", ID.0, self.motors, self.duration);
        while !vehicle.has_landed() && !interrupt::was_caught() {
            let due_us = (start.elapsed() * self.speed).as_micros();
            while u128::from(vehicle.elapsed_us()) <= due_us && !vehicle.has_landed() {
                for message in vehicle.step().map_err(|error| Failure::new(error.to_string()))? {
                    sent(link.send(&message))?;
                }
            }
            // Systems are not exact to a step: what is due in a moment is sent together.
            let until = Instant::now() + MOMENT;
            while let Some(frame) = link.receive_until(until).map_err(|error| refused(&error))? {
                if let Some(answer) = vehicle.receive(&frame) {
                    sent(link.send(&answer))?;
                }
            }
        }
        Ok(())
    }
}

/// Flies the whole flight, and gives the number of frames that were written.
fn record(
    mut vehicle: Vehicle,
    start_us: u64,
    mut write: impl FnMut(u64, &Frame<'_>) -> io::Result<()>,
) -> io::Result<u64> {
    let (mut sender, mut buffer, mut frames) = (Sender::v1(ID.0, ID.1), [0; MAX_FRAME], 0);
    while !vehicle.has_landed() {
        let time_us = start_us.saturating_add(vehicle.elapsed_us());
        for message in vehicle.step().map_err(io::Error::other)? {
            let bytes = sender.encode(&message, &mut buffer).map_err(io::Error::other)?;
            let frame = Frame::parse(bytes, Autoquad::TABLE).map_err(io::Error::other)?;
            write(time_us, &frame)?;
            frames += 1;
        }
    }
    Ok(frames)
}

/// A flight in a log, for the tests of what reads logs.
#[cfg(test)]
pub(crate) fn flight(path: &Path, motors: u8, seconds: u64, start_us: u64) {
    let mut log = tlog::Writer::new(Vec::new());
    let vehicle = Vehicle::new(motors, 1, Duration::from_secs(seconds), Streams::on(10));
    record(vehicle, start_us, |time_us, frame| log.write(time_us, frame)).unwrap();
    std::fs::write(path, log.into_inner()).unwrap();
}
