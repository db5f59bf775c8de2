//! The least that a receiver of two messages can be: its size is what the parser costs. Exits with what it saw.

#![no_std]
#![no_main]

use mavlink_autoquad::autoquad::{Attitude, Heartbeat, MavState};
use mavlink_autoquad::wire::{Frame, Message, Parser, Table};
use mavlink_no_std::receive;

static RECEIVED: Table<'static> = Table::of(&[Heartbeat::INFO, Attitude::INFO]);

#[unsafe(no_mangle)]
extern "C" fn main() -> i32 {
    let (mut parser, mut seen, mut buffer) = (Parser::new(&RECEIVED), 0_u8, [0; 64]);
    while let Some(mut chunk) = receive(&mut buffer) {
        while let Some(frame) = parser.next(&mut chunk) {
            seen = seen.wrapping_add(worth(&frame));
        }
    }
    seen.into()
}

/// 100 for the heartbeat of an active system, 10 for an attitude that climbs, 1 for other frames.
fn worth(frame: &Frame<'_>) -> u8 {
    if let Some(beat) = frame.decode::<Heartbeat>() {
        if beat.system_status == MavState::ACTIVE { 100 } else { 1 }
    } else if let Some(attitude) = frame.decode::<Attitude>() {
        if attitude.pitch > 0.1 { 10 } else { 1 }
    } else {
        1
    }
}
