//! A dialect's enum: a message with its name, or its id.

use core::fmt;

use serde_core::de::{DeserializeSeed, Deserializer, EnumAccess, Error, MapAccess, Unexpected, VariantAccess, Visitor};
use serde_core::ser::{SerializeStruct, Serializer};

use super::early::{EarlyFields, Keep, KeepKey};
use super::message::{Body, BodySeed, Fields};
use crate::{Dialect, FieldInfo, MAX_PAYLOAD, MessageInfo, Table};

/// The key of the message's name.
pub(super) const TAG: &str = "type";

/// What the macros make of a dialect's enum, whose name is `name`.
///
/// # Errors
///
/// Those of the serializer.
pub fn serialize_dialect<D: Dialect, S: Serializer>(
    message: &D,
    name: &'static str,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let (info, mut payload) = (message.info(), [0; MAX_PAYLOAD]);
    message.write(&mut payload);
    let body = Body { info, fields: D::fields(info.id).unwrap_or_default(), payload: &payload };
    serialize_tagged(&body, name, serializer)
}

fn serialize_tagged<S: Serializer>(body: &Body<'_>, name: &'static str, serializer: S) -> Result<S::Ok, S::Error> {
    if !serializer.is_human_readable() {
        return serializer.serialize_newtype_variant(name, body.info.id, body.info.name, body);
    }
    let mut fields = serializer.serialize_struct(name, body.fields.len() + 1)?;
    fields.serialize_field(TAG, body.info.name)?;
    body.serialize_fields(&mut fields)?;
    fields.end()
}

/// What the macros make of a dialect's enum, whose name is `name`.
///
/// # Errors
///
/// The dialect does not have the message, one of its fields is missing, or has a value that does not fit.
pub fn deserialize_dialect<'de, D: Dialect, De: Deserializer<'de>>(
    name: &'static str,
    deserializer: De,
) -> Result<D, De::Error> {
    let known = Known { name, table: D::TABLE, fields: D::FIELDS };
    let (id, payload) = if deserializer.is_human_readable() {
        deserializer.deserialize_struct(name, &[], known)?
    } else {
        deserializer.deserialize_enum(name, &[], known)?
    };
    D::decode(id, &payload).ok_or_else(|| De::Error::invalid_value(Unexpected::Unsigned(id.into()), &name))
}

/// The messages of a dialect.
#[derive(Clone, Copy)]
struct Known {
    name: &'static str,
    table: &'static Table<'static>,
    fields: &'static [&'static [FieldInfo]],
}

/// A message of the dialect.
type Found = (&'static MessageInfo, &'static [FieldInfo]);

impl Known {
    fn by_id(&self, id: u64) -> Option<Found> {
        let at = self.table.position(id.try_into().ok()?)?;
        Some((self.table.iter().nth(at)?, self.fields.get(at)?))
    }

    fn by_name(&self, name: &str) -> Option<Found> {
        let mut known = self.table.iter().zip(self.fields);
        known.find(|(info, _)| info.name == name).map(|(info, fields)| (info, *fields))
    }
}

impl<'de> Visitor<'de> for Known {
    type Value = (u32, [u8; MAX_PAYLOAD]);

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a message of {}, its name under the key `{TAG}`", self.name)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut early = EarlyFields::new();
        let (info, fields) = loop {
            match map.next_key_seed(KeepKey { until: TAG, early: &mut early })? {
                None => return Err(A::Error::missing_field(TAG)),
                Some(true) => break map.next_value_seed(Which(self))?,
                Some(false) => map.next_value_seed(Keep::new(&mut early))?,
            }
        };
        let (mut payload, mut fields) = ([0; MAX_PAYLOAD], Fields::new(fields, Some(TAG)));
        fields.read(&mut early.replay(), &mut payload)?;
        fields.read(&mut map, &mut payload)?;
        fields.finish()?;
        Ok((info.id, payload))
    }

    fn visit_enum<A: EnumAccess<'de>>(self, data: A) -> Result<Self::Value, A::Error> {
        let ((info, fields), content) = data.variant_seed(Which(self))?;
        let mut payload = [0; MAX_PAYLOAD];
        content.newtype_variant_seed(BodySeed { info, fields, payload: &mut payload })?;
        Ok((info.id, payload))
    }
}

/// Finds a message by its name or its id.
struct Which(Known);

impl<'de> DeserializeSeed<'de> for Which {
    type Value = Found;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Found, D::Error> {
        if deserializer.is_human_readable() {
            deserializer.deserialize_str(self)
        } else {
            deserializer.deserialize_identifier(self)
        }
    }
}

impl Visitor<'_> for Which {
    type Value = Found;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the name of a message of {}", self.0.name)
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<Found, E> {
        self.0.by_name(name).ok_or_else(|| E::invalid_value(Unexpected::Str(name), &self))
    }

    fn visit_u64<E: Error>(self, id: u64) -> Result<Found, E> {
        self.0.by_id(id).ok_or_else(|| E::invalid_value(Unexpected::Unsigned(id), &self))
    }
}
