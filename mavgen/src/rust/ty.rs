//! Types, and numbers of them.

use crate::ir::{EnumId, Repr, Scalar};

/// An integer type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Int {
    /// A power of two from 8 to 128.
    bits: u8,
    signed: bool,
}

impl Int {
    /// The smallest that holds so many bits.
    pub(crate) fn of_bits(bits: u8, signed: bool) -> Self {
        Self { bits: bits.clamp(8, 128).next_power_of_two(), signed }
    }

    pub(crate) fn bits(self) -> u8 {
        self.bits
    }

    pub(crate) fn is_signed(self) -> bool {
        self.signed
    }

    /// The unsigned integer of the same width.
    pub(crate) fn unsigned(self) -> Self {
        Self { signed: false, ..self }
    }

    /// Whether every number of it is one of the other.
    pub(crate) fn is_within(self, other: Self) -> bool {
        if self.signed == other.signed { self.bits <= other.bits } else { other.signed && self.bits < other.bits }
    }

    /// `u16`
    pub(crate) fn name(self) -> &'static str {
        match (self.bits, self.signed) {
            (8, false) => "u8",
            (8, true) => "i8",
            (16, false) => "u16",
            (16, true) => "i16",
            (32, false) => "u32",
            (32, true) => "i32",
            (64, false) => "u64",
            (64, true) => "i64",
            (_, false) => "u128",
            (_, true) => "i128",
        }
    }
}

impl From<Repr> for Int {
    fn from(repr: Repr) -> Self {
        Self::of_bits(8 * repr.size() as u8, repr.is_signed())
    }
}

/// A type, as signatures and fields name it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Ty<'d> {
    Int(Int),
    F32,
    F64,
    Bool,
    Usize,
    /// `()`
    Unit,
    /// `Self`
    Own,
    Enum(EnumType<'d>),
    /// A view or a slot, in whose file it is named.
    Named(&'d str),
    /// `[T; 4]`
    Array(Box<Self>, u16),
    Option(Box<Self>),
    /// `Result<(), E>`
    Fallible(Error),
    /// `&'static [wire::ParamInfo]`
    Params,
    /// `Result<Self, E>`
    Made(Error),
    /// `impl Iterator<Item = T> + '_`
    Iterator(Box<Self>),
}

impl Ty<'_> {
    /// Whether it is `Eq`: no float.
    pub(crate) fn is_eq(&self) -> bool {
        match self {
            Self::F32 | Self::F64 => false,
            Self::Array(inner, _) | Self::Option(inner) => inner.is_eq(),
            _ => true,
        }
    }

    /// `Option<T>` where there may be none, else `T`.
    pub(crate) fn optional(self, optional: bool) -> Self {
        if optional { Self::Option(Box::new(self)) } else { self }
    }
}

/// What a setter that may fail gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Error {
    /// `wire::ViewError`
    View,
    /// `wire::OutOfRange`
    OutOfRange,
}

/// An enum or a set of flags, as others name it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct EnumType<'d> {
    /// Which of the dialect's it is.
    pub(crate) id: EnumId,
    pub(crate) ident: &'d str,
    pub(crate) int: Int,
    pub(crate) flags: bool,
    /// Whether naming it makes the compiler warn.
    pub(crate) deprecated: bool,
}

/// The type of one element of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Element<'d> {
    /// An integer, or a character.
    Int(Int),
    F32,
    F64,
    /// An enum of the field's own width and sign.
    Enum(EnumType<'d>),
}

impl<'d> Element<'d> {
    /// The element of a scalar that carries no enum.
    pub(crate) fn plain(scalar: Scalar) -> Self {
        match scalar {
            Scalar::F32 => Self::F32,
            Scalar::F64 => Self::F64,
            // Characters and the version are bytes.
            _ => Self::Int(scalar.repr().map_or(Int::of_bits(8, false), Int::from)),
        }
    }

    pub(crate) fn ty(self) -> Ty<'d> {
        match self {
            Self::Int(int) => Ty::Int(int),
            Self::F32 => Ty::F32,
            Self::F64 => Ty::F64,
            Self::Enum(one) => Ty::Enum(one),
        }
    }

    /// The integer that a value becomes, and is made of: with this, no emitter has to remember what carries an enum.
    pub(crate) fn int(self) -> Int {
        match self {
            Self::Int(int) => int,
            Self::F32 => Int::of_bits(32, false),
            Self::F64 => Int::of_bits(64, false),
            Self::Enum(one) => one.int,
        }
    }

    /// The enum that it is.
    pub(crate) fn enum_(self) -> Option<EnumType<'d>> {
        match self {
            Self::Enum(one) => Some(one),
            Self::Int(_) | Self::F32 | Self::F64 => None,
        }
    }
}

/// How many elements a field has, and in what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// `T`
    One,
    /// `[T; 4]`
    Array(u8),
    /// `wire::Chars<4>`
    Chars(u8),
}

/// A number in the type of a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Literal<'d> {
    /// The constant of an enum: `MavAutopilot::AUTOQUAD`.
    Constant(EnumType<'d>, &'d str),
    /// `65535`, `PodKind(7)`
    Number(Element<'d>, i128),
    /// `1e30`
    Float(f64),
}

impl<'d> Literal<'d> {
    /// The enum that it names, if it does.
    pub(crate) fn enum_(self) -> Option<EnumType<'d>> {
        match self {
            Self::Constant(one, _) => Some(one),
            Self::Number(element, _) => element.enum_(),
            Self::Float(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_are_the_smallest_that_hold_their_bits() {
        for (bits, unsigned, signed) in [
            (1, "u8", "i8"),
            (8, "u8", "i8"),
            (9, "u16", "i16"),
            (17, "u32", "i32"),
            (33, "u64", "i64"),
            (64, "u64", "i64"),
            (65, "u128", "i128"),
        ] {
            assert_eq!([false, true].map(|sign| Int::of_bits(bits, sign).name()), [unsigned, signed]);
            assert_eq!(Int::of_bits(bits, true).unsigned().name(), unsigned);
        }
    }

    #[test]
    fn an_integer_is_within_one_that_has_all_its_numbers() {
        let int = |bits, signed| Int::of_bits(bits, signed);
        for (one, other, within) in [
            (int(8, false), int(8, false), true),
            (int(16, false), int(8, false), false),
            (int(8, false), int(8, true), false),
            (int(8, false), int(16, true), true),
            (int(8, true), int(64, false), false),
            (int(8, true), int(16, true), true),
        ] {
            assert_eq!(one.is_within(other), within, "{} in {}", one.name(), other.name());
        }
    }
}
