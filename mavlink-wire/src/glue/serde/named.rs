//! Enums and flags by the names of their entries.

use core::fmt;

use serde_core::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, Unexpected, Visitor};
use serde_core::ser::Serializer;

use super::value::{Shape, Value, is_signed};
use crate::EnumInfo;
use crate::flags::{fmt_bits, parse_bits};
use crate::message::enums::parse_entry;

pub(super) fn serialize<S: Serializer>(
    value: Value,
    info: &'static EnumInfo,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    if info.bitmask {
        return match value.bits {
            0 => serializer.serialize_str(""),
            bits => serializer.collect_str(&Flags { info, bits }),
        };
    }
    match info.entry_name(value.signed() as u64) {
        Some(name) => serializer.serialize_str(name),
        None => value.serialize_number(serializer),
    }
}

/// `A | B | 0x40`
struct Flags {
    info: &'static EnumInfo,
    bits: u64,
}

impl fmt::Display for Flags {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt_bits(self.info, self.bits, f)
    }
}

/// Takes names of entries, and numbers that fit.
pub(super) struct NamedVisitor {
    pub(super) shape: Shape,
    pub(super) info: &'static EnumInfo,
}

impl NamedVisitor {
    fn parse(&self, text: &str) -> Option<u64> {
        if !self.info.bitmask {
            return self.shape.fit(parse_entry(self.info, text, is_signed(self.shape.kind)).ok()?);
        }
        let mask = u64::MAX >> (64 - 8 * self.shape.kind.size());
        if text.is_empty() { Some(0) } else { parse_bits(self.info, mask, text).ok() }
    }

    fn text<E: Error>(&self, text: &str) -> Result<u64, E> {
        self.parse(text).ok_or_else(|| E::invalid_value(Unexpected::Str(text), self))
    }

    fn number<E: Error>(&self, number: i128, found: Unexpected<'_>) -> Result<u64, E> {
        self.shape.fit(number).ok_or_else(|| E::invalid_value(found, self))
    }
}

impl<'de> Visitor<'de> for NamedVisitor {
    type Value = u64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let what = if self.info.bitmask { "flags" } else { "an entry" };
        write!(f, "{what} of {}, or a number of type {}", self.info.name, self.shape.kind.wire_name())
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<u64, E> {
        self.text(text)
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<u64, E> {
        self.number(number.into(), Unexpected::Unsigned(number))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<u64, E> {
        self.number(number.into(), Unexpected::Signed(number))
    }

    fn visit_unit<E: Error>(self) -> Result<u64, E> {
        self.shape.unknown().ok_or_else(|| E::invalid_type(Unexpected::Unit, &self))
    }

    /// `{"type": "MAV_STATE_ACTIVE"}`, as rust-mavlink writes an enum, and `{"bits": 5}`, as it wrote flags up to 0.14.
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<u64, A::Error> {
        let (key, mut value) = (if self.info.bitmask { "bits" } else { "type" }, None);
        while let Some(is_key) = map.next_key_seed(Is(key))? {
            match (is_key, value) {
                (true, None) => value = Some(map.next_value_seed(&self)?),
                (true, Some(_)) => return Err(A::Error::duplicate_field(key)),
                (false, _) => {
                    map.next_value::<IgnoredAny>()?;
                }
            }
        }
        value.ok_or_else(|| A::Error::invalid_type(Unexpected::Other("a map without the value"), &self))
    }
}

/// Whether a key is this one.
struct Is(&'static str);

impl<'de> DeserializeSeed<'de> for Is {
    type Value = bool;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<bool, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Is {
    type Value = bool;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a key")
    }

    fn visit_str<E: Error>(self, key: &str) -> Result<bool, E> {
        Ok(key == self.0)
    }
}

/// A name or a number, in a map.
impl<'de> DeserializeSeed<'de> for &NamedVisitor {
    type Value = u64;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<u64, D::Error> {
        deserializer.deserialize_any(Inner(self))
    }
}

/// What a map has: no other map.
struct Inner<'v>(&'v NamedVisitor);

impl Visitor<'_> for Inner<'_> {
    type Value = u64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.expecting(f)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<u64, E> {
        self.0.text(text)
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<u64, E> {
        self.0.number(number.into(), Unexpected::Unsigned(number))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<u64, E> {
        self.0.number(number.into(), Unexpected::Signed(number))
    }
}
