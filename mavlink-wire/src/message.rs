//! Messages: what they implement, what they are made of, and what is said of them.

pub(crate) mod chars;
pub(crate) mod command;
pub(crate) mod dialect;
pub(crate) mod enums;
mod field;
pub mod flags;
pub(crate) mod float;
mod info;
pub(crate) mod record;
pub(crate) mod scale;
pub(crate) mod wire;

pub use chars::Chars;
pub use command::{CarriesInt, CarriesLong, Command, CommandError, ParamError, Params};
pub use dialect::Dialect;
pub use enums::{Enum, Repr};
pub use field::{FieldInfo, Invalid, Kind, Sentinel};
pub use info::{EnumInfo, MessageInfo, ParamInfo};

use crate::{ComponentId, MAX_PAYLOAD, SystemId, Version};

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

/// A message of a dialect. What is [`Encode`] of it stands here once for all messages.
///
/// Generated code says what is a message's own: its facts, and how it is [read](Self::read) and [stored](Self::store).
/// Programs call [`decode`](Self::decode), [`Frame::decode`](crate::Frame::decode) and what [`Encode`] has.
pub trait Message: Copy + 'static {
    /// The payload at its full length: `[u8; 52]`.
    type Payload: Payload;

    /// Id, lengths and checksum byte.
    const INFO: &'static MessageInfo;

    /// The fields in the order of the XML. A separate static, which the linker drops where nobody asks for it.
    const FIELDS: &'static [FieldInfo];

    /// All zero, except for the field that carries the version of the XML file.
    const DEFAULT: Self;

    /// Message id.
    const ID: u32 = Self::INFO.id;

    /// Reads a payload of full length.
    fn read(payload: &Self::Payload) -> Self;

    /// Writes each field at its offset.
    fn store(&self, payload: &mut Self::Payload);

    /// Reads a payload. Total: what is missing at its end is zero, what is too much is ignored.
    ///
    /// Always inlined, as [`read`](Self::read) should be, so that a message is built where it is wanted: 4 ns against 12
    /// for a call and a move.
    #[inline(always)]
    #[must_use]
    fn decode(payload: &[u8]) -> Self {
        let padded;
        let payload = match Self::Payload::first(payload) {
            Some(whole) => whole,
            None => {
                padded = Self::Payload::zero_extended(payload);
                &padded
            }
        };
        Self::read(payload)
    }

    /// The fields with the ids of the addressed system and component, for a router that rewrites them; `None` where
    /// [`MessageInfo`] says that the message has none.
    #[inline]
    fn target_mut(&mut self) -> (Option<&mut u8>, Option<&mut u8>) {
        (None, None)
    }
}

impl<M: Message> Encode for M {
    #[inline]
    fn info(&self) -> &'static MessageInfo {
        M::INFO
    }

    #[inline]
    fn write(&self, payload: &mut [u8; MAX_PAYLOAD]) {
        const { assert!(size_of::<M::Payload>() == M::INFO.len_v2 as usize, "len_v2 is the length of the payload") }
        if let Some(payload) = M::Payload::first_mut(payload) {
            self.store(payload);
        }
    }
}

/// Payloads of a fixed length: `[u8; N]`.
pub trait Payload: Copy + sealed::Sealed {
    /// The beginning of the bytes; `None` if they are too few.
    fn first(bytes: &[u8]) -> Option<&Self>;

    /// The beginning of the bytes, to be written; `None` if they are too few.
    fn first_mut(bytes: &mut [u8]) -> Option<&mut Self>;

    /// The bytes with zeros behind them, or their beginning if they are too many.
    fn zero_extended(bytes: &[u8]) -> Self;
}

mod sealed {
    pub trait Sealed {}
    impl<const N: usize> Sealed for [u8; N] {}
}

impl<const N: usize> Payload for [u8; N] {
    #[inline(always)]
    fn first(bytes: &[u8]) -> Option<&Self> {
        bytes.first_chunk()
    }

    #[inline(always)]
    fn first_mut(bytes: &mut [u8]) -> Option<&mut Self> {
        bytes.first_chunk_mut()
    }

    #[inline(always)]
    fn zero_extended(bytes: &[u8]) -> Self {
        wire::zero_extended(bytes)
    }
}

/// A message with an addressee: its [`target_mut`](Message::target_mut) gives a system and a component.
pub trait Targeted: Message {
    /// The same message to this system and component. Zero means all of them.
    #[inline]
    #[must_use]
    fn to(mut self, system_id: impl Into<SystemId>, component_id: impl Into<ComponentId>) -> Self {
        if let (Some(target_system), Some(target_component)) = self.target_mut() {
            (*target_system, *target_component) = (system_id.into().to_u8(), component_id.into().to_u8());
        }
        self
    }
}

/// Completes a message: `Default`, `Debug`, `Display` ([its text](crate::reflect#the-text)), and what the optional features add.
/// The struct and its [`Message`](crate::Message) are written out beside it, with `Clone, Copy` derived.
///
/// `message!(AqEscTelemetry { each escs, maybe status })` also takes the getters of what overlays see in the message, each by what it
/// gives: `one` value, `maybe` one under a condition, or `each` slot.
#[macro_export]
macro_rules! message {
    ($name:ident) => {
        $crate::message!($name {});
    };
    ($name:ident { $($kind:ident $getter:ident),* }) => {
        impl ::core::default::Default for $name {
            #[inline]
            fn default() -> Self {
                <Self as $crate::Message>::DEFAULT
            }
        }

        impl ::core::fmt::Debug for $name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::generated::debug_message(self, ::core::stringify!($name), f)
            }
        }

        impl ::core::fmt::Display for $name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::generated::fmt_message(self, f)
            }
        }

        $crate::__serde!($name, serialize_message, deserialize_message);
        $crate::__serde_message_views!($name { $($kind $getter),* });
        $crate::__defmt!($name, message);
        $crate::__arbitrary!($name, message, message_size);
    };
}
