//! Why a frame is not to be trusted, or a key not to be sent.

use core::error::Error;
use core::fmt;

use crate::{ComponentId, SystemId, Timestamp};

/// A signature proves nothing, or a key would go to more than one component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
#[non_exhaustive]
pub enum SigningError {
    /// The frame is not signed; MAVLink 1 never is.
    Unsigned {
        /// The id of the message.
        message_id: u32,
    },
    /// The hash is not that of the key: a forgery, or a sender with another key.
    WrongHash {
        /// Which of the sender's links.
        link_id: u8,
        /// The sending system.
        system_id: SystemId,
        /// The sending component.
        component_id: ComponentId,
    },
    /// The timestamp is not after that of the stream's last frame: a replay, or a sender that went back in time.
    Replayed {
        /// The timestamp of the frame.
        timestamp: Timestamp,
        /// The timestamp of the last frame.
        last: Timestamp,
    },
    /// The first frame of a stream is over a minute behind the local time.
    TooOld {
        /// The timestamp of the frame.
        timestamp: Timestamp,
        /// The local time.
        local: Timestamp,
    },
    /// The frame is over a day ahead of the clock: its sender's is wrong, and must not take everybody's along.
    TooFarAhead {
        /// The timestamp of the frame.
        timestamp: Timestamp,
        /// The local time.
        local: Timestamp,
    },
    /// There is no room for one more stream.
    TooManyStreams {
        /// The number of streams that there is room for.
        limit: usize,
    },
    /// A key is for one component of one system; zero means all of them.
    Broadcast {
        /// The addressed system.
        system_id: SystemId,
        /// The addressed component.
        component_id: ComponentId,
    },
}

impl fmt::Display for SigningError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unsigned { message_id: id } => {
                write!(f, "message {id} is not signed: discard the frame, or let check_with allow the message")
            }
            Self::WrongHash { link_id, system_id, component_id } => write!(
                f,
                "the signature of link {link_id} of {system_id}/{component_id} is not of this key: discard the frame; if it never \
                 is, give both sides the same key"
            ),
            Self::Replayed { timestamp, last } => write!(
                f,
                "timestamp {} is not after {}, the last of its stream: discard the frame; a sender that restarts has to go \
                 on from its saved timestamp",
                timestamp.units(),
                last.units()
            ),
            Self::TooOld { timestamp, local } => write!(
                f,
                "timestamp {} of a new stream is over a minute behind {}: discard the frame, and set the sender's clock",
                timestamp.units(),
                local.units()
            ),
            Self::TooFarAhead { timestamp, local } => write!(
                f,
                "timestamp {} is over a day ahead of {}: discard the frame, and set the sender's clock",
                timestamp.units(),
                local.units()
            ),
            Self::TooManyStreams { limit } => {
                write!(f, "all {limit} streams are in use: make the verifier with room for more")
            }
            Self::Broadcast { system_id, component_id } => {
                write!(f, "a key cannot go to {system_id}/{component_id}, which are many: send it to each in turn")
            }
        }
    }
}

impl Error for SigningError {}
