//! What can become of a command.

use core::error::Error;
use core::fmt;

use crate::common::{MavCmd, MavResult};

/// A command was not carried out, or nobody knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Failure {
    /// The peer says no.
    Refused {
        /// The command.
        command: MavCmd,
        /// Why, in general.
        result: MavResult,
        /// Why, in particular: what this number means, the command says. 0 is no reason.
        reason: i32,
        /// How far it had come, in percent, as far as the peer said so.
        progress: Option<u8>,
    },
    /// The peer is silent.
    Timeout {
        /// The command.
        command: MavCmd,
        /// How often it was sent.
        sent: u16,
        /// How far it had come, in percent, as far as the peer said so; it may have been carried out all the same.
        progress: Option<u8>,
    },
    /// The peer reports progress, and comes to no end.
    Endless {
        /// The command.
        command: MavCmd,
        /// How far it had come, in percent, as far as the peer said so.
        progress: Option<u8>,
    },
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let progress = match self {
            Self::Refused { command, result, reason, progress } => {
                write!(f, "{command} was refused: {result}")?;
                if *reason != 0 {
                    write!(f, ", reason {reason}")?;
                }
                progress
            }
            Self::Timeout { command, sent, progress } => {
                write!(f, "{command} was sent {sent} times, and the answer never came")?;
                progress
            }
            Self::Endless { command, progress } => {
                write!(f, "{command} is reported to be in progress for too long")?;
                progress
            }
        };
        match progress {
            Some(percent) => write!(f, ", at {percent} %"),
            None => Ok(()),
        }
    }
}

impl Error for Failure {}

/// A message is neither `COMMAND_LONG` nor `COMMAND_INT` as `common` defines them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoCommand {
    /// The id of the message.
    pub message_id: u32,
}

impl fmt::Display for NoCommand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { message_id } = self;
        write!(f, "message {message_id} is neither COMMAND_LONG nor COMMAND_INT as common.xml defines them")
    }
}

impl Error for NoCommand {}
