//! Step 4. A program that speaks the dialect: it sends two messages, and reads them back from the bytes.
//!
//! The files in the order in which one writes them: `xml/farm.xml`, `xml/overlay/farm.xml`, `build.rs`, this one.

use std::error::Error;

use farm::{Farm, Heartbeat, MavState, MavType, SprayState, Sprayer};
use mavlink_wire::{Dialect, MAX_FRAME, Message, Parser, Sender};

// The module `farm`, which the build script made: `farm::Sprayer`, `farm::SprayState`, and `farm::Farm` over all messages.
mavlink_wire::include_dialect!("farm");

fn main() -> Result<(), Box<dyn Error>> {
    let bytes = sent()?;
    println!("{} bytes", bytes.len());
    for line in received(&bytes) {
        println!("{line}");
    }
    Ok(())
}

/// What a link would carry: a heartbeat, and what the sprayer does.
fn sent() -> Result<Vec<u8>, Box<dyn Error>> {
    let beat = Heartbeat { r#type: MavType::HEXAROTOR, system_status: MavState::ACTIVE, ..Heartbeat::DEFAULT };
    let mut sprayer = Sprayer { state: SprayState::ON, ..Sprayer::DEFAULT };
    let mut tank = sprayer.contents();
    tank.set_level(7.5)?; // litres; what does not fit is an error
    sprayer.set_contents(tank);

    let (mut sender, mut buffer, mut bytes) = (Sender::v2(1, 1), [0; MAX_FRAME], Vec::new());
    for message in [Farm::from(beat), Farm::from(sprayer)] {
        bytes.extend_from_slice(sender.encode(&message, &mut buffer)?);
    }
    Ok(bytes)
}

/// What the bytes say. They may come in any pieces.
fn received(bytes: &[u8]) -> Vec<String> {
    let (mut parser, mut lines) = (Parser::new(Farm::TABLE), Vec::new());
    for mut piece in bytes.chunks(5) {
        while let Some(frame) = parser.next(&mut piece) {
            lines.push(match frame.message() {
                Some(Farm::Sprayer(sprayer)) => {
                    let tank = sprayer.contents();
                    let alarm = if tank.leaking() { "leaking" } else { "tight" };
                    format!("sprayer: {}, {} l in the tank, {alarm}", sprayer.state, tank.level())
                }
                Some(Farm::Heartbeat(beat)) => format!("{} is {}", beat.r#type, beat.system_status),
                _ => format!("message {}, which we leave to others", frame.message_id()),
            });
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_sent_is_received() {
        let bytes = sent().unwrap();
        let lines = received(&bytes);
        assert_eq!(
            lines,
            ["MAV_TYPE_HEXAROTOR is MAV_STATE_ACTIVE", "sprayer: SPRAY_STATE_ON, 7.5 l in the tank, tight"]
        );
    }
}
