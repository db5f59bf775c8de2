//! What generated messages and dialects implement.

pub(crate) mod chars;
pub(crate) mod enums;
mod field;
pub mod flags;
pub(crate) mod float;
mod info;
pub(crate) mod scale;
pub(crate) mod wire;

pub use chars::Chars;
pub use enums::{Enum, Repr};
pub use field::{FieldInfo, Invalid, Kind, Sentinel};
pub use info::{EnumInfo, MessageInfo, ParamInfo};

use crate::{MAX_PAYLOAD, Table, Version};

/// Something that can be sent: a message, or a dialect's enum of messages. Usable as `&dyn Encode`.
pub trait Encode {
    /// Id, lengths and checksum byte.
    fn info(&self) -> &'static MessageInfo;

    /// Writes the first `info().len_v2` bytes, each field at its offset; the rest is left as it was.
    fn write(&self, payload: &mut [u8; MAX_PAYLOAD]);

    /// The payload as it is sent: MAVLink 2 cuts trailing zeros down to one byte, MAVLink 1 sends `len_v1` bytes.
    #[inline]
    fn payload<'b>(&self, version: Version, buffer: &'b mut [u8; MAX_PAYLOAD]) -> &'b [u8] {
        self.write(buffer);
        let length = sent_length(self.info(), version, buffer);
        buffer.get(..length).unwrap_or_default()
    }
}

/// How much of a written payload goes on the wire.
pub(crate) fn sent_length(info: &MessageInfo, version: Version, payload: &[u8]) -> usize {
    match version {
        Version::V1 => usize::from(info.len_v1),
        Version::V2 => trimmed(payload, usize::from(info.len_v2)),
    }
}

/// The length without trailing zeros, but at least one; eight bytes at a time, since most zeros come in crowds.
fn trimmed(payload: &[u8], mut length: usize) -> usize {
    while let Some(last) = payload.get(..length).and_then(<[u8]>::last_chunk::<8>) {
        let zeros = u64::from_le_bytes(*last).leading_zeros() as usize / 8;
        length -= zeros;
        if zeros < 8 {
            return length.max(1);
        }
    }
    while let Some(0) = payload.get(..length).and_then(<[u8]>::last) {
        length -= 1;
    }
    length.max(1)
}

/// A message of a dialect.
pub trait Message: Encode + Copy + 'static {
    /// Message id.
    const ID: u32;

    /// Id, lengths and checksum byte.
    const INFO: &'static MessageInfo;

    /// The fields in the order of the XML. A separate static, which the linker drops where nobody asks for it.
    const FIELDS: &'static [FieldInfo];

    /// All zero, except for the field that carries the version of the XML file.
    const DEFAULT: Self;

    /// Reads a payload. Total: what is missing at its end is zero, what is too much is ignored.
    fn decode(payload: &[u8]) -> Self;

    /// The fields with the ids of the addressed system and component, for a router that rewrites them; `None` where
    /// [`MessageInfo`] says that the message has none.
    #[inline]
    fn target_mut(&mut self) -> (Option<&mut u8>, Option<&mut u8>) {
        (None, None)
    }
}

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
    #[inline]
    fn decode(id: u32, payload: &[u8]) -> Option<Self> {
        // Built where it is returned: moving a message costs more than decoding it.
        let mut message = Some(Self::DEFAULT);
        if !message.as_mut().is_some_and(|message| message.decode_into(id, payload)) {
            message = None;
        }
        message
    }

    /// The fields of the message with this id, in the order of the XML; `None` if the dialect does not have it.
    fn fields(id: u32) -> Option<&'static [FieldInfo]> {
        Self::FIELDS.get(Self::TABLE.position(id)?).copied()
    }
}

/// A message with an addressee.
pub trait Targeted: Message {
    /// The same message to this system and component. Zero means all of them.
    #[must_use]
    fn to(self, system: impl Into<u8>, component: impl Into<u8>) -> Self;
}

/// Completes a message: `Default`, and what the optional features add.
#[macro_export]
macro_rules! message {
    ($name:ident) => {
        impl ::core::default::Default for $name {
            #[inline]
            fn default() -> Self {
                <Self as $crate::Message>::DEFAULT
            }
        }

        $crate::__serde!($name, serialize_message, deserialize_message);
        $crate::__defmt!($name, message);
        $crate::__arbitrary!($name, message, message_size);
    };
}

/// Completes a dialect's enum, whose variants have the names of the types in them: `From` each message, `TryFrom` back
/// (the error is the enum, unchanged), [`Encode`], and what the optional features add. [`Dialect`] is written out beside it.
///
/// `dialect!(Autoquad { Heartbeat, SysStatus })`
#[macro_export]
macro_rules! dialect {
    ($dialect:ident { $($message:ident),* $(,)? }) => {
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

        $crate::__serde!($dialect, serialize_dialect, deserialize_dialect, ::core::stringify!($dialect));
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
