//! Heartbeats: who is there, what it is, and when it is gone.
//!
//! Every component sends them with [`Beacon`], a station as well. [`Monitor`] watches those of others.

mod beacon;
mod monitor;

pub use beacon::{Beacon, NoHeartbeat};
pub use monitor::{Event, Monitor, Peer};
