//! Single values: a number, or the name of an enum's entry.

use core::fmt;

use serde_core::de::{DeserializeSeed, Deserializer, Error, Unexpected, Visitor};
use serde_core::ser::{Serialize, Serializer};

use super::float::FloatVisitor;
use super::named::{self, NamedVisitor};
use crate::message::wire::{get, put};
use crate::{Enum, EnumInfo, Kind, Repr};

/// What a value is: its type, and the enum that names it.
#[derive(Clone, Copy)]
pub(super) struct Shape {
    pub(super) kind: Kind,
    pub(super) values: Option<&'static EnumInfo>,
}

/// A value: its bits as in the payload, zeros above.
#[derive(Clone, Copy)]
pub(super) struct Value {
    pub(super) shape: Shape,
    pub(super) bits: u64,
}

impl Shape {
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
                deserializer.deserialize_any(FloatVisitor(self.kind))
            }
            (_, Some(info)) if deserializer.is_human_readable() => {
                deserializer.deserialize_any(NamedVisitor { shape: self, info })
            }
            (Kind::Char | Kind::U8 | Kind::Version, _) => deserializer.deserialize_u8(visitor),
            (Kind::U16, _) => deserializer.deserialize_u16(visitor),
            (Kind::U32, _) => deserializer.deserialize_u32(visitor),
            (Kind::U64, _) => deserializer.deserialize_u64(visitor),
            (Kind::I8, _) => deserializer.deserialize_i8(visitor),
            (Kind::I16, _) => deserializer.deserialize_i16(visitor),
            (Kind::I32, _) => deserializer.deserialize_i32(visitor),
            (Kind::I64, _) => deserializer.deserialize_i64(visitor),
            (Kind::F32, _) => deserializer.deserialize_f32(FloatVisitor(self.kind)),
            (Kind::F64, _) => deserializer.deserialize_f64(FloatVisitor(self.kind)),
        }
    }
}

/// Takes integers that fit.
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
}

fn shape_of<E: Enum>() -> Shape {
    Shape { kind: E::Repr::KIND, values: Some(E::INFO) }
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
