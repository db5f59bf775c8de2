//! The scalar types of `.msg` files.

use std::ops::RangeInclusive;

use crate::ir::Repr;

/// A scalar type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Scalar {
    /// `int8`
    I8,
    /// `uint8`
    U8,
    /// `int16`
    I16,
    /// `uint16`
    U16,
    /// `int32`
    I32,
    /// `uint32`
    U32,
    /// `int64`
    I64,
    /// `uint64`
    U64,
    /// `float32`
    F32,
    /// `float64`
    F64,
    /// `char`: a byte of text.
    Char,
    /// `bool`: a byte, 0 or 1.
    Bool,
}

impl Scalar {
    /// Every scalar type.
    pub const ALL: [Self; 12] = [
        Self::I8,
        Self::U8,
        Self::I16,
        Self::U16,
        Self::I32,
        Self::U32,
        Self::I64,
        Self::U64,
        Self::F32,
        Self::F64,
        Self::Char,
        Self::Bool,
    ];

    /// The type of this name, `uint8`.
    pub fn of(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|scalar| scalar.name() == name)
    }

    /// Its name in `.msg` files.
    pub fn name(self) -> &'static str {
        match self {
            Self::I8 => "int8",
            Self::U8 => "uint8",
            Self::I16 => "int16",
            Self::U16 => "uint16",
            Self::I32 => "int32",
            Self::U32 => "uint32",
            Self::I64 => "int64",
            Self::U64 => "uint64",
            Self::F32 => "float32",
            Self::F64 => "float64",
            Self::Char => "char",
            Self::Bool => "bool",
        }
    }

    /// Its name in the format definitions of a log.
    pub fn log_name(self) -> &'static str {
        match self {
            Self::I8 => "int8_t",
            Self::U8 => "uint8_t",
            Self::I16 => "int16_t",
            Self::U16 => "uint16_t",
            Self::I32 => "int32_t",
            Self::U32 => "uint32_t",
            Self::I64 => "int64_t",
            Self::U64 => "uint64_t",
            Self::F32 => "float",
            Self::F64 => "double",
            Self::Char => "char",
            Self::Bool => "bool",
        }
    }

    /// Bytes.
    pub fn size(self) -> u32 {
        match self {
            Self::I8 | Self::U8 | Self::Char | Self::Bool => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// The integer as enums name it, if it is one.
    pub fn repr(self) -> Option<Repr> {
        Some(match self {
            Self::I8 => Repr::I8,
            Self::U8 => Repr::U8,
            Self::I16 => Repr::I16,
            Self::U16 => Repr::U16,
            Self::I32 => Repr::I32,
            Self::U32 => Repr::U32,
            Self::I64 => Repr::I64,
            Self::U64 => Repr::U64,
            Self::F32 | Self::F64 | Self::Char | Self::Bool => return None,
        })
    }

    /// The values of an integer type.
    pub fn range(self) -> Option<RangeInclusive<i128>> {
        Some(match self {
            Self::I8 => i8::MIN.into()..=i8::MAX.into(),
            Self::U8 => 0..=u8::MAX.into(),
            Self::I16 => i16::MIN.into()..=i16::MAX.into(),
            Self::U16 => 0..=u16::MAX.into(),
            Self::I32 => i32::MIN.into()..=i32::MAX.into(),
            Self::U32 => 0..=u32::MAX.into(),
            Self::I64 => i64::MIN.into()..=i64::MAX.into(),
            Self::U64 => 0..=u64::MAX.into(),
            Self::F32 | Self::F64 | Self::Char | Self::Bool => return None,
        })
    }
}
