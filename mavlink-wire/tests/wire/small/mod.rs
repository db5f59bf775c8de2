//! A dialect of three messages, in the shape that the generator writes.

mod enums;
mod messages;

use mavlink_wire as wire;

pub(crate) use enums::{MavModeFlag, MavSeverity, MavState};
pub(crate) use messages::{AqEscTelemetry, Heartbeat, Statustext};

#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub(crate) enum Small {
    Heartbeat(Heartbeat),
    AqEscTelemetry(AqEscTelemetry),
    Statustext(Statustext),
}

wire::dialect!(Small { Heartbeat, AqEscTelemetry, Statustext });
