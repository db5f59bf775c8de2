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

pub(crate) mod message;

use core::marker::PhantomData;
use std::io;

use ::mavlink_core::error::{EncoderError, ParserError};
use ::mavlink_core::{DialectConnection, MavConnection, MavlinkVersion};

use message::parse;

use crate::{Dialect, MAX_PAYLOAD, MessageInfo, Version};

/// Connects to the address, like `mavlink_core::connect`: `udpin:0.0.0.0:14550`, `tcpout:host:5760`, `serial:/dev/ttyUSB0:57600`,
/// `file:flight.tlog` …, as far as the features of `mavlink-core` go.
///
/// It receives MAVLink 1 and 2, where `mavlink_core::connect` receives only what it sends, MAVLink 2: an AutoQuad speaks
/// MAVLink 1. A connection that is made without this function does the same after `set_allow_recv_any_version(true)`. What it
/// sends is MAVLink 2, until `set_protocol_version` says otherwise.
///
/// Messages that MAVLink 1 cannot carry are refused by `send` with `MessageWriteError::Encode`, where the connection of
/// `mavlink_core::connect` panics.
///
/// # Errors
/// Those of the address, of kind `AddrNotAvailable`, and those of the system.
pub fn connect<D: Dialect>(address: &str) -> io::Result<DialectConnection<CoreDialect<D>>> {
    let mut connection = ::mavlink_core::connect_with_dialect(address, CoreDialect::new())?;
    connection.set_allow_recv_any_version(true);
    Ok(connection)
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
