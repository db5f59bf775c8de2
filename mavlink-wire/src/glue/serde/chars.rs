//! `char` arrays: text where that says everything, else numbers.

use core::fmt;

use serde_core::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use serde_core::ser::{Serialize, SerializeTuple, Serializer};

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
        write!(f, "text of at most {0} bytes, or {0} numbers", self.0.len())
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<(), E> {
        let error = TooLong { length: text.len(), capacity: self.0.len() };
        let (filled, rest) = self.0.split_at_mut_checked(text.len()).ok_or_else(|| E::custom(error))?;
        filled.copy_from_slice(text.as_bytes());
        rest.fill(0);
        Ok(())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<(), A::Error> {
        for at in 0..self.0.len() {
            let Some(byte) = seq.next_element()? else { return Err(A::Error::invalid_length(at, &self)) };
            if let Some(place) = self.0.get_mut(at) {
                *place = byte;
            }
        }
        Ok(())
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
