//! [`Arbitrary`] of messages and values (feature `arbitrary`): any bytes are some payload, and any payload decodes.

pub use ::arbitrary::{Arbitrary, Result, Unstructured};

use crate::message::wire::Wire;
use crate::{Chars, Dialect, Enum, MAX_PAYLOAD, Message, MessageInfo, Repr};

/// Implements the trait by two of the functions below: one for the value, one for how many bytes it takes.
#[doc(hidden)]
#[macro_export]
macro_rules! __arbitrary {
    ($name:ident, $value:ident, $size_hint:ident) => {
        impl<'a> $crate::generated::arbitrary::Arbitrary<'a> for $name {
            fn arbitrary(
                bytes: &mut $crate::generated::arbitrary::Unstructured<'a>,
            ) -> $crate::generated::arbitrary::Result<Self> {
                $crate::generated::arbitrary::$value(bytes)
            }

            fn size_hint(_: usize) -> (usize, ::core::option::Option<usize>) {
                $crate::generated::arbitrary::$size_hint::<Self>()
            }
        }
    };
}

/// Implements the trait for a struct, field by field.
#[doc(hidden)]
#[macro_export]
macro_rules! __arbitrary_record {
    ($name:ident { $($field:ident),* }) => {
        impl<'a> $crate::generated::arbitrary::Arbitrary<'a> for $name {
            fn arbitrary(
                bytes: &mut $crate::generated::arbitrary::Unstructured<'a>,
            ) -> $crate::generated::arbitrary::Result<Self> {
                ::core::result::Result::Ok(Self {
                    $($field: $crate::generated::arbitrary::Arbitrary::arbitrary(bytes)?),*
                })
            }
        }
    };
}

/// Implements the trait for an enum over structs: each as often as the others.
#[doc(hidden)]
#[macro_export]
macro_rules! __arbitrary_topics {
    ($name:ident { $($topic:ident),* }) => {
        impl<'a> $crate::generated::arbitrary::Arbitrary<'a> for $name {
            fn arbitrary(
                bytes: &mut $crate::generated::arbitrary::Unstructured<'a>,
            ) -> $crate::generated::arbitrary::Result<Self> {
                let topics: &[fn(&mut $crate::generated::arbitrary::Unstructured<'a>) -> _] =
                    &[$(|bytes| $crate::generated::arbitrary::Arbitrary::arbitrary(bytes).map(Self::$topic)),*];
                (bytes.choose(topics)?)(bytes)
            }
        }
    };
}

/// A message.
///
/// # Errors
///
/// Those of [`Unstructured`]; here and below.
pub fn message<M: Message>(bytes: &mut Unstructured<'_>) -> Result<M> {
    Ok(M::decode(&payload(M::INFO, bytes)?))
}

/// The bytes that a message takes.
pub fn message_size<M: Message>() -> (usize, Option<usize>) {
    exactly(M::INFO.len_v2.into())
}

/// Any message of a dialect, each as often as the others.
pub fn dialect<D: Dialect>(bytes: &mut Unstructured<'_>) -> Result<D> {
    let at = bytes.choose_index(D::TABLE.len())?;
    let info = D::TABLE.iter().nth(at).ok_or(::arbitrary::Error::EmptyChoose)?;
    D::decode(info.id, &payload(info, bytes)?).ok_or(::arbitrary::Error::IncorrectFormat)
}

/// The bytes that some message of a dialect takes, and the choice.
pub fn dialect_size<D: Dialect>() -> (usize, Option<usize>) {
    (0, Some(size_of::<usize>() + MAX_PAYLOAD))
}

/// A value of an enum or a flags type, named or not.
pub fn value<E: Enum>(bytes: &mut Unstructured<'_>) -> Result<E> {
    let mut number = [0; 8];
    bytes.fill_buffer(number.get_mut(..E::Repr::SIZE).unwrap_or_default())?;
    Ok(E::from_repr(E::Repr::from_bits(u64::from_le_bytes(number))))
}

/// The bytes that a value of an enum or a flags type takes.
pub fn value_size<E: Enum>() -> (usize, Option<usize>) {
    exactly(E::Repr::SIZE)
}

fn payload(info: &MessageInfo, bytes: &mut Unstructured<'_>) -> Result<[u8; MAX_PAYLOAD]> {
    let mut payload = [0; MAX_PAYLOAD];
    bytes.fill_buffer(payload.get_mut(..info.len_v2.into()).unwrap_or_default())?;
    Ok(payload)
}

fn exactly(size: usize) -> (usize, Option<usize>) {
    (size, Some(size))
}

impl<'a, const N: usize> Arbitrary<'a> for Chars<N> {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let mut chars = Self::default();
        bytes.fill_buffer(&mut chars.0)?;
        Ok(chars)
    }

    fn size_hint(_: usize) -> (usize, Option<usize>) {
        exactly(N)
    }
}
