//! What can be wrong with a command.

use core::error::Error;
use core::fmt;

/// A message cannot carry this command, or carries another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
#[non_exhaustive]
pub enum CommandError {
    /// The message carries another command.
    OtherCommand {
        /// The number of the command that was asked for.
        expected: u16,
        /// The number of the command that came.
        found: u16,
    },
    /// The value of a param is not allowed.
    Param {
        /// The number of the param, 1 to 7.
        index: u8,
        /// What is wrong with it.
        error: ParamError,
    },
    /// Coordinates have no meaning in this frame.
    Frame {
        /// Its number in `MAV_FRAME`.
        frame: u8,
    },
}

/// What is wrong with a param of a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
#[non_exhaustive]
pub enum ParamError {
    /// The message, or the field, cannot hold the value.
    OutOfRange,
    /// It has to be a whole number.
    NotWhole,
    /// A float cannot represent the value of an enum exactly; possible above 2²⁴.
    NoFloat,
}

impl fmt::Display for CommandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OtherCommand { expected, found } => {
                write!(f, "the message carries command {found}, not {expected}: look at its field `command` first")
            }
            Self::Param { index, error } => write!(f, "param {index} {error}"),
            Self::Frame { frame } => {
                write!(f, "a place has no meaning in frame {frame}: use a global or a local frame of MAV_FRAME")
            }
        }
    }
}

/// Without the param: "has to be a whole number".
impl fmt::Display for ParamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::OutOfRange => "is out of range",
            Self::NotWhole => "has to be a whole number",
            Self::NoFloat => "is a whole number that no float is: send it as COMMAND_INT, if it is param 5 or 6",
        })
    }
}

impl Error for CommandError {}

impl Error for ParamError {}
