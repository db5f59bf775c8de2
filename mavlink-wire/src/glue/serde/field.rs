//! A field of a message, in its payload.

use core::fmt;

use serde_core::de::{DeserializeSeed, Deserializer, Error, SeqAccess, Visitor};
use serde_core::ser::{Serialize, SerializeTuple, Serializer};

use super::chars;
use super::value::{Shape, Value};
use crate::{FieldInfo, Kind, MAX_PAYLOAD};

/// The key of a field. `type` is the key of the message's name, so a field of that name has another one; the second arm
/// keeps it from meeting a field that is called so.
pub(super) fn key(field: &FieldInfo) -> &'static str {
    match field.name {
        "type" => "mavtype",
        "mavtype" => "mavmavtype",
        name => name,
    }
}

fn shape(field: &FieldInfo) -> Shape {
    Shape { kind: field.kind, values: field.values }
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
        let (shape, offset) = (shape(self.field), usize::from(self.field.offset));
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
    fn put(&mut self, at: usize, bits: u64) {
        let (shape, offset) = (shape(self.field), usize::from(self.field.offset));
        shape.write(bits, self.payload, offset + at * self.field.kind.size());
    }
}

impl<'de> DeserializeSeed<'de> for FieldSeed<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(mut self, deserializer: D) -> Result<(), D::Error> {
        match self.field.array {
            None => {
                let bits = shape(self.field).deserialize(deserializer)?;
                self.put(0, bits);
                Ok(())
            }
            Some(_) if self.field.kind == Kind::Char => {
                chars::deserialize(self.payload.get_mut(bytes_of(self.field)).unwrap_or_default(), deserializer)
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
            match seq.next_element_seed(shape(self.field))? {
                Some(bits) => self.put(at, bits),
                None => return Err(A::Error::invalid_length(at, &self)),
            }
        }
        Ok(())
    }
}
