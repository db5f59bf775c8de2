//! A ground station: lists the parameters of a vehicle, sets one, uploads a mission, arms, and takes off.
//!
//! `station [ADDRESS]` listens on `udpin:0.0.0.0:14550` unless told otherwise; `vehicle` is what it can talk to.

use std::error::Error;
use std::io::{self, Write};
use std::process::ExitCode;

use mavlink_autoquad::autoquad::commands::NavTakeoff;
use mavlink_autoquad::wire::Command;
use mavlink_services::Station;
use mavlink_services::common::{MavCmd, MavMissionType};
use mavlink_services::mission::MissionItem;

fn main() -> ExitCode {
    let Err(error) = run() else { return ExitCode::SUCCESS };
    eprintln!("station: {error}");
    ExitCode::FAILURE
}

fn run() -> Result<(), Box<dyn Error>> {
    let address = std::env::args().nth(1).unwrap_or_else(|| "udpin:0.0.0.0:14550".into());
    let mut station = Station::connect(&address)?;
    println!("{} is a {} with {}", station.vehicle(), station.heartbeat().r#type, station.heartbeat().autopilot);

    let params = station.params(|received, count| bar("parameters", received, count))?;
    for param in &params {
        match param.value {
            Ok(value) => println!("  {:16} {value}", param.name),
            Err(why) => println!("  {:16} {why}", param.name),
        }
    }
    println!("RATE_P is now {}", station.set_param("RATE_P", 0.2)?);

    station.upload_plan(MavMissionType::MISSION, &mission(), |told| bar("mission", told.sent, told.count))?;
    println!("the vehicle has {} items", station.download()?.len());
    println!("its clock is {:.6} s ahead", station.measure_time()?.nanos as f64 / 1e9);

    station.arm()?;
    // A command of any dialect.
    let takeoff = NavTakeoff { altitude: 10.0, ..NavTakeoff::DEFAULT };
    station.command_with(&takeoff.long(1, 1)?, |told| bar("takeoff", told.percent.unwrap_or(0).into(), 100))?;
    bar("takeoff", 100, 100);
    Ok(())
}

/// Up, around a square of some 200 m, and down again.
fn mission() -> Vec<MissionItem> {
    let corners = [(0.0, 0.0), (0.002, 0.0), (0.002, 0.003), (0.0, 0.003)];
    let mut items = vec![MissionItem::at(MavCmd::NAV_TAKEOFF, 47.397_742, 8.545_594, 20.0)];
    items.extend(
        corners.map(|(north, east)| MissionItem::at(MavCmd::NAV_WAYPOINT, 47.397_742 + north, 8.545_594 + east, 20.0)),
    );
    items.push(MissionItem::at(MavCmd::NAV_LAND, 47.397_742, 8.545_594, 0.0));
    items
}

/// Draws over the last one, and begins a line when it is full.
fn bar(what: &str, done: u16, all: u16) {
    let full = usize::from(done) * 30 / usize::from(all.max(1));
    print!("\r{what:12} [{:30}] {done}/{all}", "#".repeat(full.min(30)));
    if done >= all {
        println!();
    }
    io::stdout().flush().ok();
}
