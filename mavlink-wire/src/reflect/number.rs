//! Numbers of any type of the wire.

use core::fmt;

use crate::message::float::Exact;
use crate::message::wire::get;
use crate::{Kind, Sentinel};

/// A number of a payload, widened without loss: floats keep every bit, also of NaNs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Number {
    /// Of an unsigned field, or the byte of a `char`.
    U64(u64),
    /// Of a signed field.
    I64(i64),
    /// Of a `float`.
    F32(f32),
    /// Of a `double`.
    F64(f64),
}

impl Number {
    /// The number of this kind at an offset; bytes beyond the end read as zero.
    #[must_use]
    pub fn read(kind: Kind, payload: &[u8], offset: usize) -> Self {
        match kind {
            Kind::Char | Kind::U8 | Kind::Version => Self::U64(get::<u8>(payload, offset).into()),
            Kind::U16 => Self::U64(get::<u16>(payload, offset).into()),
            Kind::U32 => Self::U64(get::<u32>(payload, offset).into()),
            Kind::U64 => Self::U64(get(payload, offset)),
            Kind::I8 => Self::I64(get::<i8>(payload, offset).into()),
            Kind::I16 => Self::I64(get::<i16>(payload, offset).into()),
            Kind::I32 => Self::I64(get::<i32>(payload, offset).into()),
            Kind::I64 => Self::I64(get(payload, offset)),
            Kind::F32 => Self::F32(get(payload, offset)),
            Kind::F64 => Self::F64(get(payload, offset)),
        }
    }

    /// The integer; `None` for floats.
    #[must_use]
    pub fn as_integer(self) -> Option<i128> {
        match self {
            Self::U64(value) => Some(value.into()),
            Self::I64(value) => Some(value.into()),
            Self::F32(_) | Self::F64(_) => None,
        }
    }

    /// The nearest double: exact but for integers beyond 2^53.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        match self {
            Self::U64(value) => value as f64,
            Self::I64(value) => value as f64,
            Self::F32(value) => value.into(),
            Self::F64(value) => value,
        }
    }

    /// Whether it is this sentinel, compared in the number's own type.
    pub(super) fn is(self, sentinel: Sentinel) -> bool {
        match (self, sentinel) {
            (Self::U64(value), Sentinel::Unsigned(unknown)) => value == unknown,
            (Self::I64(value), Sentinel::Signed(unknown)) => value == unknown,
            (Self::F32(value), Sentinel::Float(unknown)) => value == unknown as f32,
            (Self::F64(value), Sentinel::Float(unknown)) => value == unknown,
            (Self::F32(value), Sentinel::NotANumber) => value.is_nan(),
            (Self::F64(value), Sentinel::NotANumber) => value.is_nan(),
            _ => false,
        }
    }
}

/// Integers in decimal; floats with a point or an exponent, as many digits as it takes to read the same float again. A NaN other
/// than the usual one keeps its bits: `NaN(0x7fc00001)`.
impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::U64(value) => write!(f, "{value}"),
            Self::I64(value) => write!(f, "{value}"),
            Self::F32(value) => Exact(*value).fmt(f),
            Self::F64(value) => Exact(*value).fmt(f),
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::string::ToString;

    use super::Number;

    #[test]
    fn no_bit_of_a_float_is_lost_in_text() {
        for (bits, text) in [
            (0x7fc0_0000, "NaN"),
            (0xffff_ffff, "NaN(0xffffffff)"),
            (0x7f80_0001, "NaN(0x7f800001)"),
            (0x7f80_0000, "inf"),
            (7, "1e-44"),
            (0x8000_0000, "-0.0"),
        ] {
            assert_eq!(Number::F32(f32::from_bits(bits)).to_string(), text);
        }
        assert_eq!(Number::F64(f64::NAN).to_string(), "NaN");
        assert_eq!(Number::F64(f64::from_bits(u64::MAX)).to_string(), "NaN(0xffffffffffffffff)");
    }
}
