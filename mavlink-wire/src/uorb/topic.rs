//! What generated uORB messages implement.

use super::cdr::{self, CdrError};
use super::{Definition, Fields};

/// A uORB message, made by `mavgen` of its `.msg` files.
///
/// The struct is the union of its [`DEFINITIONS`](Self::DEFINITIONS): what a payload or a log does not have is read as
/// [`UNKNOWN`](Fields::UNKNOWN).
pub trait Topic: Fields {
    /// Name of the message, `EscStatus`.
    const NAME: &'static str;

    /// The topics that carry it, `["esc_status"]`: what logs call it. The first is the one that it is named after.
    const TOPICS: &'static [&'static str];

    /// `MESSAGE_VERSION`: which version of the message the newest definition is, if it has one.
    const VERSION: Option<u32> = None;

    /// `ORB_QUEUE_LENGTH`: how many messages PX4 keeps of an instance.
    const QUEUE: u32 = 1;

    /// What it was at different times, newest first.
    const DEFINITIONS: &'static [Definition];

    /// Writes a record of a log, of the newest definition; the rest of the bytes is left as it was.
    ///
    /// # Errors
    ///
    /// The record is too short, or a field holds what this definition cannot.
    fn store_record(&self, record: &mut [u8]) -> Result<(), CdrError>;

    /// Reads a body of `DEFINITIONS[definition]`, of its length at least.
    ///
    /// # Errors
    ///
    /// There is no such definition; the body is shorter; a `bool` is neither 0 nor 1.
    fn read_cdr(definition: usize, body: &[u8]) -> Result<Self, CdrError>;

    /// Writes a body of `DEFINITIONS[definition]` over zeros.
    ///
    /// # Errors
    ///
    /// There is no such definition; the body is shorter; a field holds what this definition cannot.
    fn store_cdr(&self, definition: usize, body: &mut [u8]) -> Result<(), CdrError>;

    /// Reads a payload of this definition.
    ///
    /// # Errors
    ///
    /// The header is not that of plain little-endian CDR; the body has another length (but for padding to four bytes); a `bool`
    /// is neither 0 nor 1.
    fn from_cdr_as(definition: &Definition, payload: &[u8]) -> Result<Self, CdrError> {
        let body = cdr::body(payload)?;
        let i = position::<Self>(definition)?;
        let known = Self::DEFINITIONS.get(i..=i).unwrap_or_default();
        cdr::definition(known, body.len())?;
        Self::read_cdr(i, body)
    }

    /// Writes a payload of this definition into a buffer, and returns it.
    ///
    /// # Errors
    ///
    /// The buffer is too short, or a field holds what this definition cannot.
    fn to_cdr<'b>(&self, definition: &Definition, buffer: &'b mut [u8]) -> Result<&'b [u8], CdrError> {
        let i = position::<Self>(definition)?;
        let length = definition.cdr_len as usize;
        self.store_cdr(i, cdr::begin(buffer, length)?)?;
        Ok(buffer.get(..cdr::HEADER + length).unwrap_or_default())
    }
}

/// A topic whose definitions differ in length, so that a payload says by its own which one it is of.
pub trait TopicByLength: Topic {
    /// Reads a payload of any definition.
    ///
    /// # Errors
    ///
    /// As [`from_cdr_as`](Topic::from_cdr_as); a length that no definition has.
    fn from_cdr(payload: &[u8]) -> Result<Self, CdrError> {
        let body = cdr::body(payload)?;
        Self::read_cdr(cdr::definition(Self::DEFINITIONS, body.len())?, body)
    }
}

fn position<T: Topic>(definition: &Definition) -> Result<usize, CdrError> {
    // Definitions of one message that have one hash are one definition.
    T::DEFINITIONS.iter().position(|known| known.message_hash == definition.message_hash).ok_or(CdrError::Definition)
}
