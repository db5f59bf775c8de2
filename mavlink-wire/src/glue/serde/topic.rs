//! Topics: field by field, since they have no payload of a few bytes that stands for all.

use core::fmt;
use core::marker::PhantomData;

use serde_core::de::{Deserialize, DeserializeSeed, Deserializer, Error, SeqAccess, Visitor};
use serde_core::ser::{Serialize, SerializeTuple, Serializer};

use super::value::{Shape, Value, deserialize_enum, serialize_enum};
use crate::{Chars, Enum, Kind, Repr};

/// Implements serde's traits for a topic.
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_topic {
    ($name:ident { $($field:ident),* }) => {
        impl $crate::generated::serde::Serialize for $name {
            fn serialize<S: $crate::generated::serde::Serializer>(
                &self,
                serializer: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                const NAMES: &[&str] = &[$(::core::stringify!($field)),*];
                let mut fields =
                    $crate::generated::serde::Fields::new(serializer, ::core::stringify!($name), [NAMES.len(), 0])?;
                $(fields.add(::core::stringify!($field), &$crate::generated::serde::Exactly(self.$field))?;)*
                fields.end()
            }
        }

        $crate::__deserialize!($name { $($field),* } $name {
            $($field: $crate::generated::serde::exactly($field)),*
        });

        impl $crate::generated::serde::Exact for $name {
            fn zero() -> Self {
                Self::UNKNOWN
            }

            fn write<S: $crate::generated::serde::Serializer>(
                self,
                serializer: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                $crate::generated::serde::Serialize::serialize(&self, serializer)
            }

            fn read<'de, D: $crate::generated::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                $crate::generated::serde::Deserialize::deserialize(deserializer)
            }
        }
    };
}

/// What a field of a topic can be. Floats come back to the bit, arrays have any length.
pub trait Exact: Copy {
    /// What an array is begun with.
    fn zero() -> Self;

    /// Writes the value.
    ///
    /// # Errors
    ///
    /// Those of the serializer.
    fn write<S: Serializer>(self, serializer: S) -> Result<S::Ok, S::Error>;

    /// Reads a value.
    ///
    /// # Errors
    ///
    /// Those of the deserializer; the value does not fit.
    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error>;
}

/// A field of a topic as serde takes it.
#[derive(Clone, Copy, Debug)]
pub struct Exactly<T>(pub T);

/// What was read.
pub fn exactly<T>(read: Exactly<T>) -> T {
    read.0
}

impl<T: Exact> Serialize for Exactly<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.write(serializer)
    }
}

impl<'de, T: Exact> Deserialize<'de> for Exactly<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        T::read(deserializer).map(Self)
    }
}

macro_rules! plain {
    ($($type:ty)*) => {$(
        impl Exact for $type {
            fn zero() -> Self {
                Self::default()
            }

            fn write<S: Serializer>(self, serializer: S) -> Result<S::Ok, S::Error> {
                self.serialize(serializer)
            }

            fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                Self::deserialize(deserializer)
            }
        }
    )*};
}

plain!(u8 i8 u16 i16 u32 i32 u64 i64 bool);

macro_rules! float {
    ($($type:ty: $kind:ident of $bits:ty;)*) => {$(
        impl Exact for $type {
            fn zero() -> Self {
                0.0
            }

            fn write<S: Serializer>(self, serializer: S) -> Result<S::Ok, S::Error> {
                Value { shape: Shape::of(Kind::$kind), bits: self.to_bits().into() }.serialize(serializer)
            }

            fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                Shape::of(Kind::$kind).deserialize(deserializer).map(|bits| Self::from_bits(bits as $bits))
            }
        }
    )*};
}

float! {
    f32: F32 of u32;
    f64: F64 of u64;
}

impl<const N: usize> Exact for Chars<N> {
    fn zero() -> Self {
        Self([0; N])
    }

    fn write<S: Serializer>(self, serializer: S) -> Result<S::Ok, S::Error> {
        self.serialize(serializer)
    }

    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::deserialize(deserializer)
    }
}

impl<T: Exact, const N: usize> Exact for [T; N] {
    fn zero() -> Self {
        [T::zero(); N]
    }

    fn write<S: Serializer>(self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(N)?;
        for element in self {
            tuple.serialize_element(&Exactly(element))?;
        }
        tuple.end()
    }

    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_tuple(N, ArrayVisitor(PhantomData))
    }
}

/// Takes as many values as the array has.
struct ArrayVisitor<T, const N: usize>(PhantomData<[T; N]>);

impl<'de, T: Exact, const N: usize> Visitor<'de> for ArrayVisitor<T, N> {
    type Value = [T; N];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "an array of {N}")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<[T; N], A::Error> {
        let mut array = [T::zero(); N];
        for (at, element) in array.iter_mut().enumerate() {
            let read: Option<Exactly<T>> = seq.next_element()?;
            *element = read.ok_or_else(|| A::Error::invalid_length(at, &self))?.0;
        }
        Ok(array)
    }
}

impl<E: Enum> Exact for E {
    fn zero() -> Self {
        E::from_repr(E::Repr::from_bits(0))
    }

    fn write<S: Serializer>(self, serializer: S) -> Result<S::Ok, S::Error> {
        serialize_enum(&self, serializer)
    }

    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserialize_enum(deserializer)
    }
}
