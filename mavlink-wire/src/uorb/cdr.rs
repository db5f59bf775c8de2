//! CDR, the form in which uORB messages leave a PX4 for ROS 2: through uXRCE-DDS or zenoh, and into rosbag2 and MCAP files.
//!
//! A payload is a header of four bytes and a body: each scalar little-endian, aligned to its size from the start of the body.
//! Which definition it is of is not in it: only its length tells. [`from_cdr`](super::TopicByLength::from_cdr) goes by that.

use core::fmt;

use super::Definition;

/// Bytes of the header.
pub const HEADER: usize = 4;

/// The header of a payload in plain CDR, little-endian.
const PLAIN_LITTLE: [u8; HEADER] = [0, 1, 0, 0];

/// Why a payload is no message, or a message no payload.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CdrError {
    /// The payload ends within its header.
    NoHeader,
    /// Another encoding than plain little-endian CDR: big-endian, or one of XCDR2.
    Encoding([u8; 2]),
    /// The body has another length than the definitions.
    Length {
        /// Bytes of the body.
        found: usize,
        /// What is known of the topic.
        known: &'static [Definition],
    },
    /// A definition of another topic, or one that the generated code does not have.
    Definition,
    /// A `bool` that is neither 0 nor 1: with PX4, the sign of another definition.
    Bool {
        /// Name of the field.
        field: &'static str,
        /// The byte.
        value: u8,
    },
    /// What this field holds does not fit into the definition that is written.
    DoesNotFit {
        /// Name of the field.
        field: &'static str,
    },
    /// The buffer is too short.
    NoRoom {
        /// Bytes that are needed.
        needed: usize,
    },
}

impl fmt::Display for CdrError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoHeader => f.write_str("the payload ends within its header of 4 bytes"),
            Self::Encoding([high, low]) => {
                write!(
                    f,
                    "the payload is not plain little-endian CDR: its header begins with {high:02x} {low:02x}, not with 00 01"
                )
            }
            Self::Length { found, known } => {
                write!(f, "a body of {found} bytes; known are ")?;
                for (i, definition) in known.iter().enumerate() {
                    let separator = if i == 0 { "" } else { ", " };
                    write!(f, "{separator}{} ({})", definition.cdr_len, definition.name)?;
                }
                Ok(())
            }
            Self::Definition => f.write_str("the message has no such definition"),
            Self::Bool { field, value } => {
                write!(f, "{field} is a bool of the value {value}: the sender has another definition")
            }
            Self::DoesNotFit { field } => {
                write!(f, "what {field} holds does not fit into the definition that is written")
            }
            Self::NoRoom { needed } => write!(f, "the buffer is too short: {needed} bytes are needed"),
        }
    }
}

impl core::error::Error for CdrError {}

/// The body of a payload.
pub(super) fn body(payload: &[u8]) -> Result<&[u8], CdrError> {
    let Some((header, body)) = payload.split_first_chunk::<HEADER>() else { return Err(CdrError::NoHeader) };
    match header {
        // The last two bytes are options; their meaning is the sender's own.
        [0, 1, _, _] => Ok(body),
        [high, low, ..] => Err(CdrError::Encoding([*high, *low])),
    }
}

/// The definition of a body of this length. DDS may round it up to four bytes.
pub(super) fn definition(known: &'static [Definition], found: usize) -> Result<usize, CdrError> {
    let exact = |definition: &Definition| usize::try_from(definition.cdr_len) == Ok(found);
    let padded = |definition: &Definition| usize::try_from(definition.cdr_len.next_multiple_of(4)) == Ok(found);
    let by_length = known.iter().position(exact).or_else(|| known.iter().position(padded));
    by_length.ok_or(CdrError::Length { found, known })
}

/// The body of a buffer, behind a header that is written; of `length` zeros.
pub(super) fn begin(buffer: &mut [u8], length: usize) -> Result<&mut [u8], CdrError> {
    let needed = HEADER + length;
    let Some((header, body)) = buffer.get_mut(..needed).and_then(<[u8]>::split_first_chunk_mut::<HEADER>) else {
        return Err(CdrError::NoRoom { needed });
    };
    *header = PLAIN_LITTLE;
    body.fill(0);
    Ok(body)
}
