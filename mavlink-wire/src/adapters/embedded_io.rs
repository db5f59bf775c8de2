//! Frames over the traits of `embedded-io`: UARTs and sockets of firmware that waits. Needs the feature `embedded-io`.
//!
//! ```
//! # use mavlink_wire::{Encode, MessageInfo, Sender, Table};
//! # const INFO: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
//! # struct Heartbeat;
//! # impl Encode for Heartbeat {
//! #     fn info(&self) -> &'static MessageInfo { INFO }
//! #     fn write(&self, payload: &mut [u8; 255]) { payload[..9].copy_from_slice(&[0, 0, 0, 0, 6, 8, 0, 4, 3]); }
//! # }
//! # static TABLE: Table<'static> = Table::of(&[INFO]);
//! use mavlink_wire::embedded_io::{FrameReader, FrameWriter, ReceiveError, SendError};
//!
//! fn talk<E>(
//!     rx: impl embedded_io::Read<Error = E>,
//!     tx: impl embedded_io::Write<Error = E>,
//! ) -> Result<(), SendError<E>> {
//!     let (mut reader, mut writer) = (FrameReader::new(rx, &TABLE), FrameWriter::new(tx, Sender::v1(1, 1)));
//!     loop {
//!         match reader.receive() {
//!             Ok(Some(frame)) if frame.message_id() == 0 => writer.send(&Heartbeat)?,
//!             Ok(Some(_)) | Err(ReceiveError::NothingYet) => {}
//!             Ok(None) => return Ok(()),
//!             Err(ReceiveError::Link(error)) => return Err(SendError::Link(error)),
//!         }
//!     }
//! }
//! ```
//!
//! # Timeouts
//!
//! [`ErrorKind::TimedOut`] is handed on and loses nothing: read again later. A writer keeps what the link did not take of a
//! frame, and writes it first the next time, so that no frame is torn. [`ErrorKind::Interrupted`] is tried again at once.
//!
//! A timeout is that of the link, for the next byte. While bytes come that make no frame, as at a wrong baud rate, a reader
//! goes on reading, but no further than 64 KiB: then it says [`ReceiveError::NothingYet`], so that its caller can look at the
//! clock.

use ::embedded_io::{Error, ErrorKind, Read, Write};

use crate::adapters::embedded::{frames, is_interrupted};
use crate::adapters::incoming::{ENOUGH, Incoming};
use crate::adapters::outgoing::Outgoing;
use crate::parser::not_told;
use crate::{Encode, Frame, Sender, Statistics, Table};

pub use crate::adapters::embedded::{ReceiveError, SendError};

frames! {}
