//! The simulated AutoQuad and the ground station, one against the other.

use std::net::UdpSocket;
use std::process::{Command, Stdio};

#[test]
fn a_station_lists_sets_uploads_arms_and_takes_off() {
    // A port that is free now.
    let port = UdpSocket::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
    let mut vehicle = Command::new(env!("CARGO_BIN_EXE_vehicle"))
        .arg(format!("udpout:127.0.0.1:{port}"))
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let station = Command::new(env!("CARGO_BIN_EXE_station")).arg(format!("udpin:127.0.0.1:{port}")).output().unwrap();
    vehicle.kill().unwrap();
    vehicle.wait().unwrap();
    let text = String::from_utf8(station.stdout).unwrap();
    let said = String::from_utf8(station.stderr).unwrap();
    assert!(station.status.success(), "{text}{said}");
    for line in [
        "1/1 is a MAV_TYPE_QUADROTOR",
        "] 8/8",
        "  BAUD             115200",
        "RATE_P is now 0.2",
        "has 6 items",
        "] 100/100",
    ] {
        assert!(text.contains(line), "`{line}` is missing: {text}");
    }
}
