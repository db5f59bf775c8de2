//! MAVLink frames: a parser, a sender, links, logs, and the traits that generated dialects implement.
//!
//! The core is sans-io: bytes in, frames out. You carry the bytes (a UART, a socket, a log), or one of the adapters does that
//! features add. Only these adapters allocate or block. Nothing panics. The messages come from a dialect crate, or from
//! `mavgen` in your own build script.
//!
//! To open a UDP, TCP or serial address in one line, use the module `link` (feature `std`).
//!
//! # Receiving
//!
//! A [`Parser`] takes bytes as they come, cut anywhere, and returns [`Frame`]s: views of bytes whose checksum was verified. A
//! [`Table`] lists the messages that it can verify, those of a whole dialect or the few that you need:
//!
//! ```
//! # use mavlink_wire as wire;
//! # #[derive(Clone, Copy, Debug, PartialEq)]
//! # struct SystemTime { time_unix_usec: u64, time_boot_ms: u32 }
//! # impl wire::Message for SystemTime {
//! #     type Payload = [u8; 12];
//! #     const INFO: &'static wire::MessageInfo = &wire::MessageInfo::new(2, "SYSTEM_TIME", 137, 12);
//! #     const FIELDS: &'static [wire::FieldInfo] = &[];
//! #     const DEFAULT: Self = Self { time_unix_usec: 0, time_boot_ms: 0 };
//! #     fn read(p: &[u8; 12]) -> Self { Self { time_unix_usec: get(p, 0), time_boot_ms: get(p, 8) } }
//! #     fn store(&self, p: &mut [u8; 12]) { put(p, 0, self.time_unix_usec); put(p, 8, self.time_boot_ms); }
//! # }
//! # use wire::generated::{get, put};
//! use mavlink_wire::{MAX_FRAME, Message, Parser, Sender, Table};
//!
//! static WANTED: Table = Table::of(&[SystemTime::INFO]);
//!
//! let (mut tx, mut buffer) = (Sender::v2(1, 1), [0; MAX_FRAME]);
//! let sent = tx.encode(&SystemTime { time_boot_ms: 1500, ..SystemTime::DEFAULT }, &mut buffer)?;
//!
//! let mut rx = Parser::new(&WANTED);
//! let mut received = vec![];
//! for mut chunk in sent.chunks(7) {
//!     while let Some(frame) = rx.next(&mut chunk) {
//!         received.extend(frame.decode::<SystemTime>());
//!     }
//! }
//! assert_eq!(received, [SystemTime { time_unix_usec: 0, time_boot_ms: 1500 }]);
//! # Ok::<_, wire::EncodeError>(())
//! ```
//!
//! - You also get frames of messages that the table does not have, to forward them ([`Frame::bytes`]). Then
//!   [`Frame::is_verified`] is false.
//! - [`Frame::decode`] returns one message type, [`Frame::message`] a dialect's enum of all messages.
//!   [`Frame::decode_into`] does the same without moving the message, which is faster.
//! - Decoding is total. A payload may be shorter than its message (MAVLink 2 drops trailing zeros) or longer (a newer
//!   sender); enum values and flags that the definition does not name survive.
//! - Messages print as their fields say, with units and the names of entries; `SETUP_SIGNING` without its key.
//! - [`Frame::reflect`] needs no message type: it returns names, values and units, for routers and loggers ([`reflect`]).
//! - [`Parser::statistics`] counts frames and damaged bytes, [`Losses`] the frames that never arrived.
//!   [`Parser::next_reporting_bad_checksums`] also says which message has a wrong checksum. It shows that both sides define a
//!   message differently.
//!
//! # Sending
//!
//! One [`Sender`] per link numbers the frames and writes each into a buffer of yours. Prefer `..Message::DEFAULT` to naming
//! every field, because definitions grow.
//!
//! A command of `MAV_CMD` is a type with its params as fields ([`Command`]): [`Command::long`] makes the `COMMAND_LONG` that carries
//! it, [`Command::int`] the `COMMAND_INT`.
//!
//! # Forwarding
//!
//! [`Frame::bytes`] are the received bytes, unchanged. A [`FrameBuf`] keeps a frame for a queue, and can change its sequence
//! number or remove its signature; [`Sender::renumber`] makes it the next frame of a link. A router also forwards messages that
//! its table does not have; it cannot check those for damage. [`Routes`] says which links a frame goes to.
//!
//! ```
//! # use mavlink_wire::{MessageInfo, Table};
//! # const HEARTBEAT: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
//! # let bytes = [0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];
//! # static TABLE: Table<'static> = Table::of(&[HEARTBEAT]);
//! # let mut chunk = &bytes[..];
//! use mavlink_wire::{Losses, Parser};
//!
//! let (mut rx, mut losses, mut radio) = (Parser::new(&TABLE), Losses::<8>::new(), vec![]);
//! while let Some(frame) = rx.next(&mut chunk) {
//!     losses.count(&frame);
//!     if !frame.carries_key() {
//!         radio.extend_from_slice(frame.bytes());
//!     }
//! }
//! # assert_eq!((&radio[..], losses.total().received), (&bytes[..], 1));
//! ```
//!
//! # Flash
//!
//! A program contains only what it uses: a [`Table`] has only the messages that it lists, names and field tables are dropped if
//! nothing prints them, and no panic is reachable. A receiver of two messages with [`Parser`] takes
//! 2.9 kB of code and constants on x86-64 without `fast-crc`, built for size (`opt-level = "z"`, fat LTO). A fifth of that
//! handles frames of unknown messages, and a fifth bounds the work that hostile bytes can cause.
//! `tests/no-std/size.sh` in the repository measures and limits it.
//!
//! # Modules
//!
//! The common types are at the root; [`prelude`] has the traits. [`generated`] is only for generated code.
//!
//! # Features
//!
//! - `fast-crc` (default): more speed for more flash. The checksum uses a table of 8 KiB, and whole frames are not copied.
//!   Without it, the checksum takes a few instructions per byte, and all bytes go through the parser's own buffer: see
//!   [Flash](#flash). The frames are the same.
//! - `std`: links to addresses of UDP, TCP and files (module `link`); frames over `std::io` (`io`), over a UDP socket of yours
//!   (`udp`), and in log files ([`tlog`], a part of which works without `std`).
//! - `serial`: links over serial ports.
//! - `tokio`: links for async tasks (`link::tokio`). `tokio-serial`: the same over serial ports.
//! - `tokio-codec`: a codec for `tokio_util::codec` (`tokio_codec`).
//! - `embedded-io`, `embedded-io-async`: frames over the traits of these crates (modules of the same names).
//! - `signing`: makes and verifies signatures, in the module `signing`. Without it, you can only read them
//!   ([`Frame::signature`]).
//! - `serde`: messages, enums, flags, [`Chars`] and dialects serialize without losing a bit, by names in text formats. So do
//!   frames, ids and counters. The module `serde` says how.
//! - `defmt`: `Format` of the same, and of errors. It uses the field tables and sends the names of fields and entries as text, so
//!   that a type that is never logged costs no flash.
//! - `arbitrary`: `Arbitrary` of messages, enums, flags, [`Chars`] and dialects, for fuzzing: any payload decodes.
//! - `bitflags`: `bitflags::Flags` of flags types, for code that works on any.
//! - `uorb`: PX4's uORB messages, in ULog files and CDR (module `uorb`).
//! - `mavlink-core`: a dialect over the connections of rust-mavlink; the module `interop` says how.

#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

#[cfg(any(feature = "std", test))]
extern crate std;

mod adapters;
mod error;
mod frame;
pub mod generated;
mod glue;
#[cfg(feature = "std")]
pub mod link;
mod log;
mod message;
mod parser;
pub mod prelude;
pub mod reflect;
mod routes;
mod seek;
mod sender;
#[cfg(feature = "signing")]
pub mod signing;
#[cfg(feature = "uorb")]
pub mod uorb;

#[cfg(feature = "embedded-io")]
pub use adapters::embedded_io;
#[cfg(feature = "embedded-io-async")]
pub use adapters::embedded_io_async;
#[cfg(feature = "tokio-codec")]
pub use adapters::tokio_codec;
#[cfg(feature = "std")]
pub use adapters::{io, udp};
pub use error::{EncodeError, FrameError, OutOfRange, TooLong, UnknownName, ViewError};
pub(crate) use frame::header;
pub use frame::{ComponentId, Frame, FrameBuf, Signature, SystemId, Timestamp, Version, crc};
#[cfg(feature = "mavlink-core")]
pub use glue::interop;
#[doc(hidden)]
#[allow(unused_imports, unreachable_pub, reason = "every feature may be on")]
pub use glue::optional::*;
#[cfg(feature = "serde")]
pub use glue::serde;
pub use log::tlog;
pub use message::{
    CarriesInt, CarriesLong, Chars, Command, CommandError, Dialect, Encode, Enum, EnumInfo, FieldInfo, Invalid, Kind,
    Message, MessageInfo, ParamError, ParamInfo, Params, Payload, Repr, Sentinel, Targeted, flags,
};
pub use parser::{Arrival, Losses, Parser, Received, Statistics, Table};
pub use routes::{LinkNumbers, Links, Routes};
pub use sender::Sender;

/// Bytes of the longest frame: MAVLink 2, signed.
pub const MAX_FRAME: usize = 280;

/// Bytes of the longest payload.
pub const MAX_PAYLOAD: usize = 255;
