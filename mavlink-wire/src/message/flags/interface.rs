//! The interface of a flags type: the methods and operators of `bitflags` 2.

/// Completes `pub struct MavModeFlag(u8)` to a flags type with the interface of `bitflags` 2.
///
/// `flags!(MavModeFlag, u8, INFO)` takes the type, its integer and a [`EnumInfo`](crate::EnumInfo) static. The type
/// and its constants are written out beside it, with `Clone, Copy, PartialEq` derived. Bits that no entry names are kept,
/// unless a method says otherwise.
///
/// ```
/// use mavlink_wire as wire;
///
/// #[derive(Clone, Copy, PartialEq)]
/// pub struct EscFailure(u16);
///
/// impl EscFailure {
///     pub const OVER_CURRENT: Self = Self(1);
///     pub const OVER_VOLTAGE: Self = Self(2);
/// }
///
/// static INFO: wire::EnumInfo = wire::EnumInfo::bitmask(
///     "ESC_FAILURE",
///     &[(1, "ESC_FAILURE_OVER_CURRENT"), (2, "ESC_FAILURE_OVER_VOLTAGE")],
/// );
/// wire::flags!(EscFailure, u16, INFO);
///
/// let seen = EscFailure::from_bits_retain(0x42);
/// assert!(seen.contains(EscFailure::OVER_VOLTAGE) && !seen.intersects(EscFailure::OVER_CURRENT));
/// assert_eq!(seen.to_string(), "ESC_FAILURE_OVER_VOLTAGE | 0x40");
/// assert_eq!("ESC_FAILURE_OVER_VOLTAGE | 0x40".parse(), Ok(seen));
/// ```
#[macro_export]
macro_rules! flags {
    ($name:ident, $repr:ident, $info:path) => {
        impl $name {
            /// The number on the wire.
            #[inline]
            pub const fn bits(&self) -> $repr {
                self.0
            }

            /// No bit set.
            #[inline]
            pub const fn empty() -> Self {
                Self(0)
            }

            /// Every bit that an entry names.
            #[inline]
            pub const fn all() -> Self {
                const ALL: $repr = $crate::EnumInfo::all_bits(&$info) as $repr;
                Self(ALL)
            }

            /// These bits, or `None` if one of them has no entry.
            #[inline]
            pub const fn from_bits(bits: $repr) -> ::core::option::Option<Self> {
                if bits & !Self::all().0 == 0 {
                    ::core::option::Option::Some(Self(bits))
                } else {
                    ::core::option::Option::None
                }
            }

            /// These bits without those that have no entry.
            #[inline]
            pub const fn from_bits_truncate(bits: $repr) -> Self {
                Self(bits & Self::all().0)
            }

            /// These bits, all of them.
            #[inline]
            pub const fn from_bits_retain(bits: $repr) -> Self {
                Self(bits)
            }

            /// The entry with this name in the XML.
            #[inline]
            pub fn from_name(name: &str) -> ::core::option::Option<Self> {
                match $crate::EnumInfo::entry_value(&$info, name) {
                    ::core::option::Option::Some(bits) => ::core::option::Option::Some(Self(bits as $repr)),
                    ::core::option::Option::None => ::core::option::Option::None,
                }
            }

            /// Whether no bit is set.
            #[inline]
            pub const fn is_empty(&self) -> bool {
                self.0 == 0
            }

            /// Whether every bit that has an entry is set.
            #[inline]
            pub const fn is_all(&self) -> bool {
                Self::all().0 & !self.0 == 0
            }

            /// Whether every bit of `other` is set.
            #[inline]
            pub const fn contains(&self, other: Self) -> bool {
                self.0 & other.0 == other.0
            }

            /// Whether some bit of `other` is set.
            #[inline]
            pub const fn intersects(&self, other: Self) -> bool {
                self.0 & other.0 != 0
            }

            /// Sets the bits of `other`.
            #[inline]
            pub const fn insert(&mut self, other: Self) {
                self.0 |= other.0
            }

            /// Clears the bits of `other`.
            #[inline]
            pub const fn remove(&mut self, other: Self) {
                self.0 &= !other.0
            }

            /// Flips the bits of `other`.
            #[inline]
            pub const fn toggle(&mut self, other: Self) {
                self.0 ^= other.0
            }

            /// Sets or clears the bits of `other`.
            #[inline]
            pub const fn set(&mut self, other: Self, value: bool) {
                if value { self.insert(other) } else { self.remove(other) }
            }

            /// Bits that are set in both.
            #[inline]
            pub const fn intersection(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }

            /// Bits that are set in either.
            #[inline]
            pub const fn union(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }

            /// Bits that are set here and not in `other`.
            #[inline]
            pub const fn difference(self, other: Self) -> Self {
                Self(self.0 & !other.0)
            }

            /// Bits that are set in exactly one.
            #[inline]
            pub const fn symmetric_difference(self, other: Self) -> Self {
                Self(self.0 ^ other.0)
            }

            /// Bits that have an entry and are not set.
            #[inline]
            pub const fn complement(self) -> Self {
                Self(!self.0 & Self::all().0)
            }

            /// The entries that are set, and in the end the bits without an entry.
            #[inline]
            pub const fn iter(&self) -> $crate::flags::Iter<Self> {
                $crate::flags::Iter::new(&$info, self.0 as u64, $repr::BITS)
            }

            /// The entries that are set, with their names in the XML.
            #[inline]
            pub const fn iter_names(&self) -> $crate::flags::IterNames<Self> {
                $crate::flags::IterNames::new(&$info, self.0 as u64, $repr::BITS)
            }
        }

        impl $crate::Enum for $name {
            const INFO: &'static $crate::EnumInfo = &$info;
            type Repr = $repr;
        }

        impl ::core::fmt::Debug for $name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::generated::fmt_flags(self, f)
            }
        }

        impl ::core::fmt::Display for $name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::generated::fmt_flags(self, f)
            }
        }

        impl ::core::str::FromStr for $name {
            type Err = $crate::UnknownName;

            #[inline]
            fn from_str(text: &str) -> ::core::result::Result<Self, $crate::UnknownName> {
                $crate::generated::parse_flags(text)
            }
        }

        $crate::__number!($name, $repr);

        impl ::core::iter::Extend<$name> for $name {
            #[inline]
            fn extend<T: ::core::iter::IntoIterator<Item = Self>>(&mut self, flags: T) {
                *self = $crate::generated::union(*self, flags)
            }
        }

        impl ::core::iter::FromIterator<$name> for $name {
            #[inline]
            fn from_iter<T: ::core::iter::IntoIterator<Item = Self>>(flags: T) -> Self {
                $crate::generated::union(Self(0), flags)
            }
        }

        impl ::core::iter::IntoIterator for $name {
            type Item = Self;
            type IntoIter = $crate::flags::Iter<Self>;

            #[inline]
            fn into_iter(self) -> $crate::flags::Iter<Self> {
                self.iter()
            }
        }

        $crate::flags!(@operator $name BitOr bitor union BitOrAssign bitor_assign insert);
        $crate::flags!(@operator $name BitAnd bitand intersection);
        $crate::flags!(@operator $name BitXor bitxor symmetric_difference BitXorAssign bitxor_assign toggle);
        $crate::flags!(@operator $name Sub sub difference SubAssign sub_assign remove);

        impl ::core::ops::BitAndAssign for $name {
            #[inline]
            fn bitand_assign(&mut self, other: Self) {
                self.0 &= other.0
            }
        }

        impl ::core::ops::Not for $name {
            type Output = Self;

            #[inline]
            fn not(self) -> Self {
                self.complement()
            }
        }

        $crate::__serde!($name, serialize_enum, deserialize_enum);
        $crate::__defmt!($name, value);
        $crate::__arbitrary!($name, value, value_size);
        $crate::__bitflags!($name, $repr, $info);
    };
    (@operator $name:ident $operator:ident $method:ident $by:ident $($assign:ident $assign_method:ident $assign_by:ident)?) => {
        impl ::core::ops::$operator for $name {
            type Output = Self;

            #[inline]
            fn $method(self, other: Self) -> Self {
                self.$by(other)
            }
        }

        $(impl ::core::ops::$assign for $name {
            #[inline]
            fn $assign_method(&mut self, other: Self) {
                self.$assign_by(other)
            }
        })?
    };
}
