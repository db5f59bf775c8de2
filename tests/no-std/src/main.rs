//! A firmware's main loop on the host: reads frames from standard input, knows two messages, and exits with what it saw.

#![no_std]
#![no_main]

#[cfg(feature = "px4")]
mod px4;
#[cfg(feature = "signing")]
mod signing;

use mavlink_autoquad::autoquad::{AqEscTelemetry, Heartbeat, MavAutopilot};
use mavlink_autoquad::esc::{Conversion, EscTable};
use mavlink_autoquad::wire::{Frame, Message, Parser, Table};
use mavlink_no_std::receive;

static RECEIVED: Table<'static> = Table::of(&[Heartbeat::INFO, AqEscTelemetry::INFO]);

#[unsafe(no_mangle)]
extern "C" fn main() -> i32 {
    let (mut parser, mut firmware, mut seen) = (Parser::new(&RECEIVED), Firmware::new(), 0);
    let mut buffer = [0; 64];
    while let Some(mut chunk) = receive(&mut buffer) {
        while let Some(frame) = parser.next(&mut chunk) {
            seen += firmware.worth(&frame);
        }
    }
    while let Some(frame) = parser.finish() {
        seen += firmware.worth(&frame);
    }
    #[cfg(feature = "px4")]
    let seen = seen + px4::worth();
    i32::from(seen)
}

/// What lasts from frame to frame.
struct Firmware {
    table: EscTable,
    #[cfg(feature = "signing")]
    link: signing::Link,
}

impl Firmware {
    fn new() -> Self {
        Self {
            table: EscTable::new(),
            #[cfg(feature = "signing")]
            link: signing::Link::new(),
        }
    }

    /// 100 for an AutoQuad's heartbeat, 1 for another's, and for a telemetry batch the number of ESCs in the table; 1 more
    /// if a signed link carries the frame.
    fn worth(&mut self, frame: &Frame<'_>) -> u8 {
        let worth = if let Some(beat) = frame.decode::<Heartbeat>() {
            if beat.autopilot == MavAutopilot::AUTOQUAD { 100 } else { 1 }
        } else {
            frame.decode::<AqEscTelemetry>().map_or(0, |telemetry| shown(&mut self.table, &telemetry))
        };
        #[cfg(feature = "signing")]
        let worth = worth + u8::from(self.link.carries(frame));
        worth
    }
}

/// How many ESCs a ground station of today is told of, if it is told the same in both messages.
fn shown(table: &mut EscTable, telemetry: &AqEscTelemetry) -> u8 {
    table.update(telemetry);
    let (now_us, options) = (table.uptime_us(), Conversion::DEFAULT);
    match (table.to_esc_info(0, now_us, &options), table.to_esc_status(0, now_us, &options)) {
        (Some(info), Some(status)) if info.time_usec == status.time_usec => info.count,
        _ => 0,
    }
}
