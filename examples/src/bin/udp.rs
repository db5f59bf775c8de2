//! Sends a HEARTBEAT and an AQ_ESC_TELEMETRY over UDP, as an AutoQuad does, and receives them.
//!
//! `udp` alone talks to itself on the loopback interface and ends; `udp ADDRESS` sends once a second to a ground station,
//! for example to `127.0.0.1:14550`.

use std::error::Error;
use std::net::{SocketAddr, UdpSocket};
use std::thread::sleep;
use std::time::Duration;

use mavlink_autoquad::autoquad::{AqEscTelemetry, Autoquad, Heartbeat, MavAutopilot, MavComponent, MavState, MavType};
use mavlink_autoquad::wire::{Dialect, Encode, MAX_FRAME, Message, Parser, Sender};

const BEAT: Heartbeat = Heartbeat {
    r#type: MavType::QUADROTOR,
    autopilot: MavAutopilot::AUTOQUAD,
    system_status: MavState::ACTIVE,
    ..Heartbeat::DEFAULT
};

fn main() -> Result<(), Box<dyn Error>> {
    let mut sender = Sender::v1(1, MavComponent::AUTOPILOT1);
    match std::env::args().nth(1) {
        Some(address) => {
            let (socket, address) = (UdpSocket::bind("0.0.0.0:0")?, address.parse()?);
            for second in 0.. {
                send(&socket, address, &mut sender, second)?;
                sleep(Duration::from_secs(1));
            }
            Ok(())
        }
        None => {
            let (from, to) = (UdpSocket::bind("127.0.0.1:0")?, UdpSocket::bind("127.0.0.1:0")?);
            to.set_read_timeout(Some(Duration::from_secs(5)))?;
            send(&from, to.local_addr()?, &mut sender, 0)?;
            receive(&to, 2)
        }
    }
}

/// One datagram a message, which is how ground stations expect them.
fn send(socket: &UdpSocket, to: SocketAddr, sender: &mut Sender, second: u32) -> Result<(), Box<dyn Error>> {
    let messages: [&dyn Encode; 2] = [&BEAT, &telemetry(second)];
    for message in messages {
        let mut buffer = [0; MAX_FRAME];
        socket.send_to(sender.encode(message, &mut buffer)?, to)?;
    }
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

fn receive(socket: &UdpSocket, datagrams: usize) -> Result<(), Box<dyn Error>> {
    let mut parser = Parser::new(Autoquad::TABLE);
    for _ in 0..datagrams {
        let mut buffer = [0; 2048];
        let (length, from) = socket.recv_from(&mut buffer)?;
        let mut datagram = buffer.get(..length).unwrap_or_default();
        while let Some(frame) = parser.next(&mut datagram) {
            match frame.message() {
                Some(Autoquad::Heartbeat(beat)) => {
                    println!("{from}: {} is {}", beat.r#type, beat.system_status)
                }
                Some(Autoquad::AqEscTelemetry(telemetry)) => println!("{from}: {telemetry:?}"),
                Some(other) => println!("{from}: {other:?}"),
                None => println!("{from}: unknown message {}", frame.id()),
            }
        }
    }
    Ok(())
}
