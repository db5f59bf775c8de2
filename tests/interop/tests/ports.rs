//! The same small ground station with rust-mavlink and with us: `src/bin/theirs.rs` and `src/bin/ours.rs`.
//!
//! Both do what they say, and ours is shorter. `cargo test --test ports -- --nocapture` prints how long each is.

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use mavlink_autoquad::autoquad::{
    Attitude, Autoquad, CommandAck, Heartbeat, MavAutopilot, MavCmd, MavDataStream, MavResult, MavState, MavType,
};
use mavlink_autoquad::wire::link::{Link, Options};
use mavlink_autoquad::wire::{Dialect, Message, Sender};

/// The lines of a program that say something.
fn lines(program: &str) -> usize {
    program.lines().filter(|line| !line.trim().is_empty() && !line.trim_start().starts_with("//")).count()
}

/// Answers a station until it has asked for the attitude and to arm.
fn fly(vehicle: &mut Link) {
    let (sending, deadline) = (vehicle.sending(), Instant::now() + Duration::from_secs(20));
    let beat = Heartbeat {
        r#type: MavType::QUADROTOR,
        autopilot: MavAutopilot::PX4,
        system_status: MavState::STANDBY,
        ..Heartbeat::DEFAULT
    };
    let (mut beaten, mut streams, mut armed) = (false, false, false);
    while !(beaten && streams && armed) {
        assert!(Instant::now() < deadline, "heartbeat {beaten}, stream {streams}, armed {armed}");
        sending.send(&beat).unwrap();
        let Some(frame) = vehicle.receive_until(Instant::now() + Duration::from_millis(100)).unwrap() else { continue };
        match frame.message() {
            Some(Autoquad::Heartbeat(beat)) => beaten = beat.r#type == MavType::GCS && frame.system_id() == 255,
            Some(Autoquad::RequestDataStream(asked)) => {
                streams = (asked.target_system, asked.req_stream_id, asked.start_stop) == (1, MavDataStream::EXTRA1, 1);
                sending.send(&Attitude { roll: 0.5, ..Attitude::DEFAULT }).unwrap();
            }
            Some(Autoquad::CommandLong(command)) => {
                armed = command.command == MavCmd::COMPONENT_ARM_DISARM && command.param1 == 1.0;
                sending
                    .send(&CommandAck { command: command.command, result: MavResult::ACCEPTED, ..CommandAck::DEFAULT })
                    .unwrap();
            }
            _ => {}
        }
    }
}

/// What a station prints of a flight.
fn printed(program: &str) -> Vec<String> {
    let mut vehicle = Link::connect("udpin:127.0.0.1:0", Options::new(Autoquad::TABLE, Sender::v2(1, 1))).unwrap();
    let address = format!("udpout:{}", vehicle.local_addr().unwrap());
    let mut station = Command::new(program).arg(address).stdout(Stdio::piped()).spawn().unwrap();
    fly(&mut vehicle);
    let lines = BufReader::new(station.stdout.take().unwrap()).lines().take(3).collect::<Result<_, _>>().unwrap();
    station.kill().unwrap();
    station.wait().unwrap();
    lines
}

#[test]
fn both_do_the_same() {
    let attitude = "roll 0.50, pitch 0.00, yaw 0.00";
    let ours = printed(env!("CARGO_BIN_EXE_ours"));
    assert_eq!(
        ours,
        ["MAV_TYPE_QUADROTOR 1 is MAV_STATE_STANDBY", attitude, "MAV_CMD_COMPONENT_ARM_DISARM: MAV_RESULT_ACCEPTED"]
    );
    let theirs = printed(env!("CARGO_BIN_EXE_theirs"));
    assert_eq!(
        theirs,
        ["MAV_TYPE_QUADROTOR 1 is MAV_STATE_STANDBY", attitude, "MAV_CMD_COMPONENT_ARM_DISARM: MAV_RESULT_ACCEPTED"]
    );
}

#[test]
fn ours_is_shorter() {
    let [theirs, ours] = [include_str!("../src/bin/theirs.rs"), include_str!("../src/bin/ours.rs")].map(lines);
    println!("a ground station: {theirs} lines with rust-mavlink, {ours} with us");
    assert!(ours < theirs, "{ours} lines, {theirs} with rust-mavlink");
}
