//! Who was heard.

use std::net::SocketAddr;
use std::vec::Vec;

/// A bounded list of addresses, the one that was heard last in front.
#[derive(Clone, Debug)]
pub(super) struct Peers {
    addresses: Vec<SocketAddr>,
    limit: usize,
}

impl Peers {
    pub(super) const fn new(limit: usize) -> Self {
        Self { addresses: Vec::new(), limit }
    }

    /// Puts this address in front; the last one goes if there is no room.
    pub(super) fn hear(&mut self, address: SocketAddr) {
        match self.addresses.iter().position(|known| *known == address) {
            Some(0) => {}
            Some(place) => {
                if let Some(others) = self.addresses.get_mut(..=place) {
                    others.rotate_right(1);
                }
            }
            None => {
                self.addresses.truncate(self.limit.saturating_sub(1));
                if self.limit > 0 {
                    self.addresses.insert(0, address);
                }
            }
        }
    }

    pub(super) fn iter(&self) -> impl ExactSizeIterator<Item = SocketAddr> + use<'_> {
        self.addresses.iter().copied()
    }
}
