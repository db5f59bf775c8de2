//! From bytes that came to frames that are handed over: what every link does, however it waits.

use std::boxed::Box;
use std::io;
use std::net::SocketAddr;
use std::time::{Duration, Instant};
use std::vec;

use super::sources::Sources;
use super::{Peer, Peers};
use crate::adapters::chunk::Chunk;
#[cfg(feature = "signing")]
use crate::adapters::clock;
use crate::adapters::incoming::Found;
use crate::adapters::pause::is_passing;
#[cfg(feature = "signing")]
use crate::signing::{Trust, Verifier};
use crate::{Frame, Statistics, Table};

/// No datagram is longer.
pub(crate) const MAX_CHUNK: usize = 65_536;

/// Parsers, one for each that sends, and what says which frames to hand over.
#[derive(Debug)]
pub(crate) struct Inbox<'t> {
    sources: Sources<'t>,
    chunk: Chunk<Box<[u8]>>,
    /// Who sent the chunk, until it is used up.
    from: Option<Peer>,
    pub(crate) peers: Peers,
    /// How long the rest of a frame is waited for, while nothing comes.
    silence: Duration,
    #[cfg(feature = "signing")]
    pub(crate) verifier: Option<Verifier>,
    #[cfg(feature = "signing")]
    pub(crate) allow: fn(&Frame<'_>) -> bool,
    pub(crate) refused: u64,
}

/// A frame that is to be handed over, and the place of who sent it.
#[derive(Clone, Copy)]
pub(crate) struct Delivery {
    place: usize,
    found: Found,
}

impl<'t> Inbox<'t> {
    pub(crate) fn new(table: &'t Table<'t>, peers: Peers, silence: Duration) -> Self {
        Self {
            sources: Sources::new(table),
            chunk: Chunk::new(vec![0; MAX_CHUNK].into_boxed_slice()),
            from: None,
            peers,
            silence,
            #[cfg(feature = "signing")]
            verifier: None,
            #[cfg(feature = "signing")]
            allow: |frame| frame.is_of_radio(),
            refused: 0,
        }
    }

    /// The next frame to be handed over in what came; `None` if more has to come.
    pub(crate) fn find(&mut self, bad_checksum: &mut impl FnMut(u32)) -> Option<Delivery> {
        loop {
            let (place, found) = self.search(bad_checksum)?;
            if self.accept(place, &found) {
                return Some(Delivery { place, found });
            }
        }
    }

    /// The frame that was found last, and who sent it.
    pub(crate) fn frame(&self, delivery: &Delivery) -> Option<(Frame<'_>, Peer)> {
        self.sources.frame(delivery.place, &delivery.found, self.chunk.used())
    }

    /// Where to receive to, when nothing is found any more.
    pub(crate) fn space(&mut self) -> &mut [u8] {
        self.from = None;
        self.chunk.space()
    }

    /// Takes what was received there, after a wait of so long.
    pub(crate) fn fill(&mut self, length: usize, from: Peer, waited: Duration) {
        let now = Instant::now();
        // Only a wait shows that there was nothing: what came meanwhile may have lain in the socket.
        if waited >= self.silence {
            self.sources.give_up(self.silence, now);
        }
        self.chunk.fill(length);
        self.from = Some(from);
        self.sources.receive(from, &self.peers, now);
    }

    /// Takes a datagram that was received there, if any in time.
    pub(crate) fn take_datagram(
        &mut self,
        came: Option<io::Result<(usize, SocketAddr)>>,
        waited: Duration,
    ) -> io::Result<()> {
        match came {
            Some(Ok((length, from))) => self.fill(length, from.into(), waited),
            Some(Err(error)) if is_passing(&error) => {}
            Some(Err(error)) => return Err(error),
            None => drop(self.give_up()),
        }
        Ok(())
    }

    /// How long to wait at most before [`give_up`](Self::give_up) has something to do.
    pub(crate) fn patience(&self) -> Option<Duration> {
        self.sources.are_waiting().then_some(self.silence)
    }

    /// Does not wait any more for those who have been silent for long enough; whether there are some.
    pub(crate) fn give_up(&mut self) -> bool {
        self.sources.give_up(self.silence, Instant::now())
    }

    /// Waits for nobody any more: the stream has ended.
    pub(crate) fn end(&mut self) {
        self.sources.give_up(Duration::ZERO, Instant::now());
    }

    /// Forgets a peer, and what its parser holds; whether it was one.
    pub(crate) fn remove(&mut self, peer: Peer) -> bool {
        self.sources.remove(peer);
        self.peers.remove(peer, Instant::now())
    }

    /// What was found so far, and what could not be read.
    pub(crate) fn statistics(&self) -> Statistics {
        self.sources.statistics()
    }

    /// The next frame in what was received, and the place of who sent it.
    fn search(&mut self, bad_checksum: &mut impl FnMut(u32)) -> Option<(usize, Found)> {
        self.chunk.wipe_used_key();
        if let Some((place, found)) = self.sources.finish(bad_checksum) {
            self.chunk.found_key = found.carries_key();
            return Some((place, found));
        }
        let place = self.sources.place_of(self.from?)?;
        let found = self.chunk.find(self.sources.parser(place)?, bad_checksum);
        if found.is_none() {
            self.from = None;
        }
        found.map(|found| (place, found))
    }

    /// Whether a frame is to be handed over; makes a peer of who sent it.
    fn accept(&mut self, place: usize, found: &Found) -> bool {
        let Some((frame, peer)) = self.sources.frame(place, found, self.chunk.used()) else { return false };
        let (proven, version) = (frame.is_verified(), frame.version());
        #[cfg(feature = "signing")]
        let proven = match self.verifier.as_mut().map(|verifier| check(verifier, &frame, self.allow, &self.peers)) {
            None | Some(Some(Trust::Signed | Trust::Unchecked)) => proven,
            Some(Some(Trust::Allowed)) => false,
            Some(None) => {
                self.refused += 1;
                return false;
            }
        };
        if proven {
            self.peers.hear(peer, version, Instant::now());
        }
        true
    }
}

/// How far to trust a frame by the clock of the system; `None` if it is to be discarded.
#[cfg(feature = "signing")]
fn check(verifier: &mut Verifier, frame: &Frame<'_>, allow: fn(&Frame<'_>) -> bool, peers: &Peers) -> Option<Trust> {
    let trust = verifier.check_with(frame, clock::now(), allow).ok()?;
    peers.tell_time(verifier.timestamp());
    Some(trust)
}
