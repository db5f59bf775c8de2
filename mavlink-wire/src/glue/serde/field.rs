//! A field of a message, in its payload.

use core::fmt;

use serde_core::de::{DeserializeSeed, Deserializer, Error, Expected, IgnoredAny, SeqAccess, Unexpected, Visitor};
use serde_core::ser::{Serialize, SerializeTuple, Serializer};

use super::chars;
use super::value::{Shape, Value};
use crate::{FieldInfo, Invalid, Kind, MAX_PAYLOAD};

/// The key of a field. `type` is the key of the message's name, so a field of that name has another one; the second arm
/// keeps it from meeting a field that is called so.
pub(super) fn key(field: &FieldInfo) -> &'static str {
    match field.name {
        "type" => "mavtype",
        "mavtype" => "mavmavtype",
        name => name,
    }
}

/// The element of a field; 0 is the one of a field that is no array.
fn shape(field: &FieldInfo, at: usize) -> Shape {
    let invalid = match field.invalid {
        Some(Invalid::Each(sentinel)) => Some(sentinel),
        Some(Invalid::All(sentinel) | Invalid::First(sentinel)) if at == 0 => Some(sentinel),
        _ => None,
    };
    Shape { kind: field.kind, values: field.values, invalid }
}

/// The bytes of a field.
fn bytes_of(field: &FieldInfo) -> core::ops::Range<usize> {
    let offset = usize::from(field.offset);
    offset..offset + field.size()
}

/// A field and where to read it.
pub(super) struct FieldValue<'p> {
    pub(super) field: &'static FieldInfo,
    pub(super) payload: &'p [u8],
}

impl FieldValue<'_> {
    fn value(&self, at: usize) -> Value {
        let (shape, offset) = (shape(self.field, at), usize::from(self.field.offset));
        Value { shape, bits: shape.read(self.payload, offset + at * self.field.kind.size()) }
    }
}

impl Serialize for FieldValue<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Some(length) = self.field.array.map(usize::from) else {
            return self.value(0).serialize(serializer);
        };
        if self.field.kind == Kind::Char {
            return chars::serialize(self.payload.get(bytes_of(self.field)).unwrap_or_default(), serializer);
        }
        let mut tuple = serializer.serialize_tuple(length)?;
        for at in 0..length {
            tuple.serialize_element(&self.value(at))?;
        }
        tuple.end()
    }
}

/// A field and where to put it.
pub(super) struct FieldSeed<'p> {
    pub(super) field: &'static FieldInfo,
    pub(super) payload: &'p mut [u8; MAX_PAYLOAD],
}

impl FieldSeed<'_> {
    /// Whether the first element of the array says that no other is known.
    fn is_known_as_a_whole(&self) -> bool {
        matches!(self.field.invalid, Some(Invalid::All(_)))
    }

    fn put(&mut self, at: usize, bits: u64) {
        let (shape, offset) = (shape(self.field, at), usize::from(self.field.offset));
        shape.write(bits, self.payload, offset + at * self.field.kind.size());
    }
}

/// Refuses what follows the last element, by the number of elements.
pub(super) fn nothing_more<'de, A: SeqAccess<'de>>(
    seq: &mut A,
    length: usize,
    expected: &dyn Expected,
) -> Result<(), A::Error> {
    let mut found = length;
    while seq.next_element::<IgnoredAny>()?.is_some() {
        found += 1;
    }
    if found == length { Ok(()) } else { Err(A::Error::invalid_length(found, expected)) }
}

impl<'de> DeserializeSeed<'de> for FieldSeed<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(mut self, deserializer: D) -> Result<(), D::Error> {
        match self.field.array {
            None => {
                let bits = shape(self.field, 0).deserialize(deserializer)?;
                self.put(0, bits);
                Ok(())
            }
            Some(_) if self.field.kind == Kind::Char => {
                chars::deserialize(self.payload.get_mut(bytes_of(self.field)).unwrap_or_default(), deserializer)
            }
            Some(_) if self.is_known_as_a_whole() && deserializer.is_human_readable() => {
                deserializer.deserialize_any(self)
            }
            Some(length) => deserializer.deserialize_tuple(length.into(), self),
        }
    }
}

impl<'de> Visitor<'de> for FieldSeed<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} values of type {}", self.field.array.unwrap_or(1), self.field.kind.wire_name())
    }

    fn visit_seq<A: SeqAccess<'de>>(mut self, mut seq: A) -> Result<(), A::Error> {
        for at in 0..usize::from(self.field.array.unwrap_or(1)) {
            match seq.next_element_seed(shape(self.field, at))? {
                Some(bits) => self.put(at, bits),
                None => return Err(A::Error::invalid_length(at, &self)),
            }
        }
        nothing_more(&mut seq, usize::from(self.field.array.unwrap_or(1)), &self)
    }

    /// An array of which nothing is known.
    fn visit_unit<E: Error>(mut self) -> Result<(), E> {
        let unknown = shape(self.field, 0).unknown().ok_or_else(|| E::invalid_type(Unexpected::Unit, &self))?;
        self.put(0, unknown);
        Ok(())
    }
}
