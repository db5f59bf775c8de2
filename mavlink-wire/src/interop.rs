//! A dialect over the connections of [`mavlink-core`](https://docs.rs/mavlink-core/0.21), the runtime of rust-mavlink
//! (feature `mavlink-core`): TCP, UDP, serial ports, files, blocking or not.
//!
//! Depend on `mavlink-core` 0.21 for the transports that you need:
//!
//! ```toml
//! mavlink-autoquad = { version = "0.1", features = ["mavlink-core"] }
//! mavlink-core = { version = "0.21", default-features = false, features = ["std", "transport-udp"] }
//! ```
//! ```ignore
//! let connection = interop::connect::<Autoquad>("udpin:0.0.0.0:14550")?;
//! loop {
//!     let (header, message) = connection.recv()?; // message: Autoquad, whatever the values of its enums
//!     connection.send(&MavHeader::default(), &Heartbeat::DEFAULT.into())?;
//! }
//! ```
//!
//! [`connect`] is `mavlink_core::connect_with_dialect` with a [`CoreDialect`], which also does for its configurations of a
//! single transport and for its asynchronous connections.
//!
//! A dialect's enum also implements `mavlink_core::Message`, for code that is generic over it and for
//! `mavlink_core::connect`. Where MAVLink 1 is sent, prefer the [`connect`] of this module: the connection of that one panics
//! over a message whose id is over 255, since the trait has no way to refuse it. Here it is an error, and the connection goes
//! on. Both give a connection that is a `MavConnection<Autoquad>`.
//!
//! The trait has one method more when something in the program turns on the feature `arbitrary` of `mavlink-core`. If the
//! compiler misses `random_message_from_id`, turn on `arbitrary` of the dialect's crate.

use core::marker::PhantomData;
use std::io;

use ::mavlink_core::error::{EncoderError, ParserError};
use ::mavlink_core::{DialectConnection, MavlinkVersion};

#[doc(hidden)]
pub use ::mavlink_core;
#[cfg(feature = "arbitrary")]
#[doc(hidden)]
pub use ::rand_core;

use crate::{Dialect, Encode, MAX_PAYLOAD, MessageInfo, Version};

/// Connects to the address, like `mavlink_core::connect`: `udpin:0.0.0.0:14550`, `tcpout:host:5760`, `serial:/dev/ttyUSB0:57600`,
/// `file:flight.tlog` …, as far as the features of `mavlink-core` go.
///
/// Messages that MAVLink 1 cannot carry are refused by `send` with `MessageWriteError::Encode`, where the connection of
/// `mavlink_core::connect` panics.
///
/// # Errors
/// Those of the address, of kind `AddrNotAvailable`, and those of the system.
pub fn connect<D: Dialect>(address: &str) -> io::Result<DialectConnection<CoreDialect<D>>> {
    ::mavlink_core::connect_with_dialect(address, CoreDialect::new())
}

/// A dialect for `mavlink_core::connect_with_dialect`, whose messages are `D`.
#[derive(Clone, Copy, Debug)]
pub struct CoreDialect<D>(PhantomData<fn() -> D>);

impl<D: Dialect> CoreDialect<D> {
    /// The dialect; it has no state.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<D: Dialect> Default for CoreDialect<D> {
    fn default() -> Self {
        Self::new()
    }
}

impl<D: Dialect> ::mavlink_core::Dialect for CoreDialect<D> {
    type Message = D;
    type EncodeError = EncoderError;

    fn message_id(&self, message: &D) -> u32 {
        message.info().id
    }

    fn extra_crc(&self, id: u32) -> Option<u8> {
        D::TABLE.get(id).map(|info| info.crc_extra)
    }

    fn decode(&self, _: MavlinkVersion, id: u32, payload: &[u8]) -> Result<D, ParserError> {
        parse(id, payload)
    }

    fn encode(&self, version: MavlinkVersion, message: &D, payload: &mut [u8]) -> Result<usize, EncoderError> {
        let MessageInfo { id, .. } = *message.info();
        if version == MavlinkVersion::V1 && id > 255 {
            // Unknown to MAVLink 1; mavlink-core has no better word.
            return Err(EncoderError::UnknownMessage { id });
        }
        let (mut buffer, maximum) = ([0; MAX_PAYLOAD], payload.len());
        let written = message.payload(version.into(), &mut buffer);
        match payload.get_mut(..written.len()) {
            Some(place) => place.copy_from_slice(written),
            None => return Err(EncoderError::InvalidPayloadSize { id, maximum, actual: written.len() }),
        }
        Ok(written.len())
    }
}

impl From<MavlinkVersion> for Version {
    fn from(version: MavlinkVersion) -> Self {
        match version {
            MavlinkVersion::V1 => Self::V1,
            MavlinkVersion::V2 => Self::V2,
        }
    }
}

/// Implements `mavlink_core::Message`.
#[doc(hidden)]
#[macro_export]
macro_rules! __mavlink_core {
    ($dialect:ident { $($message:ident)* }) => {
        impl $crate::interop::Targets for $dialect {
            fn target_mut(
                &mut self,
            ) -> (::core::option::Option<&mut u8>, ::core::option::Option<&mut u8>) {
                match self {
                    $(Self::$message(message) => $crate::Message::target_mut(message),)*
                }
            }
        }

        impl $crate::interop::mavlink_core::Message for $dialect {
            fn message_id(&self) -> u32 {
                $crate::Encode::info(self).id
            }

            fn message_name(&self) -> &'static str {
                $crate::Encode::info(self).name
            }

            fn target_system_id(&self) -> ::core::option::Option<u8> {
                $crate::interop::target(self, $crate::Encode::info(self).target_system)
            }

            fn target_component_id(&self) -> ::core::option::Option<u8> {
                $crate::interop::target(self, $crate::Encode::info(self).target_component)
            }

            fn target_system_id_mut(&mut self) -> ::core::option::Option<&mut u8> {
                $crate::interop::Targets::target_mut(self).0
            }

            fn target_component_id_mut(&mut self) -> ::core::option::Option<&mut u8> {
                $crate::interop::Targets::target_mut(self).1
            }

            fn ser(&self, version: $crate::interop::mavlink_core::MavlinkVersion, bytes: &mut [u8]) -> usize {
                $crate::interop::write(self, version, bytes)
            }

            fn parse(
                _: $crate::interop::mavlink_core::MavlinkVersion,
                id: u32,
                payload: &[u8],
            ) -> ::core::result::Result<Self, $crate::interop::mavlink_core::error::ParserError> {
                $crate::interop::parse(id, payload)
            }

            fn message_id_from_name(name: &str) -> ::core::option::Option<u32> {
                $crate::interop::id_of::<Self>(name)
            }

            fn default_message_from_id(id: u32) -> ::core::option::Option<Self> {
                $(if id == <$message as $crate::Message>::ID {
                    return ::core::option::Option::Some(Self::$message(<$message as $crate::Message>::DEFAULT));
                })*
                ::core::option::Option::None
            }

            $crate::__random_message!();

            fn extra_crc(id: u32) -> u8 {
                $crate::interop::crc_extra::<Self>(id)
            }
        }
    };
}

/// The method that the trait has when `mavlink-core/arbitrary` is on.
#[cfg(feature = "arbitrary")]
#[doc(hidden)]
#[macro_export]
macro_rules! __random_message {
    () => {
        fn random_message_from_id<R>(id: u32, random: &mut R) -> ::core::option::Option<Self>
        where
            R: $crate::interop::rand_core::TryRng<Error = ::core::convert::Infallible>,
        {
            $crate::interop::random(id, random)
        }
    };
}

#[cfg(not(feature = "arbitrary"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __random_message {
    () => {};
}

/// [`Message::target_mut`](crate::Message::target_mut) of whatever message there is.
#[doc(hidden)]
pub trait Targets {
    /// The fields with the ids of the addressed system and component.
    fn target_mut(&mut self) -> (Option<&mut u8>, Option<&mut u8>);
}

/// The byte at the offset of a target field.
#[doc(hidden)]
pub fn target(message: &dyn Encode, offset: Option<u8>) -> Option<u8> {
    let mut payload = [0; MAX_PAYLOAD];
    message.write(&mut payload);
    payload.get(usize::from(offset?)).copied()
}

/// Writes a payload as it is sent, as far as there is room.
#[doc(hidden)]
pub fn write(message: &dyn Encode, version: MavlinkVersion, bytes: &mut [u8]) -> usize {
    let mut buffer = [0; MAX_PAYLOAD];
    let payload = message.payload(version.into(), &mut buffer);
    bytes.iter_mut().zip(payload).map(|(to, from)| *to = *from).count()
}

#[doc(hidden)]
pub fn parse<D: Dialect>(id: u32, payload: &[u8]) -> Result<D, ParserError> {
    D::decode(id, payload).ok_or(ParserError::UnknownMessage { id })
}

#[doc(hidden)]
pub fn id_of<D: Dialect>(name: &str) -> Option<u32> {
    D::TABLE.iter().find(|info| info.name == name).map(|info| info.id)
}

/// Zero for an unknown message, as the trait's other implementations give.
#[doc(hidden)]
pub fn crc_extra<D: Dialect>(id: u32) -> u8 {
    D::TABLE.get(id).map_or(0, |info| info.crc_extra)
}

/// A message of any payload.
#[cfg(feature = "arbitrary")]
#[doc(hidden)]
pub fn random<D: Dialect, R>(id: u32, random: &mut R) -> Option<D>
where
    R: ::rand_core::TryRng<Error = core::convert::Infallible>,
{
    let mut payload = [0; MAX_PAYLOAD];
    let Ok(()) = random.try_fill_bytes(&mut payload);
    D::decode(id, &payload)
}
