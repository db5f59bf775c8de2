//! Who else is there.

use core::time::Duration;

use mavlink_wire::Frame;

use crate::common::Heartbeat;
use crate::{Address, Instant, Output, Service, earliest};

/// Watches the heartbeats of up to `N` components.
///
/// ```text
///            a heartbeat            another content: Changed
///   Unknown ─────────────▶ Alive ──────────────────────────┐
///      ▲       Appeared    │   ▲                           │
///      │                   │   └───────────────────────────┘
///      └───────────────────┘
///       silence: Lost
/// ```
///
/// Whoever comes when all places are taken is not watched until one is free: a peer that makes heartbeats of 65,025 components can
/// do no more than that. Watch those you know ([`of`](Self::of)), and nobody else takes a place.
#[derive(Clone, Debug)]
pub struct Monitor<const N: usize = 16> {
    watched: Address,
    timeout: Duration,
    slots: [Option<Slot>; N],
}

/// A component that is there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peer {
    /// Who.
    pub address: Address,
    /// What it said last.
    pub heartbeat: Heartbeat,
    /// When.
    pub heard: Instant,
}

/// What a [`Monitor`] tells.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// It is there, for the first time or again.
    Appeared(Peer),
    /// Its heartbeat says something else: another mode, another state.
    Changed(Peer),
    /// It was silent for too long; this is what it said last.
    Lost(Peer),
}

#[derive(Clone, Copy, Debug)]
struct Slot {
    peer: Peer,
    news: Option<News>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum News {
    Appeared,
    Changed,
}

impl<const N: usize> Monitor<N> {
    /// Watches everybody; five seconds of silence are a loss.
    #[must_use]
    pub fn new() -> Self {
        Self::of(Address::EVERYBODY, Duration::from_secs(5))
    }

    /// Watches only these, zeros standing for all; so much silence is a loss.
    #[must_use]
    pub fn of(watched: Address, timeout: Duration) -> Self {
        Self { watched, timeout, slots: [None; N] }
    }

    /// Who is there.
    pub fn peers(&self) -> impl Iterator<Item = &Peer> {
        self.slots.iter().flatten().map(|slot| &slot.peer)
    }

    /// One of them.
    #[must_use]
    pub fn peer(&self, address: Address) -> Option<&Peer> {
        self.peers().find(|peer| peer.address == address)
    }

    fn is_lost(&self, peer: &Peer, now: Instant) -> bool {
        now >= peer.heard + self.timeout
    }
}

impl<const N: usize> Default for Monitor<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize> Service for Monitor<N> {
    type Event = Event;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        let address = Address::of(frame);
        let Some(heartbeat) = frame.decode::<Heartbeat>() else { return };
        if !self.watched.includes(address) {
            return;
        }
        let peer = Peer { address, heartbeat, heard: now };
        if let Some(slot) = self.slots.iter_mut().flatten().find(|slot| slot.peer.address == address) {
            if slot.peer.heartbeat != heartbeat {
                slot.news = slot.news.or(Some(News::Changed));
            }
            slot.peer = peer;
        } else if let Some(free) = self.slots.iter_mut().find(|slot| slot.is_none()) {
            *free = Some(Slot { peer, news: Some(News::Appeared) });
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Event>> {
        for at in 0..N {
            let Some(Some(slot)) = self.slots.get(at).copied() else { continue };
            let event = match slot.news {
                Some(News::Appeared) => Event::Appeared(slot.peer),
                Some(News::Changed) => Event::Changed(slot.peer),
                None if self.is_lost(&slot.peer, now) => Event::Lost(slot.peer),
                None => continue,
            };
            let left = if slot.news.is_some() { Some(Slot { news: None, ..slot }) } else { None };
            if let Some(place) = self.slots.get_mut(at) {
                *place = left;
            }
            return Some(Output::Event(event));
        }
        None
    }

    fn deadline(&self) -> Option<Instant> {
        self.peers().fold(None, |first, peer| earliest(first, Some(peer.heard + self.timeout)))
    }
}
