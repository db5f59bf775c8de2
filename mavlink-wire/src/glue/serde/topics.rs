//! The enum over the topics of a package: a topic with its name.

use core::fmt;
use core::marker::PhantomData;

use serde_core::de::{
    Deserialize, DeserializeSeed, Deserializer, EnumAccess, Error, SeqAccess, VariantAccess, Visitor,
};
use serde_core::ser::{Serialize, SerializeTuple, Serializer};

/// Implements serde's traits for an enum over topics.
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_topics {
    ($name:ident { $($topic:ident),* }) => {
        impl $crate::generated::serde::Serialize for $name {
            fn serialize<S: $crate::generated::serde::Serializer>(
                &self,
                serializer: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                const NAMES: &[&str] = <$name as $crate::generated::serde::AnyTopic>::NAMES;
                match self {
                    $(Self::$topic(topic) => $crate::generated::serde::serialize_topic(
                        serializer,
                        ::core::stringify!($name),
                        (NAMES, <$topic as $crate::uorb::Topic>::NAME),
                        topic,
                    ),)*
                }
            }
        }

        impl<'de> $crate::generated::serde::Deserialize<'de> for $name {
            fn deserialize<D: $crate::generated::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                $crate::generated::serde::deserialize_topics(::core::stringify!($name), deserializer)
            }
        }

        impl $crate::generated::serde::AnyTopic for $name {
            const NAMES: &'static [&'static str] = &[$(<$topic as $crate::uorb::Topic>::NAME),*];

            fn read<'de, C: $crate::generated::serde::Content<'de>>(
                name: &str,
                content: C,
            ) -> ::core::result::Result<Self, C::Error> {
                $(if name == <$topic as $crate::uorb::Topic>::NAME {
                    return content.read().map(Self::$topic);
                })*
                ::core::result::Result::Err($crate::generated::serde::no_variant(name, Self::NAMES))
            }
        }
    };
}

/// An enum over topics, as serde reads it.
pub trait AnyTopic: Sized {
    /// The names of its topics.
    const NAMES: &'static [&'static str];

    /// Reads the topic of this name.
    ///
    /// # Errors
    ///
    /// There is none, or a field is missing or has a value that does not fit.
    fn read<'de, C: Content<'de>>(name: &str, content: C) -> Result<Self, C::Error>;
}

/// The fields that follow a name.
pub trait Content<'de> {
    /// The deserializer's.
    type Error: Error;

    /// Reads them.
    ///
    /// # Errors
    ///
    /// Those of the deserializer.
    fn read<T: Deserialize<'de>>(self) -> Result<T, Self::Error>;
}

/// For people a map from the name to the topic; else both, so that data survives new topics.
///
/// # Errors
///
/// Those of the serializer.
pub fn serialize_topic<S: Serializer>(
    serializer: S,
    name: &'static str,
    (names, topic): (&'static [&'static str], &'static str),
    content: &impl Serialize,
) -> Result<S::Ok, S::Error> {
    if serializer.is_human_readable() {
        let index = names.iter().position(|known| *known == topic).unwrap_or_default();
        return serializer.serialize_newtype_variant(name, index as u32, topic, content);
    }
    let mut pair = serializer.serialize_tuple(2)?;
    pair.serialize_element(topic)?;
    pair.serialize_element(content)?;
    pair.end()
}

/// Reads a topic with its name.
///
/// # Errors
///
/// As of [`AnyTopic::read`].
pub fn deserialize_topics<'de, T: AnyTopic, D: Deserializer<'de>>(
    name: &'static str,
    deserializer: D,
) -> Result<T, D::Error> {
    if deserializer.is_human_readable() {
        deserializer.deserialize_enum(name, T::NAMES, Any(name, PhantomData))
    } else {
        deserializer.deserialize_tuple(2, Any(name, PhantomData))
    }
}

struct Any<T>(&'static str, PhantomData<T>);

impl<'de, T: AnyTopic> Visitor<'de> for Any<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a topic of {}, behind its name", self.0)
    }

    fn visit_enum<A: EnumAccess<'de>>(self, data: A) -> Result<T, A::Error> {
        let (name, content) = data.variant_seed(Name(T::NAMES))?;
        T::read(name, Variant::<A>(content))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<T, A::Error> {
        let name = seq.next_element_seed(Name(T::NAMES))?.ok_or_else(|| A::Error::invalid_length(0, &self))?;
        T::read(name, Rest(seq))
    }
}

struct Variant<'de, A: EnumAccess<'de>>(A::Variant);

impl<'de, A: EnumAccess<'de>> Content<'de> for Variant<'de, A> {
    type Error = A::Error;

    fn read<T: Deserialize<'de>>(self) -> Result<T, A::Error> {
        self.0.newtype_variant()
    }
}

struct Rest<A>(A);

impl<'de, A: SeqAccess<'de>> Content<'de> for Rest<A> {
    type Error = A::Error;

    fn read<T: Deserialize<'de>>(mut self) -> Result<T, A::Error> {
        self.0.next_element()?.ok_or_else(|| A::Error::invalid_length(1, &"a name and a topic"))
    }
}

/// Reads the name of a topic.
struct Name(&'static [&'static str]);

impl<'de> DeserializeSeed<'de> for Name {
    type Value = &'static str;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<&'static str, D::Error> {
        // For people it is the variant of an enum, which some formats write without quotes; else a text in a tuple.
        match deserializer.is_human_readable() {
            true => deserializer.deserialize_identifier(self),
            false => deserializer.deserialize_str(self),
        }
    }
}

impl Visitor<'_> for Name {
    type Value = &'static str;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a topic")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<&'static str, E> {
        self.0.iter().find(|known| **known == name).copied().ok_or_else(|| E::unknown_variant(name, self.0))
    }
}
