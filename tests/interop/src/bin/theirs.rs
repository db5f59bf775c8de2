//! A small ground station with rust-mavlink: `ours.rs` is the same program, with us.
//!
//! It beats once a second, asks for the attitude, prints it, and arms as soon as the vehicle has been heard.

#![allow(deprecated)]

use std::sync::Arc;
use std::time::Duration;
use std::{env, thread};

use mavlink::dialects::common::{
    COMMAND_LONG_DATA, HEARTBEAT_DATA, MavAutopilot, MavCmd, MavDataStream, MavMessage, MavModeFlag, MavState, MavType,
    REQUEST_DATA_STREAM_DATA,
};
use mavlink::{MavConnection, MavHeader};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let address = env::args().nth(1).unwrap_or("udpin:0.0.0.0:14550".to_owned());
    let connection = Arc::new(mavlink::connect::<MavMessage>(&address)?);
    let header = MavHeader { system_id: 255, component_id: 190, sequence: 0 };

    let beats = Arc::clone(&connection);
    thread::spawn(move || {
        loop {
            let beat = MavMessage::HEARTBEAT(HEARTBEAT_DATA {
                custom_mode: 0,
                mavtype: MavType::MAV_TYPE_GCS,
                autopilot: MavAutopilot::MAV_AUTOPILOT_INVALID,
                base_mode: MavModeFlag::empty(),
                system_status: MavState::MAV_STATE_ACTIVE,
                mavlink_version: 3,
            });
            if let Err(error) = beats.send(&header, &beat) {
                eprintln!("{error}");
            }
            thread::sleep(Duration::from_secs(1));
        }
    });

    let mut asked = false;
    loop {
        let (from, message) = match connection.recv() {
            Ok(received) => received,
            Err(mavlink::error::MessageReadError::Io(error)) => return Err(error.into()),
            Err(_) => continue,
        };
        match message {
            MavMessage::HEARTBEAT(beat) if !asked => {
                println!("{:?} {} is {:?}", beat.mavtype, from.system_id, beat.system_status);
                let attitudes = REQUEST_DATA_STREAM_DATA {
                    target_system: u8::try_from(from.system_id)?,
                    target_component: from.component_id,
                    req_stream_id: MavDataStream::MAV_DATA_STREAM_EXTRA1,
                    req_message_rate: 10,
                    start_stop: 1,
                };
                connection.send(&header, &MavMessage::REQUEST_DATA_STREAM(attitudes))?;
                let arm = COMMAND_LONG_DATA {
                    target_system: u8::try_from(from.system_id)?,
                    target_component: from.component_id,
                    command: MavCmd::MAV_CMD_COMPONENT_ARM_DISARM,
                    confirmation: 0,
                    param1: 1.0,
                    ..Default::default()
                };
                connection.send(&header, &MavMessage::COMMAND_LONG(arm))?;
                asked = true;
            }
            MavMessage::COMMAND_ACK(ack) => println!("{:?}: {:?}", ack.command, ack.result),
            MavMessage::ATTITUDE(attitude) => {
                println!("roll {:.2}, pitch {:.2}, yaw {:.2}", attitude.roll, attitude.pitch, attitude.yaw)
            }
            _ => {}
        }
    }
}
