//! Message intervals: how often a component sends which message.
//!
//! A station uses [`set`] and [`Get`], which send commands. A component has [`Streams`], and passes them the commands that its
//! [`command::Component`](crate::command::Component) reports.

mod station;
mod streams;

pub use station::{Get, set};
pub use streams::{Event, Stream, Streams};

use core::time::Duration;

/// How often a message is sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interval {
    /// Never.
    Off,
    /// At the component's default rate. In an answer: the component does not send this message, or does not know it.
    Default,
    /// Once in this time, in whole microseconds.
    Every(Duration),
}

impl Interval {
    /// As the wire has it: microseconds, -1 or 0.
    fn to_micros(self) -> i32 {
        match self {
            Self::Off => -1,
            Self::Default => 0,
            Self::Every(time) => i32::try_from(time.as_micros()).unwrap_or(i32::MAX).max(1),
        }
    }

    /// What the wire has; what is negative is off.
    fn from_micros(micros: i32) -> Self {
        match micros {
            0 => Self::Default,
            _ => u64::try_from(micros).map_or(Self::Off, |micros| Self::Every(Duration::from_micros(micros))),
        }
    }
}
