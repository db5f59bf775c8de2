//! Why something did not happen.

use std::fmt;
use std::string::String;
use std::time::Duration;

use mavlink_wire::TooLong;
use mavlink_wire::link::LinkError;

use crate::{Address, command, mission, param, timesync};

/// A station did not get what it asked for.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// The link has failed.
    Link(LinkError),
    /// No vehicle has sent a heartbeat.
    NoVehicle {
        /// How long it was waited for.
        waited: Duration,
    },
    /// A command was refused, or not answered.
    Command {
        /// What became of it.
        failure: command::Failure,
        /// What the vehicle had to say about it, in `STATUSTEXT`s of the same second.
        text: Option<String>,
    },
    /// What was to be sent is no command.
    NoCommand(command::NoCommand),
    /// A parameter was not read or not set.
    Param(param::Failure),
    /// The name of a parameter has more than 16 characters.
    Name(TooLong),
    /// A plan was not moved.
    Mission(mission::Failure),
    /// The clock of the vehicle was not measured.
    Time(timesync::Failure),
    /// The operation had come to its end before.
    Over,
    /// The component cannot be addressed: ids of zero stand for all.
    Nobody(Address),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Link(error) => error.fmt(f),
            Self::NoVehicle { waited } => write!(
                f,
                "no vehicle has sent a heartbeat in {waited:?}: is it on, does it send to this address, and is the speed right?"
            ),
            Self::Command { failure, text: Some(text) } => write!(f, "{failure}; the vehicle says: {text}"),
            Self::Command { failure, text: None } => failure.fmt(f),
            Self::NoCommand(error) => error.fmt(f),
            Self::Param(failure) => failure.fmt(f),
            Self::Name(error) => write!(f, "the name of the parameter: {error}"),
            Self::Mission(failure) => failure.fmt(f),
            Self::Time(failure) => failure.fmt(f),
            Self::Over => f.write_str("this operation has come to its end before: make another one"),
            Self::Nobody(address) => write!(f, "{address} stands for several components: name one"),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Link(error) => Some(error),
            _ => None,
        }
    }
}

macro_rules! from {
    ($($failure:ty => $variant:ident),* $(,)?) => {
        $(impl From<$failure> for Error {
            fn from(failure: $failure) -> Self {
                Self::$variant(failure)
            }
        })*
    };
}

from! {
    LinkError => Link,
    command::NoCommand => NoCommand,
    param::Failure => Param,
    TooLong => Name,
    mission::Failure => Mission,
    timesync::Failure => Time,
}

impl From<command::Failure> for Error {
    fn from(failure: command::Failure) -> Self {
        Self::Command { failure, text: None }
    }
}
