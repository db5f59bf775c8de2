//! MAVLink's protocols: what two components have to say to each other, as state machines, for any dialect that includes `common`.
//!
//! A machine does no io and has no clock: the caller gives it the frames that come and the time, and sends what it says. One shape
//! serves all of them, [`Service`]. Nothing allocates; where a protocol moves lists, the storage is the caller's.
//!
//! | protocol | station: who asks | component: who answers |
//! |---|---|---|
//! | [`heartbeat`] | [`Monitor`](heartbeat::Monitor), and a [`Beacon`](heartbeat::Beacon) of its own | [`Beacon`](heartbeat::Beacon) |
//! | [`command`] | [`Send`](command::Send), [`Fetch`](command::Fetch) | [`Component`](command::Component) |
//! | message [`interval`]s | [`set`](interval::set), [`Get`](interval::Get) | [`Streams`](interval::Streams) |
//! | [`mission`] | [`Upload`](mission::Upload), [`Download`](mission::Download), [`Clear`](mission::Clear), [`SetCurrent`](mission::SetCurrent) | [`Component`](mission::Component) |
//! | [`param`] | [`List`](param::List), [`Read`](param::Read), [`Write`](param::Write) | [`Component`](param::Component) |
//! | [`timesync`] | [`Measure`](timesync::Measure) | [`Responder`](timesync::Responder) |
//!
//! What a station asks for is a machine that ends, an [`Operation`]. Several may run at once.
//!
//! [`Vehicle`] is all that a component answers, as one machine. `Station` (feature `std`; `tokio::Station` for async tasks) runs the
//! operations of a station over a link: `station.set_param("RATE_P", 0.2)?`.
//!
//! ```
//! use mavlink_services::common::{CommandLong, MavCmd};
//! use mavlink_services::{Address, Instant, Output, Service, command};
//! use mavlink_wire::Message;
//!
//! let (own, peer, now) = (Address::new(255, 190), Address::new(1, 1), Instant::ZERO);
//! let arm = CommandLong { command: MavCmd::COMPONENT_ARM_DISARM, param1: 1.0, ..CommandLong::DEFAULT };
//! let mut arming = command::Send::new(own, peer, command::Options::DEFAULT, &arm, now)?;
//!
//! // What is to be sent, and until when nothing else happens unless a frame comes.
//! let Some(Output::Send(sent)) = arming.poll(now) else { panic!() };
//! assert_eq!(sent.decode::<CommandLong>().unwrap().target_system, 1);
//! assert!(arming.poll(now).is_none());
//! assert_eq!(arming.deadline(), Some(Instant::from_millis(1000)));
//! # Ok::<(), command::NoCommand>(())
//! ```
//!
//! # Bounds
//!
//! Every operation ends: done, refused by the peer with its reason, or timed out. A machine keeps what it is to send as flags, not
//! as a queue: whatever a peer sends, and however much of it, nothing grows and nothing stalls. Frames of others are no answers.
//!
//! # Messages of your dialect
//!
//! What goes in is any [`Encode`](mavlink_wire::Encode): a `CommandLong` of your dialect is the one of [`common`] to the byte. What
//! comes out are types of this crate, and messages of [`common`].
//!
//! # Features
//!
//! - `std`: `Station`, which blocks, over the links of `mavlink-wire`.
//! - `tokio`: `tokio::Station`, the same for async tasks.

#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

#[cfg(feature = "std")]
extern crate std;

mod address;
pub mod command;
/// The messages of `common` that the protocols are made of, as mavgen generates them; another dialect's are the same to the byte.
#[rustfmt::skip]
#[path = "generated/mod.rs"]
pub mod common;
#[cfg(feature = "std")]
mod driver;
pub mod heartbeat;
mod instant;
pub mod interval;
pub mod mission;
mod operation;
mod outgoing;
pub mod param;
mod retry;
mod service;
pub mod timesync;
#[cfg(feature = "tokio")]
pub mod tokio {
    //! Stations for async tasks.

    pub use crate::driver::tokio::Station;
}
pub mod vehicle;

pub use address::Address;
#[cfg(feature = "std")]
pub use driver::{Error, Patience, Station};
pub use instant::Instant;
pub use operation::{Operation, Update};
pub use outgoing::Outgoing;
pub(crate) use outgoing::convert;
pub use retry::Retry;
pub use service::{Output, Service, earliest};
pub use vehicle::Vehicle;
