//! A message: its fields, one by one.

use core::fmt;

use serde_core::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_core::ser::{Serialize, SerializeStruct, SerializeTuple, Serializer};

use super::field::{FieldSeed, FieldValue, key};
use crate::{Encode, FieldInfo, MAX_PAYLOAD, Message, MessageInfo};

/// A message: what it is, and its payload.
pub(super) struct Body<'p> {
    pub(super) info: &'static MessageInfo,
    pub(super) fields: &'static [FieldInfo],
    pub(super) payload: &'p [u8; MAX_PAYLOAD],
}

impl Body<'_> {
    pub(super) fn serialize_fields<S: SerializeStruct>(&self, to: &mut S) -> Result<(), S::Error> {
        for field in self.fields {
            to.serialize_field(key(field), &FieldValue { field, payload: self.payload })?;
        }
        Ok(())
    }
}

impl Serialize for Body<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if serializer.is_human_readable() {
            let mut fields = serializer.serialize_struct(self.info.name, self.fields.len())?;
            self.serialize_fields(&mut fields)?;
            return fields.end();
        }
        let mut fields = serializer.serialize_tuple(self.fields.len())?;
        for field in self.fields {
            fields.serialize_element(&FieldValue { field, payload: self.payload })?;
        }
        fields.end()
    }
}

/// Fills a payload.
pub(super) struct BodySeed<'p> {
    pub(super) info: &'static MessageInfo,
    pub(super) fields: &'static [FieldInfo],
    pub(super) payload: &'p mut [u8; MAX_PAYLOAD],
}

impl<'de> DeserializeSeed<'de> for BodySeed<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        if deserializer.is_human_readable() {
            deserializer.deserialize_struct(self.info.name, &[], self)
        } else {
            deserializer.deserialize_tuple(self.fields.len(), self)
        }
    }
}

impl<'de> Visitor<'de> for BodySeed<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the {} fields of {}", self.fields.len(), self.info.name)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        let mut fields = Fields::new(self.fields, None);
        fields.read(&mut map, self.payload)?;
        fields.finish()
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<(), A::Error> {
        for (at, field) in self.fields.iter().enumerate() {
            let found = seq.next_element_seed(FieldSeed { field, payload: self.payload })?;
            if found.is_none() && !field.extension {
                return Err(A::Error::invalid_length(at, &self));
            }
        }
        Ok(())
    }
}

/// Fields by their keys, each at most once.
pub(super) struct Fields {
    fields: &'static [FieldInfo],
    /// A key that came before, and may not come again.
    tag: Option<&'static str>,
    seen: [bool; MAX_PAYLOAD],
}

impl Fields {
    pub(super) fn new(fields: &'static [FieldInfo], tag: Option<&'static str>) -> Self {
        Self { fields, tag, seen: [false; MAX_PAYLOAD] }
    }

    pub(super) fn read<'de, A: MapAccess<'de>>(
        &mut self,
        map: &mut A,
        payload: &mut [u8; MAX_PAYLOAD],
    ) -> Result<(), A::Error> {
        while let Some(position) = map.next_key_seed(Key { fields: self.fields, tag: self.tag })? {
            let place = position.and_then(|at| Some((self.fields.get(at)?, self.seen.get_mut(at)?)));
            let Some((field, seen)) = place else {
                map.next_value::<IgnoredAny>()?;
                continue;
            };
            if core::mem::replace(seen, true) {
                return Err(A::Error::duplicate_field(key(field)));
            }
            map.next_value_seed(FieldSeed { field, payload })?;
        }
        Ok(())
    }

    /// Whether all are there that have to be.
    pub(super) fn finish<E: Error>(&self) -> Result<(), E> {
        match self.fields.iter().zip(&self.seen).find(|(field, seen)| !**seen && !field.extension) {
            Some((field, _)) => Err(E::missing_field(key(field))),
            None => Ok(()),
        }
    }
}

/// Reads a key; gives the position of its field, if there is one.
struct Key {
    fields: &'static [FieldInfo],
    tag: Option<&'static str>,
}

impl<'de> DeserializeSeed<'de> for Key {
    type Value = Option<usize>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Key {
    type Value = Option<usize>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a field")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<Self::Value, E> {
        match self.tag {
            Some(tag) if tag == name => Err(E::duplicate_field(tag)),
            _ => Ok(self.fields.iter().position(|field| key(field) == name)),
        }
    }
}

/// What the macros make of a message.
///
/// # Errors
///
/// Those of the serializer.
pub fn serialize_message<M: Message, S: Serializer>(message: &M, serializer: S) -> Result<S::Ok, S::Error> {
    let mut payload = [0; MAX_PAYLOAD];
    message.write(&mut payload);
    Body { info: M::INFO, fields: M::FIELDS, payload: &payload }.serialize(serializer)
}

/// What the macros make of a message.
///
/// # Errors
///
/// A field is missing, or has a value that does not fit.
pub fn deserialize_message<'de, M: Message, D: Deserializer<'de>>(deserializer: D) -> Result<M, D::Error> {
    let mut payload = [0; MAX_PAYLOAD];
    BodySeed { info: M::INFO, fields: M::FIELDS, payload: &mut payload }.deserialize(deserializer)?;
    Ok(M::decode(&payload))
}
