//! `char` arrays: text where that says everything, else numbers.

use core::fmt;

use serde_core::de::{Deserialize, DeserializeSeed, Deserializer, Error, SeqAccess, Unexpected, Visitor};
use serde_core::ser::{Serialize, SerializeTuple, Serializer};

use super::field::nothing_more;
use super::value::byte_of;
use crate::{Chars, TooLong};

/// The text, if the bytes are it and nothing else.
fn text(bytes: &[u8]) -> Option<&str> {
    let (text, rest) = match bytes.iter().position(|&byte| byte == 0) {
        Some(nul) => bytes.split_at_checked(nul)?,
        None => (bytes, &[][..]),
    };
    if rest.iter().all(|&byte| byte == 0) { core::str::from_utf8(text).ok() } else { None }
}

pub(super) fn serialize<S: Serializer>(bytes: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
    if serializer.is_human_readable()
        && let Some(text) = text(bytes)
    {
        return serializer.serialize_str(text);
    }
    let mut tuple = serializer.serialize_tuple(bytes.len())?;
    for byte in bytes {
        tuple.serialize_element(byte)?;
    }
    tuple.end()
}

pub(super) fn deserialize<'de, D: Deserializer<'de>>(bytes: &mut [u8], deserializer: D) -> Result<(), D::Error> {
    if deserializer.is_human_readable() {
        deserializer.deserialize_any(CharsVisitor(bytes))
    } else {
        deserializer.deserialize_tuple(bytes.len(), CharsVisitor(bytes))
    }
}

/// Fills the bytes of the array.
struct CharsVisitor<'b>(&'b mut [u8]);

impl<'de> Visitor<'de> for CharsVisitor<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "text of at most {0} bytes, or {0} numbers or characters", self.0.len())
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<(), E> {
        let error = TooLong { length: text.len(), capacity: self.0.len() };
        let (filled, rest) = self.0.split_at_mut_checked(text.len()).ok_or_else(|| E::custom(error))?;
        filled.copy_from_slice(text.as_bytes());
        rest.fill(0);
        Ok(())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<(), A::Error> {
        let mut is_text = true;
        for at in 0..self.0.len() {
            match seq.next_element_seed(ByteSeed)? {
                Some(Byte { value, is_character }) => {
                    is_text &= is_character;
                    self.0.get_mut(at..).and_then(<[u8]>::first_mut).into_iter().for_each(|place| *place = value);
                }
                // As for a text, what is missing are NULs.
                None if is_text && at > 0 => {
                    self.0.get_mut(at..).unwrap_or_default().fill(0);
                    return Ok(());
                }
                None => return Err(A::Error::invalid_length(at, &self)),
            }
        }
        nothing_more(&mut seq, self.0.len(), &self)
    }
}

/// A byte of an array, and how it was written.
struct Byte {
    value: u8,
    is_character: bool,
}

/// Reads a number, or a text of one character, as rust-mavlink up to 0.14 wrote it.
struct ByteSeed;

impl<'de> DeserializeSeed<'de> for ByteSeed {
    type Value = Byte;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Byte, D::Error> {
        if deserializer.is_human_readable() {
            deserializer.deserialize_any(self)
        } else {
            deserializer.deserialize_u8(self)
        }
    }
}

impl Visitor<'_> for ByteSeed {
    type Value = Byte;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a character of one byte, or its number")
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<Byte, E> {
        let value = u8::try_from(number).map_err(|_| E::invalid_value(Unexpected::Unsigned(number), &self))?;
        Ok(Byte { value, is_character: false })
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Byte, E> {
        let value = u8::try_from(number).map_err(|_| E::invalid_value(Unexpected::Signed(number), &self))?;
        Ok(Byte { value, is_character: false })
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Byte, E> {
        let value = byte_of(text).ok_or_else(|| E::invalid_value(Unexpected::Str(text), &self))?;
        Ok(Byte { value, is_character: true })
    }
}

impl<const N: usize> Serialize for Chars<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serialize(&self.0, serializer)
    }
}

impl<'de, const N: usize> Deserialize<'de> for Chars<N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut chars = Self::default();
        deserialize(&mut chars.0, deserializer)?;
        Ok(chars)
    }
}
