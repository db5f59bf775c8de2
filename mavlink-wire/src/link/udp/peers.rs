//! Who sends datagrams, and who of them is a peer.

use core::cmp::Reverse;
use std::net::SocketAddr;
use std::time::{Duration, Instant};
use std::vec::Vec;

use crate::link::incoming::Found;
use crate::{Frame, Parser, Statistics, Table, Version};

/// Parsers that are kept for those who are no peers.
const STRANGERS: usize = 16;

/// Who sent datagrams lately.
#[derive(Clone, Debug)]
pub(super) struct Peers<'t> {
    table: &'t Table<'t>,
    /// Peers at most.
    pub(super) limit: usize,
    /// So long after its last verified frame one is a peer.
    pub(super) expiry: Duration,
    sources: Vec<Source<'t>>,
    /// What was found in datagrams of those that are forgotten.
    forgotten: Statistics,
}

/// An address that datagrams come from: a stream of its own, whose frames may be cut anywhere.
#[derive(Clone, Debug)]
pub(super) struct Source<'t> {
    address: SocketAddr,
    pub(super) parser: Parser<'t>,
    /// When its last datagram came.
    received: Instant,
    /// When its last verified frame came, if it is a peer or was one.
    verified: Option<Instant>,
    /// MAVLink 2, once it has sent that.
    version: Version,
    /// It has been silent: what its parser holds is to be searched without waiting for more.
    giving_up: bool,
}

/// Somebody to be answered, and in which version.
#[derive(Clone, Copy)]
pub(super) struct Peer {
    pub(super) address: SocketAddr,
    pub(super) version: Version,
}

impl<'t> Peers<'t> {
    pub(super) const fn new(table: &'t Table<'t>, limit: usize, expiry: Duration) -> Self {
        Self { table, limit, expiry, sources: Vec::new(), forgotten: Statistics::NONE }
    }

    fn is_peer(&self, source: &Source<'_>, now: Instant) -> bool {
        source.verified.is_some_and(|verified| now.saturating_duration_since(verified) < self.expiry)
    }

    /// The peers, the one that was heard last in front.
    pub(super) fn peers(&self, now: Instant) -> Vec<Peer> {
        let mut peers: Vec<_> = self.sources.iter().filter(|source| self.is_peer(source, now)).collect();
        peers.sort_by_key(|source| Reverse(source.verified));
        peers.iter().map(|source| Peer { address: source.address, version: source.version }).collect()
    }

    /// In which version this peer is spoken to.
    pub(super) fn version_of(&self, address: SocketAddr, now: Instant) -> Option<Version> {
        let source = self.sources.iter().find(|source| source.address == address)?;
        self.is_peer(source, now).then_some(source.version)
    }

    /// A datagram has come from this address.
    pub(super) fn receive(&mut self, address: SocketAddr, now: Instant) {
        if let Some(source) = self.sources.iter_mut().find(|source| source.address == address) {
            source.received = now;
            return;
        }
        self.make_room(now);
        self.sources.push(Source {
            address,
            parser: Parser::new(self.table),
            received: now,
            verified: None,
            version: Version::V1,
            giving_up: false,
        });
    }

    /// Forgets of those that are no peers the one that was silent for longest, if there are enough.
    fn make_room(&mut self, now: Instant) {
        let strangers = self.sources.iter().filter(|source| !self.is_peer(source, now));
        if strangers.clone().count() < STRANGERS {
            return;
        }
        if let Some(address) = strangers.min_by_key(|source| source.received).map(|source| source.address) {
            self.remove(address);
        }
    }

    /// Forgets an address; whether it was a peer.
    pub(super) fn remove(&mut self, address: SocketAddr) -> bool {
        let now = Instant::now();
        let Some(place) = self.sources.iter().position(|source| source.address == address) else { return false };
        let source = self.sources.remove(place);
        self.forgotten = self.forgotten.plus(source.parser.statistics());
        self.is_peer(&source, now)
    }

    pub(super) fn at_mut(&mut self, place: usize) -> Option<&mut Source<'t>> {
        self.sources.get_mut(place)
    }

    pub(super) fn place_of(&self, address: SocketAddr) -> Option<usize> {
        self.sources.iter().position(|source| source.address == address)
    }

    /// A verified frame of this version has come from there: it is a peer, if it was one or there is room for one more.
    pub(super) fn hear(&mut self, place: usize, version: Version, now: Instant) {
        let peers = self.sources.iter().filter(|source| self.is_peer(source, now)).count();
        let Some(source) = self.sources.get(place) else { return };
        if !self.is_peer(source, now) && peers >= self.limit {
            return;
        }
        if let Some(source) = self.sources.get_mut(place) {
            source.verified = Some(now);
            source.version = source.version.max(version);
        }
    }

    /// Whether some parser waits for the rest of a frame.
    pub(super) fn are_waiting(&self) -> bool {
        self.sources.iter().any(|source| source.parser.is_waiting())
    }

    /// Those that have been silent for so long are not waited for any more; whether there are some.
    pub(super) fn give_up(&mut self, silence: Duration, now: Instant) -> bool {
        let mut some = false;
        for source in &mut self.sources {
            if source.parser.is_waiting() && now.saturating_duration_since(source.received) >= silence {
                (source.giving_up, some) = (true, true);
            }
        }
        some
    }

    /// The next frame in what is not waited for any more, and the place of who sent it.
    pub(super) fn finish(&mut self, bad_checksum: &mut impl FnMut(u32)) -> Option<(usize, Found)> {
        for (place, source) in self.sources.iter_mut().enumerate().filter(|(_, source)| source.giving_up) {
            match Found::finish(&mut source.parser, bad_checksum) {
                Some(found) => return Some((place, found)),
                None => source.giving_up = false,
            }
        }
        None
    }

    /// The frame that was found there.
    pub(super) fn frame<'f>(&'f self, place: usize, found: &Found, used: &'f [u8]) -> Option<(Frame<'f>, SocketAddr)> {
        self.sources.get(place).map(|source| (found.frame(&source.parser, used), source.address))
    }

    /// What was found in all datagrams.
    pub(super) fn statistics(&self) -> Statistics {
        self.sources.iter().fold(self.forgotten, |sum, source| sum.plus(source.parser.statistics()))
    }
}
