//! Who is at the other end.

use core::fmt;
use std::net::SocketAddr;

/// The other end of a link: a UDP or TCP address, the device behind a serial port, or the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Peer {
    address: Option<SocketAddr>,
}

impl Peer {
    /// Whoever is behind a cable, or in a file.
    pub(crate) const NEARBY: Self = Self { address: None };

    /// The address; `None` behind a serial port, and in a file.
    #[must_use]
    pub const fn address(&self) -> Option<SocketAddr> {
        self.address
    }
}

impl From<SocketAddr> for Peer {
    fn from(address: SocketAddr) -> Self {
        Self { address: Some(address) }
    }
}

/// `127.0.0.1:14550`, or `here`.
impl fmt::Display for Peer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.address {
            Some(address) => fmt::Display::fmt(&address, f),
            None => f.pad("here"),
        }
    }
}
