//! Stations over a link: the machines, a clock and a [`Link`](mavlink_wire::link::Link).

mod error;
mod session;
mod station;
#[cfg(feature = "tokio")]
pub(crate) mod tokio;
mod until;
mod verbs;

use mavlink_wire::link::LinkError;

pub use error::Error;
pub use session::Patience;
pub use station::Station;

/// The ids of a ground station, unless it has others.
const STATION: (u8, u8) = (255, 190);

/// What finds no room in the buffer is lost, as on the air, and is asked for again.
fn unless_full(sent: Result<(), LinkError>) -> Result<(), Error> {
    match sent {
        Ok(()) | Err(LinkError::Full) => Ok(()),
        Err(error) => Err(error.into()),
    }
}
