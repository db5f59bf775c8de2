//! Who is a peer, and in which version each is spoken to. Both halves of a link look here.

use core::cmp::Reverse;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use std::vec::Vec;

use super::Peer;
#[cfg(feature = "signing")]
use crate::Timestamp;
use crate::Version;

/// How many peers are remembered if nothing else is said.
const LIMIT: usize = 16;

/// How long a silent peer is remembered if nothing else is said.
const EXPIRY: Duration = Duration::from_secs(3);

/// The peers of a link; a clone is another hand on the same.
#[derive(Clone, Debug)]
pub(crate) struct Peers(Arc<Mutex<Directory>>);

#[derive(Debug)]
struct Directory {
    /// Peers at most.
    limit: usize,
    /// So long after its last frame one is a peer.
    expiry: Duration,
    heard: Vec<Heard>,
    /// Whom everything goes to that is for nobody in particular, if the link's address or connection says so.
    named: Option<Peer>,
    /// The latest time that a verifier knows.
    #[cfg(feature = "signing")]
    time: Timestamp,
}

/// A peer, as it was heard last.
#[derive(Clone, Copy, Debug)]
struct Heard {
    peer: Peer,
    /// MAVLink 2, once it has sent that.
    version: Version,
    at: Instant,
}

/// Somebody to send to, and the version that is spoken there, if it was heard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Target {
    pub(crate) peer: Peer,
    pub(crate) version: Option<Version>,
}

impl Peers {
    pub(crate) fn new() -> Self {
        Self(Arc::new(Mutex::new(Directory {
            limit: LIMIT,
            expiry: EXPIRY,
            heard: Vec::new(),
            named: None,
            #[cfg(feature = "signing")]
            time: Timestamp::ZERO,
        })))
    }

    /// Whoever panicked while holding it had changed nothing by halves.
    fn lock(&self) -> MutexGuard<'_, Directory> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(crate) fn set_limit(&self, limit: usize) {
        self.lock().limit = limit;
    }

    pub(crate) fn set_expiry(&self, expiry: Duration) {
        self.lock().expiry = expiry;
    }

    /// Sends to this one from now on, and forgets who was there before; to nobody if it is `None`.
    pub(crate) fn name(&self, named: Option<Peer>) {
        let mut directory = self.lock();
        directory.named = named;
        directory.heard.clear();
    }

    /// The peers, the one that was heard last in front.
    pub(crate) fn all(&self, now: Instant) -> Vec<Peer> {
        let directory = self.lock();
        let mut heard: Vec<_> = directory.fresh(now).collect();
        heard.sort_by_key(|heard| Reverse(heard.at));
        heard.into_iter().map(|heard| heard.peer).collect()
    }

    /// Whom to send to what is for nobody in particular, in place of what `targets` had.
    pub(crate) fn targets(&self, now: Instant, targets: &mut Vec<Target>) {
        let directory = self.lock();
        targets.clear();
        match directory.named {
            // Who listens there may answer from other addresses: all understand what the oldest does.
            Some(peer) => {
                let oldest = directory.fresh(now).map(|heard| heard.version).min();
                targets.push(Target { peer, version: directory.version_of(peer, now).or(oldest) });
            }
            None => targets
                .extend(directory.fresh(now).map(|heard| Target { peer: heard.peer, version: Some(heard.version) })),
        }
    }

    /// How to send to this one, a peer or not.
    pub(crate) fn target(&self, peer: Peer, now: Instant) -> Target {
        Target { peer, version: self.lock().version_of(peer, now) }
    }

    pub(crate) fn is_peer(&self, peer: Peer, now: Instant) -> bool {
        self.lock().version_of(peer, now).is_some()
    }

    /// A frame of this version has come from there, and is to be believed: a peer, if it was one or there is room for one more.
    pub(crate) fn hear(&self, peer: Peer, version: Version, now: Instant) {
        let mut directory = self.lock();
        let Directory { limit, expiry, heard, .. } = &mut *directory;
        heard.retain(|heard| heard.is_fresh(*expiry, now));
        if let Some(known) = heard.iter_mut().find(|heard| heard.peer == peer) {
            (known.version, known.at) = (known.version.max(version), now);
        } else if heard.len() < *limit {
            heard.push(Heard { peer, version, at: now });
        }
    }

    /// Forgets a peer; whether it was one.
    pub(crate) fn remove(&self, peer: Peer, now: Instant) -> bool {
        let mut directory = self.lock();
        let was = directory.version_of(peer, now).is_some();
        directory.heard.retain(|heard| heard.peer != peer);
        was
    }

    /// The latest time that a verifier knows.
    #[cfg(feature = "signing")]
    pub(crate) fn time(&self) -> Timestamp {
        self.lock().time
    }

    /// Tells the time that a verifier knows.
    #[cfg(feature = "signing")]
    pub(crate) fn tell_time(&self, time: Timestamp) {
        let mut directory = self.lock();
        directory.time = directory.time.max(time);
    }
}

impl Directory {
    /// Who is a peer now.
    fn fresh(&self, now: Instant) -> impl Iterator<Item = Heard> {
        self.heard.iter().filter(move |heard| heard.is_fresh(self.expiry, now)).copied()
    }

    fn version_of(&self, peer: Peer, now: Instant) -> Option<Version> {
        self.fresh(now).find(|heard| heard.peer == peer).map(|heard| heard.version)
    }
}

impl Heard {
    fn is_fresh(&self, expiry: Duration, now: Instant) -> bool {
        now.saturating_duration_since(self.at) < expiry
    }
}
