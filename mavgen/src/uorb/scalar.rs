//! The scalar types of `.msg` files.

use std::ops::RangeInclusive;

use crate::ir::{self, Repr};

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
    #[rustfmt::skip]
    pub const ALL: [Self; 12] = [
        Self::I8, Self::U8, Self::I16, Self::U16, Self::I32, Self::U32, Self::I64, Self::U64,
        Self::F32, Self::F64, Self::Char, Self::Bool,
    ];

    /// Its name in `.msg` files, the same type in MAVLink, which has no bool, and its number in ROS 2: a constant of
    /// `type_description_interfaces/msg/FieldType`.
    fn facts(self) -> (&'static str, Option<ir::Scalar>, u8) {
        match self {
            Self::I8 => ("int8", Some(ir::Scalar::I8), 2),
            Self::U8 => ("uint8", Some(ir::Scalar::U8), 3),
            Self::I16 => ("int16", Some(ir::Scalar::I16), 4),
            Self::U16 => ("uint16", Some(ir::Scalar::U16), 5),
            Self::I32 => ("int32", Some(ir::Scalar::I32), 6),
            Self::U32 => ("uint32", Some(ir::Scalar::U32), 7),
            Self::I64 => ("int64", Some(ir::Scalar::I64), 8),
            Self::U64 => ("uint64", Some(ir::Scalar::U64), 9),
            Self::F32 => ("float32", Some(ir::Scalar::F32), 10),
            Self::F64 => ("float64", Some(ir::Scalar::F64), 11),
            Self::Char => ("char", Some(ir::Scalar::Char), 13),
            Self::Bool => ("bool", None, 15),
        }
    }

    /// The type of this name, `uint8`.
    pub fn of(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|scalar| scalar.name() == name)
    }

    /// Its name in `.msg` files.
    pub fn name(self) -> &'static str {
        self.facts().0
    }

    /// The same type in MAVLink, which has no bool.
    pub(super) fn of_mavlink(self) -> Option<ir::Scalar> {
        self.facts().1
    }

    /// Its number in ROS 2.
    pub(super) fn type_id(self) -> u8 {
        self.facts().2
    }

    /// Its name in the format definitions of a log.
    pub fn log_name(self) -> &'static str {
        self.of_mavlink().map_or("bool", ir::Scalar::wire_name)
    }

    /// Bytes.
    pub fn size(self) -> u32 {
        self.of_mavlink().map_or(1, |scalar| scalar.size() as u32)
    }

    /// The integer as enums name it, if it is one.
    pub fn repr(self) -> Option<Repr> {
        self.of_mavlink()?.repr()
    }

    /// The values of an integer type.
    pub fn range(self) -> Option<RangeInclusive<i128>> {
        self.of_mavlink().filter(|scalar| scalar.repr().is_some())?.range()
    }
}
