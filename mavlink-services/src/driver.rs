//! Stations over a link: the machines, a clock and a [`Link`](mavlink_wire::link::Link).

mod error;
mod session;
mod station;
#[cfg(feature = "tokio")]
pub(crate) mod tokio;
mod until;
mod verbs;

pub use error::Error;
pub use session::Patience;
pub use station::Station;

/// The ids of a ground station, unless it has others.
const STATION: (u8, u8) = (255, 190);
