//! Floats: numbers where there is one, text for NaN and the infinities.

use core::fmt;

use serde_core::de::{Error, Unexpected, Visitor};
use serde_core::ser::Serializer;

use super::value::Shape;
use crate::Kind;
use crate::message::float::Exact;

pub(super) fn serialize_f32<S: Serializer>(value: f32, serializer: S) -> Result<S::Ok, S::Error> {
    if !serializer.is_human_readable() {
        return serializer.serialize_f32(value);
    }
    if value.is_finite() {
        return if needs_double(value) {
            serializer.serialize_f64(value.into())
        } else {
            serializer.serialize_f32(value)
        };
    }
    if value.is_nan() { serializer.collect_str(&Exact(value)) } else { serializer.serialize_str(infinity(value > 0.0)) }
}

pub(super) fn serialize_f64<S: Serializer>(value: f64, serializer: S) -> Result<S::Ok, S::Error> {
    if value.is_finite() || !serializer.is_human_readable() {
        return serializer.serialize_f64(value);
    }
    if value.is_nan() { serializer.collect_str(&Exact(value)) } else { serializer.serialize_str(infinity(value > 0.0)) }
}

fn infinity(positive: bool) -> &'static str {
    if positive { "Infinity" } else { "-Infinity" }
}

/// Whether the shortest decimal of a `float`, read as a `double` as JSON readers do, rounds to another `float`, because it
/// lies next to the middle of two. Trying all `float`s found this one, 7.038531e-26.
fn needs_double(value: f32) -> bool {
    value.abs().to_bits() == 0x15ae_43fd
}

/// Takes numbers, the names of what is no number, and `null` for what is not known or else for NaN; gives bits.
pub(super) struct FloatVisitor(pub(super) Shape);

impl FloatVisitor {
    /// What is not known; NaN where no other value says so.
    fn unknown(&self) -> u64 {
        self.0.unknown().unwrap_or_else(|| self.nan())
    }

    fn nan(&self) -> u64 {
        match self.0.kind {
            Kind::F32 => f32::NAN.to_bits().into(),
            _ => f64::NAN.to_bits(),
        }
    }

    /// `NaN(0x7fc00001)`, or whatever Rust reads as a float.
    fn parse(&self, text: &str) -> Option<u64> {
        if let Some(digits) = text.strip_prefix("NaN(0x").and_then(|rest| rest.strip_suffix(')')) {
            return match self.0.kind {
                Kind::F32 => {
                    let bits = u32::from_str_radix(digits, 16).ok()?;
                    if f32::from_bits(bits).is_nan() { Some(bits.into()) } else { None }
                }
                _ => u64::from_str_radix(digits, 16).ok().filter(|bits| f64::from_bits(*bits).is_nan()),
            };
        }
        match self.0.kind {
            Kind::F32 => text.parse().ok().map(|value: f32| value.to_bits().into()),
            _ => text.parse().ok().map(f64::to_bits),
        }
    }
}

impl Visitor<'_> for FloatVisitor {
    type Value = u64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a number of type {}, \"NaN\", \"Infinity\" or \"-Infinity\"", self.0.kind.wire_name())
    }

    fn visit_f32<E: Error>(self, value: f32) -> Result<u64, E> {
        match self.0.kind {
            Kind::F32 => Ok(value.to_bits().into()),
            _ => Ok(f64::from(value).to_bits()),
        }
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<u64, E> {
        match self.0.kind {
            Kind::F32 if value.is_finite() && (value as f32).is_infinite() => {
                Err(E::invalid_value(Unexpected::Float(value), &self))
            }
            Kind::F32 => Ok((value as f32).to_bits().into()),
            _ => Ok(value.to_bits()),
        }
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<u64, E> {
        self.visit_f64(value as f64)
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<u64, E> {
        self.visit_f64(value as f64)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<u64, E> {
        self.parse(text).ok_or_else(|| E::invalid_value(Unexpected::Str(text), &self))
    }

    fn visit_unit<E: Error>(self) -> Result<u64, E> {
        Ok(self.unknown())
    }
}
