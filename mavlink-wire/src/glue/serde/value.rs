//! Single values: a number, or the name of an enum's entry.

use core::fmt;

use serde_core::de::{DeserializeSeed, Deserializer, Error, Unexpected, Visitor};
use serde_core::ser::{Serialize, Serializer};

use super::float::FloatVisitor;
use super::named::{self, NamedVisitor};
use crate::message::wire::{get, put};
use crate::{Enum, EnumInfo, Kind, Repr, Sentinel};

/// What a value is: its type, and the enum that names it.
#[derive(Clone, Copy)]
pub(super) struct Shape {
    pub(super) kind: Kind,
    pub(super) values: Option<&'static EnumInfo>,
    /// What stands for "not known".
    pub(super) invalid: Option<Sentinel>,
}

/// A value: its bits as in the payload, zeros above.
#[derive(Clone, Copy)]
pub(super) struct Value {
    pub(super) shape: Shape,
    pub(super) bits: u64,
}

impl Shape {
    /// A number without names.
    pub(super) const fn of(kind: Kind) -> Self {
        Self { kind, values: None, invalid: None }
    }

    /// The bits at an offset of a payload.
    pub(super) fn read(self, payload: &[u8], offset: usize) -> u64 {
        match self.kind.size() {
            1 => u64::from(get::<u8>(payload, offset)),
            2 => u64::from(get::<u16>(payload, offset)),
            4 => u64::from(get::<u32>(payload, offset)),
            _ => get(payload, offset),
        }
    }

    /// Puts bits at an offset of a payload.
    pub(super) fn write(self, bits: u64, payload: &mut [u8], offset: usize) {
        match self.kind.size() {
            1 => put(payload, offset, bits as u8),
            2 => put(payload, offset, bits as u16),
            4 => put(payload, offset, bits as u32),
            _ => put(payload, offset, bits),
        }
    }

    /// The bits of what stands for "not known", if something does.
    pub(super) fn unknown(self) -> Option<u64> {
        match (self.invalid?, self.kind) {
            (Sentinel::Unsigned(value), _) => self.fit(value.into()),
            (Sentinel::Signed(value), _) => self.fit(value.into()),
            (Sentinel::Float(value), Kind::F32) => Some((value as f32).to_bits().into()),
            (Sentinel::Float(value), _) => Some(value.to_bits()),
            (Sentinel::NotANumber, Kind::F32) => Some(f32::NAN.to_bits().into()),
            (Sentinel::NotANumber, _) => Some(f64::NAN.to_bits()),
        }
    }

    /// The bits of a number, if it fits.
    pub(super) fn fit(self, number: i128) -> Option<u64> {
        let bits = 8 * self.kind.size() as u32;
        let (low, high) = if is_signed(self.kind) { (-1 << (bits - 1), 1 << (bits - 1)) } else { (0, 1 << bits) };
        if (low..high).contains(&number) { Some(number as u64 & (u64::MAX >> (64 - bits))) } else { None }
    }
}

pub(super) fn is_signed(kind: Kind) -> bool {
    matches!(kind, Kind::I8 | Kind::I16 | Kind::I32 | Kind::I64)
}

impl Value {
    /// The number, of which signed types have negative ones.
    pub(super) fn signed(self) -> i64 {
        match self.shape.kind {
            Kind::I8 => i64::from(self.bits as i8),
            Kind::I16 => i64::from(self.bits as i16),
            Kind::I32 => i64::from(self.bits as i32),
            _ => self.bits as i64,
        }
    }

    pub(super) fn serialize_number<S: Serializer>(self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.shape.kind {
            Kind::Char | Kind::U8 | Kind::Version => serializer.serialize_u8(self.bits as u8),
            Kind::U16 => serializer.serialize_u16(self.bits as u16),
            Kind::U32 => serializer.serialize_u32(self.bits as u32),
            Kind::U64 => serializer.serialize_u64(self.bits),
            Kind::I8 => serializer.serialize_i8(self.bits as i8),
            Kind::I16 => serializer.serialize_i16(self.bits as i16),
            Kind::I32 => serializer.serialize_i32(self.bits as i32),
            Kind::I64 => serializer.serialize_i64(self.bits as i64),
            Kind::F32 => super::float::serialize_f32(f32::from_bits(self.bits as u32), serializer),
            Kind::F64 => super::float::serialize_f64(f64::from_bits(self.bits), serializer),
        }
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.shape.values {
            Some(info) if serializer.is_human_readable() => named::serialize(*self, info, serializer),
            _ => self.serialize_number(serializer),
        }
    }
}

impl<'de> DeserializeSeed<'de> for Shape {
    type Value = u64;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<u64, D::Error> {
        let visitor = NumberVisitor(self);
        match (self.kind, self.values) {
            (Kind::F32 | Kind::F64, _) if deserializer.is_human_readable() => {
                deserializer.deserialize_any(FloatVisitor(self))
            }
            (_, Some(info)) if deserializer.is_human_readable() => {
                deserializer.deserialize_any(NamedVisitor { shape: self, info })
            }
            _ if self.invalid.is_some() && deserializer.is_human_readable() => deserializer.deserialize_any(visitor),
            (Kind::Char, _) if deserializer.is_human_readable() => deserializer.deserialize_any(visitor),
            (Kind::Char | Kind::U8 | Kind::Version, _) => deserializer.deserialize_u8(visitor),
            (Kind::U16, _) => deserializer.deserialize_u16(visitor),
            (Kind::U32, _) => deserializer.deserialize_u32(visitor),
            (Kind::U64, _) => deserializer.deserialize_u64(visitor),
            (Kind::I8, _) => deserializer.deserialize_i8(visitor),
            (Kind::I16, _) => deserializer.deserialize_i16(visitor),
            (Kind::I32, _) => deserializer.deserialize_i32(visitor),
            (Kind::I64, _) => deserializer.deserialize_i64(visitor),
            (Kind::F32, _) => deserializer.deserialize_f32(FloatVisitor(self)),
            (Kind::F64, _) => deserializer.deserialize_f64(FloatVisitor(self)),
        }
    }
}

/// Takes integers that fit, `null` for what is not known, and a character for the byte of a `char`.
struct NumberVisitor(Shape);

impl Visitor<'_> for NumberVisitor {
    type Value = u64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a number of type {}", self.0.kind.wire_name())
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<u64, E> {
        self.0.fit(number.into()).ok_or_else(|| E::invalid_value(Unexpected::Unsigned(number), &self))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<u64, E> {
        self.0.fit(number.into()).ok_or_else(|| E::invalid_value(Unexpected::Signed(number), &self))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<u64, E> {
        match byte_of(text).filter(|_| self.0.kind == Kind::Char) {
            Some(byte) => Ok(byte.into()),
            None => Err(E::invalid_type(Unexpected::Str(text), &self)),
        }
    }

    fn visit_unit<E: Error>(self) -> Result<u64, E> {
        self.0.unknown().ok_or_else(|| E::invalid_type(Unexpected::Unit, &self))
    }
}

/// The byte that rust-mavlink up to 0.14 wrote as this text of one character.
pub(super) fn byte_of(text: &str) -> Option<u8> {
    let mut characters = text.chars();
    let (only, None) = (characters.next()?, characters.next()) else { return None };
    u8::try_from(u32::from(only)).ok()
}

fn shape_of<E: Enum>() -> Shape {
    Shape { kind: E::Repr::KIND, values: Some(E::INFO), invalid: None }
}

/// What the macros make of an enum or a flags type.
///
/// # Errors
///
/// Those of the serializer.
pub fn serialize_enum<E: Enum, S: Serializer>(value: &E, serializer: S) -> Result<S::Ok, S::Error> {
    Value { shape: shape_of::<E>(), bits: value.repr().bits() }.serialize(serializer)
}

/// What the macros make of an enum or a flags type.
///
/// # Errors
///
/// Not a name of the enum, and not a number in its range.
pub fn deserialize_enum<'de, E: Enum, D: Deserializer<'de>>(deserializer: D) -> Result<E, D::Error> {
    Ok(E::from_repr(E::Repr::from_bits(shape_of::<E>().deserialize(deserializer)?)))
}
