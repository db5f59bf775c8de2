//! What optional features add to messages, enums, flags and frames: the traits of other crates.

#[cfg(feature = "arbitrary")]
pub mod arbitrary;
#[cfg(feature = "bitflags")]
mod bitflags;
#[cfg(feature = "defmt")]
pub mod defmt;
#[cfg(feature = "mavlink-core")]
pub mod interop;
pub(crate) mod optional;
#[cfg(feature = "serde")]
pub mod serde;
