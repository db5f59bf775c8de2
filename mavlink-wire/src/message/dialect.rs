//! What a generated dialect implements.

use crate::{Encode, FieldInfo, Message, Table};

/// A dialect's enum of all messages, for code that works on any dialect.
///
/// ```
/// use mavlink_wire::{Dialect, Encode, Frame};
///
/// fn name<D: Dialect>(frame: &Frame<'_>) -> Option<&'static str> {
///     frame.message::<D>().map(|message| message.info().name)
/// }
/// ```
pub trait Dialect: Encode + Sized + 'static {
    /// All messages of the dialect.
    const TABLE: &'static Table<'static>;

    /// The fields of every message, in the order of [`TABLE`](Self::TABLE): see [`fields`](Self::fields).
    const FIELDS: &'static [&'static [FieldInfo]];

    /// The first message of the dialect at its default: something to read into.
    const DEFAULT: Self;

    /// Reads a payload into `self`; `false`, and `self` as it was, if the dialect does not have this id.
    ///
    /// Faster than [`decode`](Self::decode) where that is not inlined: the message does not move.
    fn decode_into(&mut self, id: u32, payload: &[u8]) -> bool;

    /// Reads a payload; `None` if the dialect does not have this id.
    fn decode(id: u32, payload: &[u8]) -> Option<Self> {
        let mut message = Self::DEFAULT;
        message.decode_into(id, payload).then_some(message)
    }

    /// The fields of the message with this id, in the order of the XML; `None` if the dialect does not have it.
    fn fields(id: u32) -> Option<&'static [FieldInfo]> {
        Self::FIELDS.get(Self::TABLE.position(id)?).copied()
    }
}

/// Reads a message to where the dialect's enum of it is.
///
/// A call for every message: the stack of a `match` is that of all its arms together, 12 kB for the messages of `common.xml`
/// where one takes 302 bytes.
#[doc(hidden)]
#[inline(never)]
pub fn decode_variant_into<M: Message, D: Copy + From<M>>(message: &mut D, payload: &[u8]) {
    *message = D::from(M::decode(payload));
}

/// Reads a message as the dialect's enum; never `None`. A call for every message, as in [`decode_variant_into`].
#[doc(hidden)]
#[inline(never)]
pub fn decode_variant<M: Message, D: Copy + From<M>>(payload: &[u8]) -> Option<D> {
    Some(D::from(M::decode(payload)))
}

/// Completes a dialect's enum, whose variants have the names of the types in them: [`Dialect`], [`Encode`](crate::Encode), `Debug`,
/// `From` each message, `TryFrom` back (the error is the enum, unchanged), and what the optional features add.
/// The enum is written out beside it, with `Clone, Copy` derived.
///
/// `dialect!(Autoquad { Heartbeat, SysStatus })`; by id, so that a search in the table may halve.
#[macro_export]
macro_rules! dialect {
    ($dialect:ident { $first:ident $(, $message:ident)* $(,)? }) => {
        $crate::dialect!(@all $dialect, $first { $first $($message)* });
    };
    (@all $dialect:ident, $first:ident { $($message:ident)* }) => {
        impl $crate::Dialect for $dialect {
            const TABLE: &'static $crate::Table<'static> = {
                static MESSAGES: &[&$crate::MessageInfo] = &[$(<$message as $crate::Message>::INFO),*];
                static INDEX: [u16; $crate::generated::index_length(MESSAGES)] = $crate::generated::index(MESSAGES);
                static TABLE: $crate::Table<'static> = $crate::Table::indexed(MESSAGES, &INDEX);
                &TABLE
            };
            const FIELDS: &'static [&'static [$crate::FieldInfo]] = &[$(<$message as $crate::Message>::FIELDS),*];
            const DEFAULT: Self = Self::$first(<$first as $crate::Message>::DEFAULT);

            fn decode_into(&mut self, id: u32, payload: &[u8]) -> bool {
                match id {
                    $(<$message as $crate::Message>::ID => $crate::generated::decode_variant_into::<$message, Self>(self, payload),)*
                    _ => return false,
                }
                true
            }

            // A development build has no functions that are only faster: they take a twentieth of its time.
            #[cfg(not(debug_assertions))]
            fn decode(id: u32, payload: &[u8]) -> ::core::option::Option<Self> {
                match id {
                    $(<$message as $crate::Message>::ID => $crate::generated::decode_variant::<$message, Self>(payload),)*
                    _ => ::core::option::Option::None,
                }
            }
        }

        impl $crate::Encode for $dialect {
            fn info(&self) -> &'static $crate::MessageInfo {
                match self {
                    $(Self::$message(_) => <$message as $crate::Message>::INFO,)*
                }
            }

            fn write(&self, payload: &mut [u8; $crate::MAX_PAYLOAD]) {
                match self {
                    $(Self::$message(message) => $crate::Encode::write(message, payload),)*
                }
            }
        }

        $(
            impl ::core::convert::From<$message> for $dialect {
                #[inline]
                fn from(message: $message) -> Self {
                    Self::$message(message)
                }
            }

            impl ::core::convert::TryFrom<$dialect> for $message {
                type Error = $dialect;

                #[inline]
                fn try_from(message: $dialect) -> ::core::result::Result<Self, $dialect> {
                    match message {
                        $dialect::$message(message) => ::core::result::Result::Ok(message),
                        other => ::core::result::Result::Err(other),
                    }
                }
            }
        )*

        // Inlined, as what has a use for the tables of all fields: they are compiled where someone prints.
        impl ::core::fmt::Debug for $dialect {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                let name = match self {
                    $(Self::$message(_) => ::core::stringify!($message),)*
                };
                $crate::generated::debug_variant(self, name, f)
            }
        }

        impl ::core::fmt::Display for $dialect {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::generated::fmt_variant(self, f)
            }
        }

        $crate::__serde!($dialect, serialize_dialect, deserialize_dialect, ::core::stringify!($dialect));
        $crate::__serde_dialect_views!($dialect { $($message)* });
        $crate::__defmt!($dialect, dialect);
        $crate::__arbitrary!($dialect, dialect, dialect_size);
        $crate::__mavlink_core!($dialect { $($message)* });
    };
}

/// Brings a dialect in that a build script generated: `include_dialect!("acme")` gives the module `acme`.
///
/// A name that cannot be that of the module takes an underscore: `type.xml` is `type_`, and `messages.xml` is `messages_`.
#[macro_export]
macro_rules! include_dialect {
    ($name:literal) => {
        ::core::include!(::core::concat!(::core::env!("OUT_DIR"), "/", $name, ".rs"));
    };
}
