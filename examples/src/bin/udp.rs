//! Sends a HEARTBEAT and an AQ_ESC_TELEMETRY, as an AutoQuad does, and receives them.
//!
//! `udp` alone talks to itself on the loopback interface and ends; `udp ADDRESS` sends once a second to a ground station,
//! for example to `udpout:127.0.0.1:14550`, or whatever else a link connects to.

use std::error::Error;
use std::process::ExitCode;
use std::thread::sleep;
use std::time::{Duration, Instant};

use mavlink_autoquad::autoquad::{AqEscTelemetry, Autoquad, Heartbeat, MavAutopilot, MavComponent, MavState, MavType};
use mavlink_autoquad::wire::link::{Link, LinkError, Options};
use mavlink_autoquad::wire::{Dialect, Message, Sender};

const BEAT: Heartbeat = Heartbeat {
    r#type: MavType::QUADROTOR,
    autopilot: MavAutopilot::AUTOQUAD,
    system_status: MavState::ACTIVE,
    ..Heartbeat::DEFAULT
};

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("udp: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    if let Some(address) = std::env::args().nth(1) {
        let vehicle = connect(&address, 1)?;
        for second in 0.. {
            send(&vehicle, second)?;
            sleep(Duration::from_secs(1));
        }
    }
    let mut station = connect("udpin:127.0.0.1:0", 255)?;
    let address = station.local_addr().ok_or("the station listens nowhere")?;
    send(&connect(&format!("udpout:{address}"), 1)?, 0)?;
    receive(&mut station, 2)
}

fn connect(address: &str, system: u8) -> Result<Link, LinkError> {
    Link::connect(address, Options::new(Autoquad::TABLE, Sender::v1(system, MavComponent::AUTOPILOT1)))
}

fn send(vehicle: &Link, second: u32) -> Result<(), LinkError> {
    vehicle.send(&BEAT)?;
    vehicle.send(&telemetry(second))?;
    Ok(())
}

/// Four motors that have been silent: the fourth never answered.
fn telemetry(second: u32) -> AqEscTelemetry {
    AqEscTelemetry {
        time_boot_ms: second * 1000,
        seq: 1,
        num_motors: 4,
        num_in_seq: 4,
        escid: [1, 2, 3, 4],
        status_age: [4, 9, 7, u16::MAX],
        data_version: [21, 21, 21, 0],
        ..AqEscTelemetry::DEFAULT
    }
}

fn receive(station: &mut Link, frames: usize) -> Result<(), Box<dyn Error>> {
    let deadline = Instant::now() + Duration::from_secs(5);
    for _ in 0..frames {
        let (frame, from) = station.receive_from(deadline)?.ok_or("nothing came in 5 s")?;
        match frame.message() {
            Some(Autoquad::Heartbeat(beat)) => println!("{from}: {} is {}", beat.r#type, beat.system_status),
            Some(Autoquad::AqEscTelemetry(telemetry)) => println!("{from}: {telemetry:?}"),
            Some(other) => println!("{from}: {other:?}"),
            None => println!("{from}: unknown message {}", frame.message_id()),
        }
    }
    Ok(())
}
