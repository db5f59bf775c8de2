//! Prints when a PX4 changed its mode: `cargo run -p px4-topics -- flight.ulg`. The log may be of any release.

use std::error::Error;

use mavlink_wire::uorb::ulog::Log;
use px4::{NavState, VehicleStatus};

// The module `px4`, which the build script made.
mavlink_wire::include_dialect!("px4");

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os().nth(1).ok_or("usage: px4-topics LOG.ulg")?;
    for line in modes(&std::fs::read(path)?)? {
        println!("{line}");
    }
    Ok(())
}

/// Each change of the mode.
fn modes(log: &[u8]) -> Result<Vec<String>, Box<dyn Error>> {
    let (mut before, mut lines) = (None::<NavState>, Vec::new());
    for (_, status) in Log::new(log)?.read::<VehicleStatus>() {
        if before.replace(status.nav_state) != Some(status.nav_state) {
            let VehicleStatus { timestamp, nav_state, arming_state, failsafe, .. } = status;
            lines.push(format!(
                "{timestamp} us: {nav_state}, {arming_state}{}",
                if failsafe { ", failsafe" } else { "" }
            ));
        }
    }
    Ok(lines)
}

#[cfg(test)]
mod tests {
    use mavlink_wire::uorb::Topic;
    use mavlink_wire::uorb::ulog::Writer;
    use px4::ArmingState;

    use super::*;

    #[test]
    fn changes_of_the_mode_are_printed() {
        let mut log = Writer::new(Vec::new(), 0).topic::<VehicleStatus>().begin().unwrap();
        for (timestamp, nav_state, failsafe) in
            [(1, NavState::MANUAL, false), (2, NavState::MANUAL, false), (3, NavState::AUTO_RTL, true)]
        {
            let arming_state = ArmingState::ARMED;
            let status = VehicleStatus { timestamp, nav_state, arming_state, failsafe, ..VehicleStatus::UNKNOWN };
            log.write(0, &status).unwrap();
        }
        let lines = modes(&log.finish().unwrap()).unwrap();
        let manual = "1 us: NAVIGATION_STATE_MANUAL, ARMING_STATE_ARMED";
        assert_eq!(lines, [manual, "3 us: NAVIGATION_STATE_AUTO_RTL, ARMING_STATE_ARMED, failsafe"]);
    }

    /// The hash that PX4's own generator gives it.
    #[test]
    fn it_is_the_message_of_px4() {
        let newest = VehicleStatus::DEFINITIONS[0];
        assert_eq!((newest.message_hash, newest.cdr_len, newest.record_len), (0x53ee_3679, 83, 75));
    }
}
