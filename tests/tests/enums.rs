//! Every constant of every enum.

use mavlink_conformance::autoquad::CONSTANTS;
use mavlink_conformance::constants::{self, Expected};

/// What `xml/overlay/autoquad.xml` adds, which pymavlink does not read: the tables of the ESC32 firmware and its ground station.
const OVERLAY: &str = "\
enum ESC32_STATE plain
0 ESC32_STATE_DISARMED
1 ESC32_STATE_STOPPED
2 ESC32_STATE_NOCOMM
3 ESC32_STATE_STARTING
4 ESC32_STATE_RUNNING
enum ESC32_DISARM_V2 plain
0 ESC32_DISARM_V2_STARTUP
1 ESC32_DISARM_V2_BAD_DETECTS
2 ESC32_DISARM_V2_CROSSING_TIMEOUT
3 ESC32_DISARM_V2_PWM_TIMEOUT
4 ESC32_DISARM_V2_LOW_VOLTAGE
5 ESC32_DISARM_V2_CLI_USER
6 ESC32_DISARM_V2_BINARY_USER
7 ESC32_DISARM_V2_CAN_USER
enum ESC32_DISARM_V3 plain
0 ESC32_DISARM_V3_NONE
1 ESC32_DISARM_V3_CLI_USER
2 ESC32_DISARM_V3_BINARY_USER
3 ESC32_DISARM_V3_CAN_USER
4 ESC32_DISARM_V3_STARTUP
5 ESC32_DISARM_V3_BAD_DETECTS
6 ESC32_DISARM_V3_CROSSING_TIMEOUT
7 ESC32_DISARM_V3_PWM_TIMEOUT
";

/// What pymavlink understands, and then the overlay: three enums more, and one whose values are bits.
fn expected() -> Vec<Expected> {
    let mut expected = constants::read(constants::AUTOQUAD);
    let refined = expected.iter_mut().find(|one| one.name == "AUTOQUAD_NAV_STATUS").unwrap();
    assert!(!refined.bitmask, "the definitions say it themselves now: take `refine` out of the overlay");
    refined.bitmask = true;
    expected.extend(constants::read(OVERLAY));
    expected
}

#[test]
fn every_constant_is_as_it_should_be() {
    let expected = expected();
    constants::check(&CONSTANTS, &expected).expect_none();
    let entries: usize = expected.iter().map(|expected| expected.entries.len()).sum();
    println!("{} enums, {entries} entries", expected.len());
    assert!(expected.len() >= 165 && entries >= 1_600, "{} {entries}", expected.len());
}
