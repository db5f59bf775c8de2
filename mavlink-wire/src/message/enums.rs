//! Enums of a dialect: open newtypes, because a receiver must survive values that a newer definition added.
//!
//! [`open_enum!`](crate::open_enum!) adds to each only what needs its type; the text work is done here once, for all.

use core::fmt;

use super::wire::Wire;
use crate::{EnumInfo, Kind, UnknownName};

/// An enum or a flags type of a dialect, for code that works on any of them.
pub trait Enum: Copy + Eq + From<<Self as Enum>::Repr> + Into<<Self as Enum>::Repr> + 'static {
    /// Its name and entries.
    const INFO: &'static EnumInfo;

    /// The integer on the wire.
    type Repr: Repr;

    /// The value with this number, whether an entry names it or not.
    #[inline]
    fn from_repr(repr: Self::Repr) -> Self {
        repr.into()
    }

    /// The number.
    #[inline]
    fn repr(self) -> Self::Repr {
        self.into()
    }
}

/// An integer that can carry an enum: `u8` to `u64`, `i8` to `i64`.
pub trait Repr: Wire + Eq + fmt::Debug + fmt::Display + TryFrom<i128> {
    /// The type in the XML.
    const KIND: Kind;

    /// Whether it has negative numbers.
    const IS_SIGNED: bool;

    /// The same bits, zeros above.
    fn bits(self) -> u64;

    /// The low bits.
    fn from_bits(bits: u64) -> Self;

    /// The number.
    fn number(self) -> i128;
}

macro_rules! repr {
    ($($type:ident as $unsigned:ident $kind:ident)*) => {$(
        impl Repr for $type {
            const KIND: Kind = Kind::$kind;
            const IS_SIGNED: bool = Self::MIN != 0;

            #[inline]
            fn bits(self) -> u64 {
                self as $unsigned as u64
            }

            #[inline]
            fn from_bits(bits: u64) -> Self {
                bits as Self
            }

            #[inline]
            fn number(self) -> i128 {
                self.into()
            }
        }
    )*};
}

repr!(u8 as u8 U8 u16 as u16 U16 u32 as u32 U32 u64 as u64 U64);
repr!(i8 as u8 I8 i16 as u16 I16 i32 as u32 I32 i64 as u64 I64);

/// Writes the entry's name, or the number if there is none.
///
/// # Errors
///
/// Those of the formatter.
#[doc(hidden)]
pub fn fmt_entry<E: Enum>(value: &E, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let number = value.repr();
    fmt_named(E::INFO, number.number() as u64, &number, f)
}

/// Writes the entry's name, or `MavState(9)` if there is none.
///
/// # Errors
///
/// Those of the formatter.
#[doc(hidden)]
pub fn debug_entry<E: Enum>(value: &E, rust_name: &str, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let number = value.repr();
    debug_named(E::INFO, number.number() as u64, (rust_name, &number), f)
}

pub(crate) fn fmt_named(
    info: &EnumInfo,
    value: u64,
    number: &dyn fmt::Display,
    f: &mut fmt::Formatter<'_>,
) -> fmt::Result {
    match info.entry_name(value) {
        Some(name) => f.pad(name),
        None => number.fmt(f),
    }
}

fn debug_named(
    info: &EnumInfo,
    value: u64,
    (rust_name, number): (&str, &dyn fmt::Debug),
    f: &mut fmt::Formatter<'_>,
) -> fmt::Result {
    match info.entry_name(value) {
        Some(name) => f.pad(name),
        None => f.debug_tuple(rust_name).field(number).finish(),
    }
}

/// Reads an entry's name, or a number that fits.
///
/// # Errors
///
/// There is no such entry.
#[doc(hidden)]
pub fn parse<E: Enum>(text: &str) -> Result<E, UnknownName> {
    match E::Repr::try_from(parse_entry(E::INFO, text, E::Repr::IS_SIGNED)?) {
        Ok(repr) => Ok(E::from_repr(repr)),
        Err(_) => Err(UnknownName::of(E::INFO)),
    }
}

/// Reads an entry's name or a number; whether the number fits is the caller's to check. Entries of a signed integer can be
/// negative: their sign is extended.
pub(crate) fn parse_entry(info: &'static EnumInfo, text: &str, signed: bool) -> Result<i128, UnknownName> {
    let (digits, negative) = match text.strip_prefix('-') {
        Some(digits) => (digits, true),
        None => (text, false),
    };
    match number(digits) {
        Some(number) if negative => Ok(-i128::from(number)),
        Some(number) => Ok(i128::from(number)),
        None => {
            let value = |bits: u64| if signed { bits.cast_signed().into() } else { bits.into() };
            info.entry_value(text).map(value).ok_or(UnknownName::of(info))
        }
    }
}

/// A decimal number, or a hexadecimal one after `0x`; no sign.
pub(crate) fn number(text: &str) -> Option<u64> {
    let (digits, radix) = match text.strip_prefix("0x").or(text.strip_prefix("0X")) {
        Some(digits) => (digits, 16),
        None => (text, 10),
    };
    if digits.starts_with('+') { None } else { u64::from_str_radix(digits, radix).ok() }
}

/// Completes `pub struct MavState(pub u8)` to an open enum: text both ways, conversions, the wire.
///
/// `open_enum!(MavState, u8, INFO)` takes the type, its integer and a [`EnumInfo`](crate::EnumInfo) static. The type
/// and its constants are written out beside it, with `Clone, Copy, PartialEq` derived, so that the constants can be patterns.
///
/// ```
/// use mavlink_wire as wire;
///
/// #[derive(Clone, Copy, PartialEq)]
/// pub struct MavState(pub u8);
///
/// impl MavState {
///     pub const UNINIT: Self = Self(0);
///     pub const ACTIVE: Self = Self(4);
/// }
///
/// static INFO: wire::EnumInfo = wire::EnumInfo::new("MAV_STATE", &[(0, "MAV_STATE_UNINIT"), (4, "MAV_STATE_ACTIVE")]);
/// wire::open_enum!(MavState, u8, INFO);
///
/// assert_eq!(MavState(4).name(), Some("MAV_STATE_ACTIVE"));
/// assert_eq!("MAV_STATE_ACTIVE".parse(), Ok(MavState::ACTIVE));
/// assert_eq!("0x9".parse(), Ok(MavState(9)));
/// assert_eq!(format!("{:?} {} {:?}", MavState(4), MavState(9), MavState(9)), "MAV_STATE_ACTIVE 9 MavState(9)");
/// ```
#[macro_export]
macro_rules! open_enum {
    ($name:ident, $repr:ident, $info:path) => {
        impl $name {
            /// The name in the XML, if an entry has this value.
            #[inline]
            pub fn name(self) -> ::core::option::Option<&'static str> {
                $crate::EnumInfo::entry_name(&$info, self.0 as u64)
            }

            /// Whether an entry has this value.
            #[inline]
            pub fn is_known(self) -> bool {
                self.name().is_some()
            }
        }

        impl $crate::Enum for $name {
            const INFO: &'static $crate::EnumInfo = &$info;
            type Repr = $repr;
        }

        impl ::core::fmt::Debug for $name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::generated::debug_entry(self, ::core::stringify!($name), f)
            }
        }

        impl ::core::fmt::Display for $name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::generated::fmt_entry(self, f)
            }
        }

        impl ::core::str::FromStr for $name {
            type Err = $crate::UnknownName;

            #[inline]
            fn from_str(text: &str) -> ::core::result::Result<Self, $crate::UnknownName> {
                $crate::generated::parse(text)
            }
        }

        $crate::__number!($name, $repr);
        $crate::__serde!($name, serialize_enum, deserialize_enum);
        $crate::__defmt!($name, value);
        $crate::__arbitrary!($name, value, value_size);
    };
}

/// What enums and flags have as numbers: conversions, an order, a hash, and zero by default.
#[doc(hidden)]
#[macro_export]
macro_rules! __number {
    ($name:ident, $repr:ident) => {
        impl ::core::convert::From<$repr> for $name {
            #[inline]
            fn from(number: $repr) -> Self {
                Self(number)
            }
        }

        impl ::core::convert::From<$name> for $repr {
            #[inline]
            fn from(value: $name) -> Self {
                value.0
            }
        }

        impl ::core::default::Default for $name {
            #[inline]
            fn default() -> Self {
                Self(0)
            }
        }

        // Derived, it would be a function that is compiled.
        impl ::core::cmp::Eq for $name {}

        impl ::core::cmp::PartialOrd for $name {
            #[inline]
            fn partial_cmp(&self, other: &Self) -> ::core::option::Option<::core::cmp::Ordering> {
                ::core::option::Option::Some(::core::cmp::Ord::cmp(self, other))
            }
        }

        impl ::core::cmp::Ord for $name {
            #[inline]
            fn cmp(&self, other: &Self) -> ::core::cmp::Ordering {
                ::core::cmp::Ord::cmp(&self.0, &other.0)
            }
        }

        impl ::core::hash::Hash for $name {
            #[inline]
            fn hash<H: ::core::hash::Hasher>(&self, state: &mut H) {
                ::core::hash::Hash::hash(&self.0, state)
            }
        }
    };
}
