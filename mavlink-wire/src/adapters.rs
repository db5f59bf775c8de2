//! Frames over something that carries bytes: each module a thin adapter behind a feature.

#[cfg(any(feature = "std", feature = "embedded-io", feature = "embedded-io-async"))]
pub(crate) mod chunk;
#[cfg(all(feature = "std", feature = "signing"))]
pub(crate) mod clock;
#[cfg(any(feature = "embedded-io", feature = "embedded-io-async"))]
mod embedded;
#[cfg(feature = "embedded-io")]
pub mod embedded_io;
#[cfg(feature = "embedded-io-async")]
pub mod embedded_io_async;
#[cfg(any(feature = "std", feature = "embedded-io", feature = "embedded-io-async"))]
mod frame_reader;
#[cfg(any(feature = "std", feature = "embedded-io", feature = "embedded-io-async"))]
mod frame_writer;
#[cfg(any(feature = "std", feature = "embedded-io", feature = "embedded-io-async"))]
pub(crate) mod incoming;
#[cfg(feature = "std")]
pub mod io;
#[cfg(any(feature = "std", feature = "embedded-io", feature = "embedded-io-async"))]
mod outgoing;
#[cfg(feature = "std")]
pub(crate) mod pause;
#[cfg(feature = "tokio-codec")]
pub mod tokio_codec;
#[cfg(feature = "std")]
pub mod udp;
