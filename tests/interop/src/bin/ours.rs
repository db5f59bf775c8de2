//! A small ground station: `theirs.rs` is the same program with rust-mavlink.
//!
//! It beats once a second, asks for the attitude, prints it, and arms as soon as the vehicle has been heard.

use std::time::Duration;
use std::{env, thread};

use mavlink_autoquad::autoquad::commands::ComponentArmDisarm;
use mavlink_autoquad::autoquad::{
    Autoquad, Heartbeat, MavAutopilot, MavBool, MavDataStream, MavState, MavType, RequestDataStream,
};
use mavlink_autoquad::wire::Sender;
use mavlink_autoquad::wire::link::{Link, Options};
use mavlink_autoquad::wire::prelude::*;

const BEAT: Heartbeat = Heartbeat {
    r#type: MavType::GCS,
    autopilot: MavAutopilot::INVALID,
    system_status: MavState::ACTIVE,
    ..Heartbeat::DEFAULT
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let address = env::args().nth(1).unwrap_or("udpin:0.0.0.0:14550".to_owned());
    let mut link = Link::connect(&address, Options::new(Autoquad::TABLE, Sender::v2(255, 190)))?;

    let beats = link.sending();
    thread::spawn(move || {
        loop {
            if let Err(error) = beats.send(&BEAT) {
                eprintln!("{error}");
            }
            thread::sleep(Duration::from_secs(1));
        }
    });

    let (sending, mut asked) = (link.sending(), false);
    loop {
        let frame = link.receive()?;
        let (system_id, component_id) = (frame.system_id(), frame.component_id());
        match frame.message() {
            Some(Autoquad::Heartbeat(beat)) if !asked => {
                println!("{} {system_id} is {}", beat.r#type, beat.system_status);
                let attitudes = RequestDataStream {
                    req_stream_id: MavDataStream::EXTRA1,
                    req_message_rate: 10,
                    start_stop: 1,
                    ..RequestDataStream::DEFAULT
                };
                sending.send(&attitudes.to(system_id, component_id))?;
                sending.send(
                    &ComponentArmDisarm { arm: MavBool::TRUE, ..ComponentArmDisarm::DEFAULT }
                        .long(system_id, component_id)?,
                )?;
                asked = true;
            }
            Some(Autoquad::CommandAck(ack)) => println!("{}: {}", ack.command, ack.result),
            Some(Autoquad::Attitude(attitude)) => {
                println!("roll {:.2}, pitch {:.2}, yaw {:.2}", attitude.roll, attitude.pitch, attitude.yaw)
            }
            _ => {}
        }
    }
}
