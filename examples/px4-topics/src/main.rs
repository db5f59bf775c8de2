//! Prints when a PX4 changed its mode, and when its processor was busy: `cargo run -p px4-topics -- flight.ulg`. The log may be of any release.

use std::error::Error;
use std::process::ExitCode;

use mavlink_wire::uorb::ulog::Log;
use px4::{NavState, Px4, VehicleStatus};

// The module `px4`, which the build script made.
mavlink_wire::include_dialect!("px4");

fn main() -> ExitCode {
    let Err(error) = run() else { return ExitCode::SUCCESS };
    eprintln!("px4-topics: {error}");
    ExitCode::FAILURE
}

fn run() -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os().nth(1).ok_or("usage: px4-topics LOG.ulg")?;
    let log = std::fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    for line in events(&log)? {
        println!("{line}");
    }
    Ok(())
}

/// Each change of the mode and each load over 90 %, in the order of the log. `log.read::<VehicleStatus>()` would give one topic alone.
fn events(log: &[u8]) -> Result<Vec<String>, Box<dyn Error>> {
    let (mut before, mut lines) = (None::<NavState>, Vec::new());
    for logged in Log::new(log)?.messages::<Px4>() {
        match logged.message {
            Px4::VehicleStatus(status) => {
                let VehicleStatus { timestamp, nav_state, arming_state, failsafe, .. } = status;
                if before.replace(nav_state) != Some(nav_state) {
                    let failsafe = if failsafe { ", failsafe" } else { "" };
                    lines.push(format!("{timestamp} us: {nav_state}, {arming_state}{failsafe}"));
                }
            }
            Px4::Cpuload(cpu) if cpu.load > 0.9 => lines.push(format!("{} us: load {:.2}", cpu.timestamp, cpu.load)),
            _ => {}
        }
    }
    Ok(lines)
}

#[cfg(test)]
mod tests {
    use mavlink_wire::uorb::Topic;
    use mavlink_wire::uorb::ulog::Writer;
    use px4::{ArmingState, Cpuload};

    use super::*;

    #[test]
    fn changes_of_the_mode_and_high_loads_are_printed() {
        let log = Writer::new(Vec::new(), 0).topic::<VehicleStatus>().topic::<Cpuload>();
        let mut log = log.begin().unwrap();
        for (timestamp, nav_state, failsafe, load) in
            [(1, NavState::MANUAL, false, 0.5), (2, NavState::MANUAL, false, 0.95), (3, NavState::AUTO_RTL, true, 0.2)]
        {
            let arming_state = ArmingState::ARMED;
            let status = VehicleStatus { timestamp, nav_state, arming_state, failsafe, ..VehicleStatus::UNKNOWN };
            log.write(0, &status).unwrap();
            log.write(0, &Cpuload { timestamp, load, ram_usage: 0.1 }).unwrap();
        }
        let lines = events(&log.finish().unwrap()).unwrap();
        let manual = "1 us: NAVIGATION_STATE_MANUAL, ARMING_STATE_ARMED";
        let load = "2 us: load 0.95";
        assert_eq!(lines, [manual, load, "3 us: NAVIGATION_STATE_AUTO_RTL, ARMING_STATE_ARMED, failsafe"]);
    }

    /// The hashes that PX4's own generator gives them.
    #[test]
    fn they_are_the_messages_of_px4() {
        let newest = VehicleStatus::DEFINITIONS[0];
        assert_eq!((newest.message_hash, newest.cdr_len, newest.record_len), (0x53ee_3679, 83, 75));
        let newest = Cpuload::DEFINITIONS[0];
        assert_eq!((newest.message_hash, newest.cdr_len, newest.record_len), (0x1986_a217, 16, 16));
    }
}
