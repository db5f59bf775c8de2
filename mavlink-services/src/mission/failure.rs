//! Why a station could not move a plan.

use core::error::Error;
use core::fmt;

use crate::common::MavMissionResult;

/// An operation on a plan has failed. The vehicle's plan is as it was, if the vehicle keeps to the protocol.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Failure {
    /// The peer did not answer.
    Timeout {
        /// What was waited for.
        awaited: Awaited,
        /// How often it was asked for, in vain.
        asked: u16,
    },
    /// The peer refused, for this reason.
    Refused(MavMissionResult),
    /// The program cancelled the transfer.
    Cancelled,
    /// There are more items than a message can count, or than the program wants to take.
    TooMany {
        /// How many there are; 65,535 may be more.
        count: u16,
    },
    /// A part of a plan is asked for that the plan does not have.
    NoSuchItem {
        /// How many items the plan has.
        count: u16,
    },
    /// MAVLink 1 has the mission alone: what is meant for another plan would change it.
    Version1,
    /// The position of an item is no number that the message can carry.
    Position {
        /// The index of the item.
        seq: u16,
    },
}

/// What a station waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Awaited {
    /// That the vehicle asks for the first item.
    Begin,
    /// That the vehicle asks for this item.
    Request(u16),
    /// That the vehicle says it has all, or has done it.
    Ack,
    /// How many items the vehicle has.
    Count,
    /// This item.
    Item(u16),
    /// That the vehicle says it is at this item.
    Current(u16),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Timeout { awaited, asked } => write!(f, "no answer: {awaited} did not come, asked for {asked} times"),
            Self::Refused(result) => write!(f, "the vehicle refused: {result}"),
            Self::Cancelled => f.write_str("the transfer was cancelled"),
            Self::TooMany { count } => {
                write!(f, "a plan of {count} items or more is too long: split it, or raise the limit")
            }
            Self::NoSuchItem { count } => write!(f, "the part goes beyond the plan, which has {count} items"),
            Self::Version1 => {
                f.write_str("MAVLink 1 has neither fence nor rally points: speak MAVLink 2 to the vehicle")
            }
            Self::Position { seq } => write!(f, "the position of item {seq} is out of range or not a number"),
        }
    }
}

impl fmt::Display for Awaited {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Begin => f.write_str("the request for the first item"),
            Self::Request(seq) => write!(f, "the request for item {seq}"),
            Self::Ack => f.write_str("the acknowledgement"),
            Self::Count => f.write_str("the number of items"),
            Self::Item(seq) => write!(f, "item {seq}"),
            Self::Current(seq) => write!(f, "the word that item {seq} is the current one"),
        }
    }
}

impl Error for Failure {}
