//! Fields that come before the name of their message: what they are is not known yet, so they are kept as they came.
//!
//! A fixed buffer, because there may be no allocator.

use core::fmt;
use core::marker::PhantomData;

use serde_core::de::{DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_core::forward_to_deserialize_any;

/// Room for every message: 255 numbers of 9 bytes, or the names of all flags of SYS_STATUS (4.4 KiB), and the keys.
const ROOM: usize = 8192;

/// What begins each kept item.
mod tag {
    pub(super) const NOTHING: u8 = 0;
    pub(super) const BOOL: u8 = 1;
    pub(super) const UNSIGNED: u8 = 2;
    pub(super) const SIGNED: u8 = 3;
    pub(super) const FLOAT: u8 = 4;
    pub(super) const TEXT: u8 = 5;
    pub(super) const LIST: u8 = 6;
    pub(super) const MAP: u8 = 7;
    pub(super) const END: u8 = 8;
}

/// Keys and values, one after the other.
pub(super) struct EarlyFields {
    bytes: [u8; ROOM],
    length: usize,
}

impl EarlyFields {
    pub(super) const fn new() -> Self {
        Self { bytes: [0; ROOM], length: 0 }
    }

    /// What was kept, as a map.
    pub(super) fn replay<E>(&self) -> Replay<'_, E> {
        Replay { rest: self.bytes.get(..self.length).unwrap_or_default(), error: PhantomData }
    }

    fn push<E: Error>(&mut self, tag: u8, content: &[u8]) -> Result<(), E> {
        self.append(&[tag])?;
        self.append(content)
    }

    fn push_text<E: Error>(&mut self, text: &str) -> Result<(), E> {
        let length = u16::try_from(text.len()).map_err(|_| no_room())?;
        self.push(tag::TEXT, &length.to_le_bytes())?;
        self.append(text.as_bytes())
    }

    fn append<E: Error>(&mut self, bytes: &[u8]) -> Result<(), E> {
        let room = self.bytes.get_mut(self.length..).and_then(|free| free.get_mut(..bytes.len()));
        room.ok_or_else(no_room)?.copy_from_slice(bytes);
        self.length += bytes.len();
        Ok(())
    }
}

fn no_room<E: Error>() -> E {
    E::custom("too much comes before `type`: put it first")
}

/// Reads a key: `true` if it is the one that is waited for; others are kept.
pub(super) struct KeepKey<'e> {
    pub(super) until: &'static str,
    pub(super) early: &'e mut EarlyFields,
}

impl<'de> DeserializeSeed<'de> for KeepKey<'_> {
    type Value = bool;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<bool, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for KeepKey<'_> {
    type Value = bool;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a field")
    }

    fn visit_str<E: Error>(self, key: &str) -> Result<bool, E> {
        if key == self.until {
            return Ok(true);
        }
        self.early.push_text(key)?;
        Ok(false)
    }
}

/// Keeps a value.
pub(super) struct Keep<'e> {
    early: &'e mut EarlyFields,
    /// How many lists and maps may lie in each other: no field needs more than one.
    depth: u8,
}

impl<'e> Keep<'e> {
    pub(super) fn new(early: &'e mut EarlyFields) -> Self {
        Self { early, depth: 8 }
    }

    /// For what lies in a list or a map.
    fn inner<E: Error>(&mut self) -> Result<Keep<'_>, E> {
        let depth = self.depth.checked_sub(1).ok_or_else(no_room)?;
        Ok(Keep { early: self.early, depth })
    }
}

impl<'de> DeserializeSeed<'de> for Keep<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Keep<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the value of a field")
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<(), E> {
        self.early.push(tag::BOOL, &[value.into()])
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<(), E> {
        self.early.push(tag::UNSIGNED, &value.to_le_bytes())
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<(), E> {
        self.early.push(tag::SIGNED, &value.to_le_bytes())
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<(), E> {
        self.early.push(tag::FLOAT, &value.to_le_bytes())
    }

    fn visit_str<E: Error>(self, value: &str) -> Result<(), E> {
        self.early.push_text(value)
    }

    fn visit_unit<E: Error>(self) -> Result<(), E> {
        self.early.push(tag::NOTHING, &[])
    }

    fn visit_seq<A: SeqAccess<'de>>(mut self, mut seq: A) -> Result<(), A::Error> {
        self.early.push(tag::LIST, &[])?;
        while seq.next_element_seed(self.inner()?)?.is_some() {}
        self.early.push(tag::END, &[])
    }

    fn visit_map<A: MapAccess<'de>>(mut self, mut map: A) -> Result<(), A::Error> {
        self.early.push(tag::MAP, &[])?;
        while map.next_key_seed(self.inner()?)?.is_some() {
            map.next_value_seed(self.inner()?)?;
        }
        self.early.push(tag::END, &[])
    }
}

/// What was kept, read again: an item, or the items up to an end.
pub(super) struct Replay<'e, E> {
    rest: &'e [u8],
    error: PhantomData<E>,
}

impl<'e, E: Error> Replay<'e, E> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N], E> {
        let (taken, rest) = self.rest.split_first_chunk().ok_or_else(no_room)?;
        self.rest = rest;
        Ok(*taken)
    }

    fn take_text(&mut self) -> Result<&'e str, E> {
        let length = u16::from_le_bytes(self.take()?);
        let (text, rest) = self.rest.split_at_checked(length.into()).ok_or_else(no_room)?;
        self.rest = rest;
        core::str::from_utf8(text).map_err(E::custom)
    }

    /// Whether the list or the map is at its end, or all is.
    fn at_end(&self) -> bool {
        matches!(self.rest, [] | [tag::END, ..])
    }

    /// Leaves a list or a map of which everything was read.
    fn leave(&mut self) -> Result<(), E> {
        match self.take()? {
            [tag::END] => Ok(()),
            _ => Err(E::custom("an array has too many elements")),
        }
    }
}

impl<'de, E: Error> Deserializer<'de> for &mut Replay<'_, E> {
    type Error = E;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, E> {
        match self.take()? {
            [tag::BOOL] => visitor.visit_bool(self.take()? != [0]),
            [tag::UNSIGNED] => visitor.visit_u64(u64::from_le_bytes(self.take()?)),
            [tag::SIGNED] => visitor.visit_i64(i64::from_le_bytes(self.take()?)),
            [tag::FLOAT] => visitor.visit_f64(f64::from_le_bytes(self.take()?)),
            [tag::TEXT] => visitor.visit_str(self.take_text()?),
            [tag::LIST] => {
                let value = visitor.visit_seq(&mut *self)?;
                self.leave()?;
                Ok(value)
            }
            [tag::MAP] => {
                let value = visitor.visit_map(&mut *self)?;
                self.leave()?;
                Ok(value)
            }
            _ => visitor.visit_unit(),
        }
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

impl<'de, E: Error> SeqAccess<'de> for Replay<'_, E> {
    type Error = E;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, E> {
        if self.at_end() { Ok(None) } else { seed.deserialize(self).map(Some) }
    }
}

impl<'de, E: Error> MapAccess<'de> for Replay<'_, E> {
    type Error = E;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, E> {
        if self.at_end() { Ok(None) } else { seed.deserialize(self).map(Some) }
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, E> {
        seed.deserialize(self)
    }
}
