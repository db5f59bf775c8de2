//! Values of parameters: numbers of ten types.

use core::error::Error;
use core::fmt;

use super::number::Number;
use crate::common::MavParamType;

/// A number with one of the types that MAVLink has for parameters (`MAV_PARAM_TYPE`).
///
/// ```
/// use mavlink_services::common::MavParamType;
/// use mavlink_services::param::{ParamValue, ValueError};
///
/// let value = ParamValue::from(5_u8);
/// assert_eq!((value.kind(), i32::try_from(value)), (MavParamType::UINT8, Ok(5)));
/// assert_eq!(ParamValue::from(0.2).to_kind(MavParamType::REAL32), Ok(ParamValue::F32(0.2)));
/// assert_eq!(u8::try_from(ParamValue::from(1.5)), Err(ValueError::NotAnInteger));
/// ```
#[derive(Clone, Copy, PartialEq)]
pub enum ParamValue {
    /// `MAV_PARAM_TYPE_UINT8`.
    U8(u8),
    /// `MAV_PARAM_TYPE_INT8`.
    I8(i8),
    /// `MAV_PARAM_TYPE_UINT16`.
    U16(u16),
    /// `MAV_PARAM_TYPE_INT16`.
    I16(i16),
    /// `MAV_PARAM_TYPE_UINT32`.
    U32(u32),
    /// `MAV_PARAM_TYPE_INT32`.
    I32(i32),
    /// `MAV_PARAM_TYPE_UINT64`. Its eight bytes do not fit a message bytewise.
    U64(u64),
    /// `MAV_PARAM_TYPE_INT64`. Like [`U64`](Self::U64).
    I64(i64),
    /// `MAV_PARAM_TYPE_REAL32`: what most parameters are.
    F32(f32),
    /// `MAV_PARAM_TYPE_REAL64`. Like [`U64`](Self::U64).
    F64(f64),
}

impl ParamValue {
    /// Its type.
    #[must_use]
    pub const fn kind(self) -> MavParamType {
        match self {
            Self::U8(_) => MavParamType::UINT8,
            Self::I8(_) => MavParamType::INT8,
            Self::U16(_) => MavParamType::UINT16,
            Self::I16(_) => MavParamType::INT16,
            Self::U32(_) => MavParamType::UINT32,
            Self::I32(_) => MavParamType::INT32,
            Self::U64(_) => MavParamType::UINT64,
            Self::I64(_) => MavParamType::INT64,
            Self::F32(_) => MavParamType::REAL32,
            Self::F64(_) => MavParamType::REAL64,
        }
    }

    /// The same number with another type. Reals are rounded to the nearest `f32`; an integer stays what it is, to the last digit.
    ///
    /// # Errors
    ///
    /// The type cannot hold this number, or MAVLink has no such type.
    pub fn to_kind(self, kind: MavParamType) -> Result<Self, ValueError> {
        if kind == self.kind() {
            return Ok(self);
        }
        let number = Number::from(self);
        Ok(match kind {
            MavParamType::UINT8 => Self::U8(number.integer()?),
            MavParamType::INT8 => Self::I8(number.integer()?),
            MavParamType::UINT16 => Self::U16(number.integer()?),
            MavParamType::INT16 => Self::I16(number.integer()?),
            MavParamType::UINT32 => Self::U32(number.integer()?),
            MavParamType::INT32 => Self::I32(number.integer()?),
            MavParamType::UINT64 => Self::U64(number.integer()?),
            MavParamType::INT64 => Self::I64(number.integer()?),
            MavParamType::REAL32 => Self::F32(number.f32()?),
            MavParamType::REAL64 => Self::F64(number.f64()?),
            _ => return Err(ValueError::UnknownType(kind)),
        })
    }
}

/// Converts a Rust number to a value of its type, and a value to a Rust number, if that is the same number.
macro_rules! numbers {
    ($($type:ident $variant:ident $read:ident)*) => {$(
        impl From<$type> for ParamValue {
            fn from(value: $type) -> Self {
                Self::$variant(value)
            }
        }

        impl TryFrom<ParamValue> for $type {
            type Error = ValueError;

            fn try_from(value: ParamValue) -> Result<Self, ValueError> {
                Number::from(value).$read()
            }
        }
    )*};
}

numbers!(u8 U8 integer i8 I8 integer u16 U16 integer i16 I16 integer u32 U32 integer i32 I32 integer);
numbers!(u64 U64 integer i64 I64 integer f32 F32 f32 f64 F64 f64);

/// The number alone.
impl fmt::Display for ParamValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::U8(value) => value.fmt(f),
            Self::I8(value) => value.fmt(f),
            Self::U16(value) => value.fmt(f),
            Self::I16(value) => value.fmt(f),
            Self::U32(value) => value.fmt(f),
            Self::I32(value) => value.fmt(f),
            Self::U64(value) => value.fmt(f),
            Self::I64(value) => value.fmt(f),
            Self::F32(value) => value.fmt(f),
            Self::F64(value) => value.fmt(f),
        }
    }
}

/// As Rust writes a number with its type: `5u8`.
impl fmt::Debug for ParamValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let suffix = match self {
            Self::U8(_) => "u8",
            Self::I8(_) => "i8",
            Self::U16(_) => "u16",
            Self::I16(_) => "i16",
            Self::U32(_) => "u32",
            Self::I32(_) => "i32",
            Self::U64(_) => "u64",
            Self::I64(_) => "i64",
            Self::F32(_) => "f32",
            Self::F64(_) => "f64",
        };
        write!(f, "{self}{suffix}")
    }
}

/// A number cannot be this parameter's value, or cannot be sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ValueError {
    /// The integer has more digits than the float that would carry it: it would become another number.
    Inexact,
    /// The type cannot hold a number this small or large.
    OutOfRange,
    /// An integer is wanted, and this has a fraction or is no number.
    NotAnInteger,
    /// A message has four bytes for a value, and the type has eight.
    TooWide,
    /// MAVLink has no type of this number.
    UnknownType(MavParamType),
}

impl fmt::Display for ValueError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Inexact => f.write_str(
                "the integer has too many digits for a float, which would change it: use the bytewise encoding",
            ),
            Self::OutOfRange => f.write_str("the type of the parameter cannot hold this number"),
            Self::NotAnInteger => f.write_str("the parameter is an integer, and this number is not"),
            Self::TooWide => f.write_str("a type of 64 bits does not fit the four bytes that a message has for it"),
            Self::UnknownType(kind) => write!(f, "MAVLink has no type {} for parameters", kind.0),
        }
    }
}

impl Error for ValueError {}
