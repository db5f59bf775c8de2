//! Why a station did not get what it asked for.

use core::error::Error;
use core::fmt;

use super::{ParamValue, ValueError};
use crate::common::MavParamError;

/// An operation on parameters has failed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Failure {
    /// The peer did not answer. It may not have the parameter: most say nothing then.
    Timeout {
        /// What was waited for.
        awaited: Awaited,
        /// How often it was asked for, in vain.
        asked: u16,
    },
    /// The peer says that it cannot (`PARAM_ERROR`).
    Refused(MavParamError),
    /// The peer has this parameter and keeps the value that it had.
    Kept(ParamValue),
    /// The value is not one, cannot be sent, or does not fit the parameter's type.
    Value(ValueError),
    /// The peer has more parameters than there is room for in the storage of the list.
    TooMany {
        /// How many it says it has.
        count: u16,
        /// How many there is room for.
        capacity: u16,
    },
    /// The number of the peer's parameters changed again and again while they were listed.
    Unsteady,
}

/// What a station waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Awaited {
    /// The first parameter of a list.
    List,
    /// The rest of a list.
    Rest {
        /// How many did not come.
        missing: u16,
    },
    /// The value of one parameter.
    Value,
    /// The confirmation of a value that was set.
    Confirmation,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Timeout { awaited, asked } => write!(f, "no answer: {awaited} did not come, asked for {asked} times"),
            Self::Refused(error) => write!(f, "the component refused: {error}"),
            Self::Kept(value) => write!(f, "the component keeps its value, {value}: is the new one in range?"),
            Self::Value(error) => error.fmt(f),
            Self::TooMany { count, capacity } => {
                write!(f, "the component has {count} parameters, and there is room for {capacity}: give more storage")
            }
            Self::Unsteady => {
                f.write_str("the component's parameters became more or fewer all the time: list them again later")
            }
        }
    }
}

impl fmt::Display for Awaited {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::List => f.write_str("the list of parameters"),
            Self::Rest { missing } => write!(f, "{missing} parameters of the list"),
            Self::Value => f.write_str("the value of the parameter"),
            Self::Confirmation => f.write_str("the confirmation of the new value"),
        }
    }
}

impl Error for Failure {}

impl From<ValueError> for Failure {
    fn from(error: ValueError) -> Self {
        Self::Value(error)
    }
}
