//! Tests of the runtime from outside, over a dialect of three messages.

#![expect(clippy::indexing_slicing, clippy::unwrap_used, reason = "a failing test panics")]

mod checksum;
mod errors;
mod flags_interface;
mod forwarding;
mod hostile;
mod hygiene;
#[cfg(feature = "mavlink-core")]
mod interop;
mod known_frames;
#[cfg(feature = "std")]
mod links;
mod losses;
mod metadata;
mod reflection;
mod routes;
#[cfg(feature = "serde")]
mod serde;
#[cfg(feature = "signing")]
mod signing;
mod small;
mod statistics;
mod streams;
mod text;
mod tlog;
mod unknown;
mod values;
