//! The AutoQuad dialect of MAVLink, with the common, standard and minimal messages that it includes. It is typed, lossless,
//! `no_std`, without an allocator, and compared byte for byte with pymavlink.
//!
//! To open a UDP, TCP or serial address, use `wire::link` (feature `std`). For PX4's `EscStatus`, use `px4` (feature `px4`).
//!
//! # Receiving
//!
//! ```
//! use mavlink_autoquad::autoquad::{Autoquad, AqEscTelemetry, MavAutopilot};
//! use mavlink_autoquad::wire::{Dialect, Parser};
//!
//! # let bytes = [0xfd, 9, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x0a, 0x80];
//! let mut parser = Parser::new(Autoquad::TABLE);
//! let mut chunk: &[u8] = &bytes; // whatever came in, cut anywhere
//! while let Some(frame) = parser.next(&mut chunk) {
//!     match frame.message() {
//!         Some(Autoquad::Heartbeat(beat)) if beat.autopilot == MavAutopilot::AUTOQUAD => println!("an AutoQuad"),
//!         Some(Autoquad::AqEscTelemetry(AqEscTelemetry { seq, .. })) => println!("ESC batch {seq}"),
//!         Some(other) => println!("{other:?}"),
//!         None => println!("unknown message {}: {:02x?}", frame.message_id(), frame.bytes()),
//!     }
//! }
//! ```
//!
//! # Sending
//!
//! ```
//! use mavlink_autoquad::autoquad::{Heartbeat, MavComponent, MavState, MavType};
//! use mavlink_autoquad::wire::{EncodeError, MAX_FRAME, Message, Sender};
//!
//! const BEAT: Heartbeat =
//!     Heartbeat { r#type: MavType::QUADROTOR, system_status: MavState::ACTIVE, ..Heartbeat::DEFAULT };
//!
//! fn main() -> Result<(), EncodeError> {
//!     let (mut sender, mut buffer) = (Sender::v1(1, MavComponent::AUTOPILOT1), [0; MAX_FRAME]);
//!     let frame = sender.encode(&BEAT, &mut buffer)?;
//!     assert_eq!(frame[0], 0xfe);
//!     Ok(())
//! }
//! ```
//!
//! # Motor controllers
//!
//! AutoQuad packs the status of each ESC32 into 64 bits: [`AqEscTelemetry::escs`](autoquad::AqEscTelemetry::escs) reads them
//! in volts, amperes, rpm and degrees. [`esc`] collects the batches of four into a table of up to 16 controllers, and converts
//! it to the messages that current ground stations show.
//!
//! ```
//! use mavlink_autoquad::autoquad::{AqEscTelemetry, EscInfo, EscStatus};
//! use mavlink_autoquad::esc::{Conversion, EscTable};
//!
//! /// What a bridge sends for the first four motors.
//! fn convert(table: &mut EscTable, telemetry: &AqEscTelemetry) -> Option<(EscInfo, EscStatus)> {
//!     for esc in telemetry.escs() {
//!         match esc.status {
//!             Some(status) if status.voltage_mv() < 13_200 => println!("{}: {:.2} V is low", esc.id, status.voltage()),
//!             Some(_) => {}
//!             None => println!("{} is silent", esc.id),
//!         }
//!     }
//!     table.update(telemetry);
//!     let (now_us, options) = (table.uptime_us(), Conversion::DEFAULT);
//!     Some((table.to_esc_info(0, now_us, &options)?, table.to_esc_status(0, now_us, &options)?))
//! }
//! # use mavlink_autoquad::wire::Message;
//! # assert!(convert(&mut EscTable::new(), &AqEscTelemetry::DEFAULT).is_none());
//! ```
//!
//! # Commands
//!
//! With the feature `commands` (on by default), `autoquad::commands` has a type for each command, with its params by name. It is
//! sent in a `COMMAND_LONG` or a `COMMAND_INT`, and read from either.
//!
#![cfg_attr(feature = "commands", doc = "```")]
#![cfg_attr(not(feature = "commands"), doc = "```ignore")]
//! use mavlink_autoquad::autoquad::commands::AqTelemetry;
//! use mavlink_autoquad::autoquad::{CommandLong, MavBool};
//! use mavlink_autoquad::wire::{Command, CommandError};
//!
//! /// Asks the AutoQuad with system id 1 for a dataset, ten times a second.
//! fn ask() -> Result<CommandLong, CommandError> {
//!     AqTelemetry { on: MavBool::TRUE, interval: 100_000.0, ..AqTelemetry::DEFAULT }.long(1, 1)
//! }
//! # assert_eq!(ask().map(|long| long.param2), Ok(100_000.0));
//! ```
//!
//! # On firmware
//!
//! With `default-features = false`, cargo compiles the committed sources only: no work in the build script, no build
//! dependency, no types of commands unless you ask for them, and a checksum without a table. List only the messages that you
//! read in a [`wire::Table`]; all others then stay out of the flash:
//!
//! ```
//! use mavlink_autoquad::autoquad::{AqEscTelemetry, Heartbeat};
//! use mavlink_autoquad::wire::{Message, Parser, Table};
//!
//! static RECEIVED: Table<'static> = Table::of(&[Heartbeat::INFO, AqEscTelemetry::INFO]);
//! let parser = Parser::new(&RECEIVED);
//! # let _ = parser;
//! ```
//!
//! # What AutoQuad does differently
//!
//! * ArduPilot's dialect uses the message ids 150 and 152 for other messages. Their `crc_extra` differs, so neither is taken
//!   for the other. A bridge has to convert AutoQuad's, because current ground stations discard them.
//! * `time_boot_ms` of [`autoquad::AqEscTelemetry`] comes from a 32-bit microsecond counter: it wraps every 71 min 35 s.
//!   [`esc::UptimeClock`] goes on counting. In the messages of `common.xml` AutoQuad's firmware sends *micro*seconds in
//!   fields of that name.
//! * Array slots from `num_in_seq` on hold stale data.
//! * Motor telemetry has to be requested, with [`autoquad::RequestDataStream`] and `req_stream_id` 13
//!   ([`autoquad::MavDataStream::PROPULSION`]).
//! * The `.mavlink` logs of AutoQuad's QGroundControl look like tlogs but are not. Their times are little-endian, and every
//!   frame lacks its last eight bytes, checksum included (`MAVLinkProtocol.cc`, since December 2012). A parser finds no frame
//!   in them, but [`wire::tlog::salvage`] reads what is left. Of the motor telemetry, only the ids of the last two ESCs and the
//!   versions of all four are missing; you have to supply them:
//!
//! ```
//! use mavlink_autoquad::autoquad::{AqEscTelemetry, Autoquad};
//! use mavlink_autoquad::wire::tlog::salvage::records;
//! use mavlink_autoquad::wire::{Dialect, Message};
//!
//! # use mavlink_autoquad::autoquad::{Esc, Esc32Status};
//! # use mavlink_autoquad::wire::{MAX_FRAME, Sender};
//! # let mut sent = AqEscTelemetry { seq: 1, num_motors: 4, ..AqEscTelemetry::DEFAULT };
//! # for id in 1..=4 {
//! #     let mut status = Esc32Status::from_bits(0, 30);
//! #     status.set_voltage(15.0 + f32::from(id) / 4.0).unwrap();
//! #     sent.push_esc(Esc { id, age_ms: Some(5), status: Some(status) }).unwrap();
//! # }
//! # let mut buffer = [0; MAX_FRAME];
//! # let frame = Sender::v1(1, 1).encode(&sent, &mut buffer).unwrap();
//! # let log = [&1_400_000_000_000_000_u64.to_le_bytes()[..], &frame[..frame.len() - 8]].concat();
//! # let mut shown = Vec::new();
//! for record in records(&log, Autoquad::TABLE) {
//!     if (record.message_id(), record.payload().len()) == (Some(AqEscTelemetry::ID), 49) {
//!         let mut telemetry = AqEscTelemetry::decode(record.payload());
//!         telemetry.data_version = [30; 4];
//!         telemetry.escid[2..].copy_from_slice(&[3, 4]);
//!         for esc in telemetry.escs() {
//!             println!("{} µs: {} {:?}", record.time_us, esc.id, esc.status);
//! #           shown.push((esc.id, esc.status.unwrap().voltage_mv()));
//!         }
//!     }
//! }
//! # assert_eq!(shown, [(1, 15_250), (2, 15_500), (3, 15_750), (4, 16_000)]);
//! ```

#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
// What is documented is there either way: these say which sources it is made from.
#![cfg_attr(docsrs, doc(auto_cfg(hide(without_esc, feature = "generate"))))]

pub use mavlink_wire as wire;

#[cfg(not(without_esc))]
pub mod esc;
#[cfg(feature = "px4")]
pub mod px4;

#[cfg(feature = "generate")]
mavlink_wire::include_dialect!("autoquad");

/// The `autoquad` dialect: its messages, its enums, and [`autoquad::Autoquad`] over all messages.
#[cfg(not(feature = "generate"))]
#[rustfmt::skip]
#[path = "generated/mod.rs"]
pub mod autoquad;
