//! Commands: a station sends `COMMAND_LONG` or `COMMAND_INT`, and gets `COMMAND_ACK`, perhaps after reports of progress.
//!
//! A station [sends](Send) a command, repeats it until it is acknowledged, and can cancel it. [`Fetch`] requests a message. A
//! [`Component`] reports each command to your program once, and sends the answers.

mod component;
mod failure;
mod fetch;
mod send;

pub use component::{Component, Event, Request, Ticket};
pub use failure::{Failure, NoCommand};
pub use fetch::Fetch;
pub use send::{Accepted, Options, Progress, Send};

use mavlink_wire::{Encode, Frame, Message};

use crate::common::{CommandInt, CommandLong, MavCmd};
use crate::{Address, Outgoing, convert};

/// A received command, in one of its two forms. `COMMAND_INT` has a frame, and its coordinates as integers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Command {
    /// Seven floats.
    Long(CommandLong),
    /// Four floats, latitude and longitude in 1e-7 degrees (or x and y in 1e-4 m), and a height.
    Int(CommandInt),
}

impl Command {
    /// The entry of `MAV_CMD`.
    #[must_use]
    pub fn command(&self) -> MavCmd {
        match self {
            Self::Long(long) => long.command,
            Self::Int(int) => int.command,
        }
    }

    /// Converts it to the message of your dialect, to read it as a typed command. `None` if `M` is the other form.
    #[must_use]
    pub fn to_message<M: Message>(&self) -> Option<M> {
        match self {
            Self::Long(long) => convert(long),
            Self::Int(int) => convert(int),
        }
    }

    /// The parameters 1 to 4, which both forms have as floats.
    #[must_use]
    pub fn params(&self) -> [f32; 4] {
        match self {
            Self::Long(long) => [long.param1, long.param2, long.param3, long.param4],
            Self::Int(int) => [int.param1, int.param2, int.param3, int.param4],
        }
    }

    /// Reads a message of any dialect.
    pub(crate) fn from_message(message: &(impl Encode + ?Sized)) -> Option<Self> {
        convert(message).map(Self::Long).or_else(|| convert(message).map(Self::Int))
    }

    /// Reads a frame.
    fn from_frame(frame: &Frame<'_>) -> Option<Self> {
        frame.decode().map(Self::Long).or_else(|| frame.decode().map(Self::Int))
    }

    /// Whether it is for this component.
    fn is_for(&self, own: Address) -> bool {
        match self {
            Self::Long(long) => own.is_target(long.target_system, long.target_component),
            Self::Int(int) => own.is_target(int.target_system, int.target_component),
        }
    }

    /// The message to this one; `COMMAND_LONG` counts how often it was sent before.
    fn to(self, peer: Address, confirmation: u8) -> Outgoing {
        let (target_system, target_component) = peer.target();
        match self {
            Self::Long(long) => CommandLong { target_system, target_component, confirmation, ..long }.into(),
            Self::Int(int) => CommandInt { target_system, target_component, ..int }.into(),
        }
    }
}

/// A progress in percent, as the wire has it; 255 is unknown, and so is what cannot be.
fn percent(progress: u8) -> Option<u8> {
    if progress > 100 { None } else { Some(progress) }
}
