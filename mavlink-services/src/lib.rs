//! MAVLink's protocols (microservices) as state machines, for any dialect that includes `common`.
//!
//! For a ground station on a computer, use `Station` (feature `std`; `tokio::Station` for async tasks): it runs the operations over
//! a link, as in `station.set_param("RATE_P", 0.2)?`. For a vehicle or another component, use [`Vehicle`], which answers all
//! protocols. Both are made of the machines in the table.
//!
//! A machine does no io and has no clock: the caller gives it received frames and the time, and sends the messages that it returns.
//! All machines implement [`Service`]. Nothing allocates; the caller provides the storage for lists.
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
//! A station's machines are [`Operation`]s, which end. Several may run at once.
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
//! // The message to send, and the time of the next poll if no frame comes before.
//! let Some(Output::Send(sent)) = arming.poll(now) else { panic!() };
//! assert_eq!(sent.decode::<CommandLong>().unwrap().target_system, 1);
//! assert!(arming.poll(now).is_none());
//! assert_eq!(arming.deadline(), Some(Instant::from_millis(1000)));
//! # Ok::<(), command::NoCommand>(())
//! ```
//!
//! # Bounds
//!
//! Every operation ends: done, refused by the peer with its reason, or timed out. A machine keeps what it has to send as flags, not
//! as a queue, so no peer can make it grow or stall. It ignores answers from other components than its peer.
//!
//! # Messages of your dialect
//!
//! You may pass any [`Encode`](mavlink_wire::Encode): a `CommandLong` of your dialect has the same bytes as that of [`common`]. The
//! machines return types of this crate, and messages of [`common`].
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
/// The messages of `common` that the protocols use, as mavgen generates them. Those of other dialects have the same bytes.
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
mod question;
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
