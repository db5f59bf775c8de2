//! Sends a HEARTBEAT and an AQ_ESC_TELEMETRY over UDP, as an AutoQuad does, and receives them.
//!
//! `udp` alone talks to itself on the loopback interface and ends; `udp ADDRESS` sends once a second to a ground station,
//! for example to `127.0.0.1:14550`.

use std::error::Error;
use std::io;
use std::net::{SocketAddr, UdpSocket};
use std::process::ExitCode;
use std::thread::sleep;
use std::time::Duration;

use mavlink_autoquad::autoquad::{AqEscTelemetry, Autoquad, Heartbeat, MavAutopilot, MavComponent, MavState, MavType};
use mavlink_autoquad::wire::udp::Endpoint;
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
    match std::env::args().nth(1) {
        Some(address) => {
            let to = address.parse().map_err(|_| format!("`{address}` is no address: write it as 127.0.0.1:14550"))?;
            let mut vehicle = endpoint("0.0.0.0:0", 1)?;
            for second in 0.. {
                send(&mut vehicle, to, second)?;
                sleep(Duration::from_secs(1));
            }
        }
        None => {
            let (mut vehicle, mut station) = (endpoint("127.0.0.1:0", 1)?, endpoint("127.0.0.1:0", 255)?);
            station.socket().set_read_timeout(Some(Duration::from_secs(5)))?;
            send(&mut vehicle, station.socket().local_addr()?, 0)?;
            receive(&mut station, 2)?;
        }
    }
    Ok(())
}

fn endpoint(address: &str, system: u8) -> io::Result<Endpoint<'static>> {
    let sender = Sender::v1(system, MavComponent::AUTOPILOT1);
    Ok(Endpoint::new(UdpSocket::bind(address)?, Autoquad::TABLE, sender))
}

/// One datagram a message, which is how ground stations expect them.
fn send(vehicle: &mut Endpoint<'_>, to: SocketAddr, second: u32) -> io::Result<()> {
    vehicle.send_to(&BEAT, to)?;
    vehicle.send_to(&telemetry(second), to)
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

fn receive(station: &mut Endpoint<'_>, frames: usize) -> io::Result<()> {
    for _ in 0..frames {
        let (frame, from) = station.receive()?;
        match frame.message() {
            Some(Autoquad::Heartbeat(beat)) => println!("{from}: {} is {}", beat.r#type, beat.system_status),
            Some(Autoquad::AqEscTelemetry(telemetry)) => println!("{from}: {telemetry:?}"),
            Some(other) => println!("{from}: {other:?}"),
            None => println!("{from}: unknown message {}", frame.message_id()),
        }
    }
    Ok(())
}
