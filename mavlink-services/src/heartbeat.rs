//! Heartbeats: who is there, what it is, and when it is gone.
//!
//! Everybody sends them, a station as well: [`Beacon`]. [`Monitor`] watches those of others.

mod beacon;
mod monitor;

pub use beacon::{Beacon, NoHeartbeat};
pub use monitor::{Event, Monitor, Peer};
