//! Who sends bytes, and what is waited for from each.

use std::time::{Duration, Instant};
use std::vec::Vec;

use super::{Peer, Peers};
use crate::adapters::incoming::Found;
use crate::{Frame, Parser, Statistics, Table};

/// Parsers that are kept for those who are no peers.
const STRANGERS: usize = 16;

/// Who sent bytes lately.
#[derive(Clone, Debug)]
pub(super) struct Sources<'t> {
    table: &'t Table<'t>,
    sources: Vec<Source<'t>>,
    /// What was found in the bytes of those that are forgotten.
    forgotten: Statistics,
}

/// Where bytes come from: a stream of its own, whose frames may be cut anywhere.
#[derive(Clone, Debug)]
struct Source<'t> {
    peer: Peer,
    parser: Parser<'t>,
    /// When its last bytes came.
    received: Instant,
    /// It has been silent: what its parser holds is to be searched without waiting for more.
    giving_up: bool,
}

impl<'t> Sources<'t> {
    pub(super) const fn new(table: &'t Table<'t>) -> Self {
        Self { table, sources: Vec::new(), forgotten: Statistics::NONE }
    }

    /// Bytes have come from there.
    pub(super) fn receive(&mut self, peer: Peer, peers: &Peers, now: Instant) {
        if let Some(source) = self.sources.iter_mut().find(|source| source.peer == peer) {
            source.received = now;
            return;
        }
        self.make_room(peers, now);
        self.sources.push(Source { peer, parser: Parser::new(self.table), received: now, giving_up: false });
    }

    /// Forgets of those that are no peers the one that was silent for longest, if there are enough.
    fn make_room(&mut self, peers: &Peers, now: Instant) {
        let strangers = self.sources.iter().filter(|source| !peers.is_peer(source.peer, now));
        if strangers.clone().count() < STRANGERS {
            return;
        }
        if let Some(peer) = strangers.min_by_key(|source| source.received).map(|source| source.peer) {
            self.remove(peer);
        }
    }

    /// Forgets what came from there.
    pub(super) fn remove(&mut self, peer: Peer) {
        if let Some(place) = self.place_of(peer) {
            let source = self.sources.remove(place);
            self.forgotten = self.forgotten.plus(source.parser.statistics());
        }
    }

    pub(super) fn parser(&mut self, place: usize) -> Option<&mut Parser<'t>> {
        self.sources.get_mut(place).map(|source| &mut source.parser)
    }

    pub(super) fn place_of(&self, peer: Peer) -> Option<usize> {
        self.sources.iter().position(|source| source.peer == peer)
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
    pub(super) fn frame<'f>(&'f self, place: usize, found: &Found, used: &'f [u8]) -> Option<(Frame<'f>, Peer)> {
        self.sources.get(place).map(|source| (found.frame(&source.parser, used), source.peer))
    }

    /// What was found in all bytes.
    pub(super) fn statistics(&self) -> Statistics {
        self.sources.iter().fold(self.forgotten, |sum, source| sum.plus(source.parser.statistics()))
    }
}
