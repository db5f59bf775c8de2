//! What can go wrong. Errors are small and carry numbers; their text says what to do next.

use core::error::Error;
use core::fmt;

use crate::EnumInfo;

/// A message cannot be sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
#[non_exhaustive]
pub enum EncodeError {
    /// MAVLink 1 has one byte for the message id.
    IdTooLarge {
        /// The id of the message.
        message_id: u32,
    },
    /// MAVLink 1 has no signatures, and the sender is to sign every frame.
    SignatureInV1 {
        /// The id of the message.
        message_id: u32,
    },
    /// A `SETUP_SIGNING` goes neither to everybody nor on: its payload is a secret key.
    CarriesKey,
}

impl fmt::Display for EncodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::IdTooLarge { message_id: id } => {
                write!(f, "message id {id} is over 255, which MAVLink 1 cannot carry: send it with Sender::v2")
            }
            Self::SignatureInV1 { message_id: id } => {
                write!(f, "MAVLink 1 cannot carry the signature of message {id}: send it in MAVLink 2, or do not sign")
            }
            Self::CarriesKey => f.write_str(
                "SETUP_SIGNING carries a secret key: send it to one component that you name, and do not forward it",
            ),
        }
    }
}

impl Error for EncodeError {}

/// Of kind [`InvalidInput`](std::io::ErrorKind::InvalidInput), around the error.
#[cfg(feature = "std")]
impl From<EncodeError> for std::io::Error {
    fn from(error: EncodeError) -> Self {
        Self::new(std::io::ErrorKind::InvalidInput, error)
    }
}

/// Bytes are not a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
#[non_exhaustive]
pub enum FrameError {
    /// The first byte starts neither a MAVLink 1 nor a MAVLink 2 frame.
    NotStx {
        /// The first byte.
        found: u8,
    },
    /// The frame goes on behind the end of the bytes.
    Incomplete {
        /// Bytes needed from the start, as far as the bytes so far tell.
        needed: usize,
    },
    /// MAVLink 2 flags that demand something unknown of the receiver.
    IncompatFlags {
        /// The flags; only 0x01 (signed) is known.
        flags: u8,
    },
    /// The checksum is wrong: damage, or a sender with another definition of the message.
    Checksum {
        /// The message id in the header.
        message_id: u32,
    },
}

impl fmt::Display for FrameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotStx { found } => {
                write!(f, "a frame starts with 0xfe or 0xfd, not {found:#04x}: skip to the next such byte")
            }
            Self::Incomplete { needed } => {
                write!(f, "the frame needs at least {needed} bytes: try again with more")
            }
            Self::IncompatFlags { flags } => {
                write!(f, "incompatibility flags {flags:#04x} are not known here: discard the frame")
            }
            Self::Checksum { message_id: id } => write!(
                f,
                "the checksum does not fit message {id}: discard the frame; if it never fits, compare both sides' XML"
            ),
        }
    }
}

impl Error for FrameError {}

/// A text is longer than its field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
pub struct TooLong {
    /// Bytes of the text.
    pub length: usize,
    /// Bytes of the field.
    pub capacity: usize,
}

impl fmt::Display for TooLong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { length, capacity } = self;
        write!(f, "{length} bytes do not fit a field of {capacity}: shorten the text, or use Chars::truncated")
    }
}

impl Error for TooLong {}

/// A text names no entry of an enum and is no number that fits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
pub struct UnknownName {
    /// Name in the XML of the enum.
    pub name: &'static str,
}

impl UnknownName {
    #[doc(hidden)]
    pub const fn of(info: &EnumInfo) -> Self {
        Self { name: info.name }
    }
}

impl fmt::Display for UnknownName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "not an entry of {}: use a name from the XML, or a number in its range", self.name)
    }
}

impl Error for UnknownName {}

/// A setter was given a value that its field cannot carry, or an index that its array does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
pub struct OutOfRange;

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the field is too narrow for the value, or the array too short for the index: nothing was set")
    }
}

impl Error for OutOfRange {}

/// Packed bits cannot take a value, or a message a slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
#[non_exhaustive]
pub enum ViewError {
    /// The value is NaN, or does not fit the bits.
    OutOfRange,
    /// The layout that the view has now lacks these bits.
    Absent,
    /// The message has no such slot, or it is not in use.
    NoSuchSlot,
    /// All slots of the message are in use.
    Full,
}

impl fmt::Display for ViewError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::OutOfRange => "the value does not fit the bits: nothing was set",
            Self::Absent => "this layout does not have the bits: make the view with another switch value",
            Self::NoSuchSlot => "there is no such slot in use: add one first",
            Self::Full => "all slots are in use: start another message",
        })
    }
}

impl Error for ViewError {}
