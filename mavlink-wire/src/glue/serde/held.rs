//! Views, slots and other small types, by their fields; enums with their variants.

use serde_core::Serialize;
use serde_core::de::{
    Deserialize, DeserializeSeed, Deserializer, EnumAccess, Error, IgnoredAny, MapAccess, SeqAccess, VariantAccess,
    Visitor,
};
use serde_core::ser::{SerializeStruct, SerializeTuple, Serializer};

use crate::message::record::{Several, plain_name};

/// Implements serde's traits for a view.
///
/// For people its own fields, from which it is read again, and what is in the bits; else a tuple of its own fields.
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_view {
    ($name:ident { $($field:ident),* } [$($member:ident $([$count:literal])?),*]) => {
        impl $crate::generated::serde::Serialize for $name {
            fn serialize<S: $crate::generated::serde::Serializer>(
                &self,
                serializer: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                const NAMES: [&[&str]; 2] = [&[$(::core::stringify!($field)),*], &[$(::core::stringify!($member)),*]];
                let view = self;
                let mut fields =
                    $crate::generated::serde::Fields::new(serializer, ::core::stringify!($name), NAMES.map(<[&str]>::len))?;
                $(fields.add(::core::stringify!($field), &view.$field())?;)*
                $(fields.tell(::core::stringify!($member), &$crate::__member!(view $member $($count)?))?;)*
                fields.end()
            }
        }

        $crate::__deserialize!($name { $($field),* } $name::from_bits($($field),*));
    };
}

/// Implements serde's traits for a struct.
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_record {
    ($name:ident { $($field:ident),* }) => {
        impl $crate::generated::serde::Serialize for $name {
            fn serialize<S: $crate::generated::serde::Serializer>(
                &self,
                serializer: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                const NAMES: &[&str] = &[$(::core::stringify!($field)),*];
                let mut fields =
                    $crate::generated::serde::Fields::new(serializer, ::core::stringify!($name), [NAMES.len(), 0])?;
                $(fields.add(::core::stringify!($field), &self.$field)?;)*
                fields.end()
            }
        }

        $crate::__deserialize!($name { $($field),* } $name { $($field),* });
    };
}

/// Implements `Deserialize` by fields, of which something is made.
#[doc(hidden)]
#[macro_export]
macro_rules! __deserialize {
    ($name:ident { $($field:ident),* } $made:expr) => {
        impl<'de> $crate::generated::serde::Deserialize<'de> for $name {
            fn deserialize<D: $crate::generated::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                const NAMES: &[&str] = &[$(::core::stringify!($field)),*];

                struct Made;

                impl<'de> $crate::generated::serde::Visitor<'de> for Made {
                    type Value = $name;

                    fn expecting(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                        f.write_str(::core::concat!("the fields of ", ::core::stringify!($name)))
                    }

                    fn visit_seq<A: $crate::generated::serde::SeqAccess<'de>>(
                        self,
                        mut seq: A,
                    ) -> ::core::result::Result<$name, A::Error> {
                        $(let $field = $crate::generated::serde::next_element(&mut seq, ::core::stringify!($field))?;)*
                        ::core::result::Result::Ok($made)
                    }

                    fn visit_map<A: $crate::generated::serde::MapAccess<'de>>(
                        self,
                        mut map: A,
                    ) -> ::core::result::Result<$name, A::Error> {
                        $(let mut $field = ::core::option::Option::None;)*
                        while let ::core::option::Option::Some(name) = $crate::generated::serde::next_name(&mut map, NAMES)? {
                            match name {
                                $(::core::stringify!($field) => $crate::generated::serde::read_once(&mut map, name, &mut $field)?,)*
                                _ => $crate::generated::serde::skip(&mut map)?,
                            }
                        }
                        $(let $field = $crate::generated::serde::needed($field, ::core::stringify!($field))?;)*
                        ::core::result::Result::Ok($made)
                    }
                }

                $crate::generated::serde::read_fields(deserializer, ::core::stringify!($name), NAMES, Made)
            }
        }
    };
}

/// Implements serde's traits for an enum.
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_variants {
    ($name:ident { $($variant:ident),* } $($other:ident($number:ty))?) => {
        impl $crate::generated::serde::Serialize for $name {
            fn serialize<S: $crate::generated::serde::Serializer>(
                &self,
                serializer: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                const NAMES: &[&str] = &[$(::core::stringify!($variant),)* $(::core::stringify!($other))?];
                let variant = match self {
                    $(Self::$variant => ::core::stringify!($variant),)*
                    $(Self::$other(number) => {
                        let index = NAMES.len() as u32 - 1;
                        let (name, variant) = (::core::stringify!($name), ::core::stringify!($other));
                        return serializer.serialize_newtype_variant(name, index, variant, number);
                    })?
                };
                $crate::generated::serde::serialize_variant(serializer, ::core::stringify!($name), NAMES, variant)
            }
        }

        impl<'de> $crate::generated::serde::Deserialize<'de> for $name {
            fn deserialize<D: $crate::generated::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                const NAMES: &[&str] = &[$(::core::stringify!($variant),)* $(::core::stringify!($other))?];

                struct Made;

                impl<'de> $crate::generated::serde::Visitor<'de> for Made {
                    type Value = $name;

                    fn expecting(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                        f.write_str(::core::concat!("a variant of ", ::core::stringify!($name)))
                    }

                    fn visit_enum<A: $crate::generated::serde::EnumAccess<'de>>(
                        self,
                        data: A,
                    ) -> ::core::result::Result<$name, A::Error> {
                        let (variant, access) = $crate::generated::serde::variant(data, NAMES)?;
                        $(if variant == ::core::stringify!($other) {
                            return $crate::generated::serde::number::<A, $number>(access).map($name::$other);
                        })?
                        $crate::generated::serde::unit::<A>(access)?;
                        match variant {
                            $(::core::stringify!($variant) => ::core::result::Result::Ok($name::$variant),)*
                            _ => ::core::result::Result::Err($crate::generated::serde::no_variant(variant, NAMES)),
                        }
                    }
                }

                deserializer.deserialize_enum(::core::stringify!($name), NAMES, Made)
            }
        }
    };
}

/// What is written of a struct: for people by names, else a tuple.
#[derive(Debug)]
pub enum Fields<S: Serializer> {
    /// By names.
    Named(S::SerializeStruct),
    /// By places.
    Placed(S::SerializeTuple),
}

impl<S: Serializer> Fields<S> {
    /// Begins it: so many fields, and so many that are only told.
    ///
    /// # Errors
    ///
    /// Those of the serializer, as in all of these.
    pub fn new(serializer: S, name: &'static str, [fields, told]: [usize; 2]) -> Result<Self, S::Error> {
        if serializer.is_human_readable() {
            serializer.serialize_struct(name, fields + told).map(Self::Named)
        } else {
            serializer.serialize_tuple(fields).map(Self::Placed)
        }
    }

    /// Writes a field.
    pub fn add(&mut self, name: &'static str, value: &impl Serialize) -> Result<(), S::Error> {
        match self {
            Self::Named(fields) => fields.serialize_field(plain_name(name), value),
            Self::Placed(fields) => fields.serialize_element(value),
        }
    }

    /// Writes what people want to know, and nobody reads again.
    pub fn tell(&mut self, name: &'static str, value: &impl Serialize) -> Result<(), S::Error> {
        match self {
            Self::Named(fields) => fields.serialize_field(plain_name(name), value),
            Self::Placed(_) => Ok(()),
        }
    }

    /// Ends it.
    pub fn end(self) -> Result<S::Ok, S::Error> {
        match self {
            Self::Named(fields) => fields.end(),
            Self::Placed(fields) => fields.end(),
        }
    }
}

impl<T: Serialize, F: Fn(usize) -> Option<T>> Serialize for Several<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.values())
    }
}

/// Reads a struct: for people by names, else a tuple.
///
/// # Errors
///
/// Those of the deserializer, as in all of these.
pub fn read_fields<'de, D: Deserializer<'de>, V: Visitor<'de>>(
    deserializer: D,
    name: &'static str,
    names: &'static [&'static str],
    visitor: V,
) -> Result<V::Value, D::Error> {
    if deserializer.is_human_readable() {
        deserializer.deserialize_struct(name, names, visitor)
    } else {
        deserializer.deserialize_tuple(names.len(), visitor)
    }
}

/// The next value of a tuple.
pub fn next_element<'de, A: SeqAccess<'de>, T: Deserialize<'de>>(
    seq: &mut A,
    name: &'static str,
) -> Result<T, A::Error> {
    seq.next_element()?.ok_or_else(|| A::Error::missing_field(plain_name(name)))
}

/// The next key: which of the names it is, or an empty one.
pub fn next_name<'de, A: MapAccess<'de>>(
    map: &mut A,
    names: &'static [&'static str],
) -> Result<Option<&'static str>, A::Error> {
    Ok(map.next_key_seed(Name(names))?.map(Option::unwrap_or_default))
}

/// Reads the value of a key, which comes once.
pub fn read_once<'de, A: MapAccess<'de>, T: Deserialize<'de>>(
    map: &mut A,
    name: &'static str,
    into: &mut Option<T>,
) -> Result<(), A::Error> {
    match into.replace(map.next_value()?) {
        None => Ok(()),
        Some(_) => Err(A::Error::duplicate_field(plain_name(name))),
    }
}

/// Leaves out the value of a key.
pub fn skip<'de, A: MapAccess<'de>>(map: &mut A) -> Result<(), A::Error> {
    map.next_value::<IgnoredAny>().map(|_| ())
}

/// A value that has to be there.
pub fn needed<T, E: Error>(value: Option<T>, name: &'static str) -> Result<T, E> {
    value.ok_or_else(|| E::missing_field(plain_name(name)))
}

/// The name of a variant, or an empty one, and what follows.
pub fn variant<'de, A: EnumAccess<'de>>(
    data: A,
    names: &'static [&'static str],
) -> Result<(&'static str, A::Variant), A::Error> {
    let (name, access) = data.variant_seed(Name(names))?;
    Ok((name.unwrap_or_default(), access))
}

/// Nothing follows.
pub fn unit<'de, A: EnumAccess<'de>>(access: A::Variant) -> Result<(), A::Error> {
    access.unit_variant()
}

/// A number follows.
pub fn number<'de, A: EnumAccess<'de>, T: Deserialize<'de>>(access: A::Variant) -> Result<T, A::Error> {
    access.newtype_variant()
}

/// There is no such variant.
pub fn no_variant<E: Error>(found: &str, names: &'static [&'static str]) -> E {
    E::unknown_variant(found, names)
}

/// Writes a variant without a value.
pub fn serialize_variant<S: Serializer>(
    serializer: S,
    name: &'static str,
    names: &'static [&'static str],
    variant: &'static str,
) -> Result<S::Ok, S::Error> {
    let index = names.iter().position(|name| *name == variant).unwrap_or_default();
    serializer.serialize_unit_variant(name, index as u32, variant)
}

/// Reads a name: which of these it is.
pub(super) struct Name(pub(super) &'static [&'static str]);

impl<'de> DeserializeSeed<'de> for Name {
    type Value = Option<&'static str>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Name {
    type Value = Option<&'static str>;

    fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("a name")
    }

    fn visit_str<E: Error>(self, found: &str) -> Result<Self::Value, E> {
        Ok(self.0.iter().copied().find(|name| plain_name(name) == found))
    }

    fn visit_bytes<E: Error>(self, found: &[u8]) -> Result<Self::Value, E> {
        Ok(self.0.iter().copied().find(|name| plain_name(name).as_bytes() == found))
    }

    fn visit_u64<E: Error>(self, index: u64) -> Result<Self::Value, E> {
        Ok(usize::try_from(index).ok().and_then(|index| self.0.get(index)).copied())
    }
}
