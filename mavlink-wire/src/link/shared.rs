//! What the halves of a link have in common, whether they wait by blocking or by polling.

use core::sync::atomic::{AtomicBool, Ordering};
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use super::statistics::Counters;
use super::{Inbox, LinkError, Options, Outbox, Peer, Peers};

/// How long the rest of a frame is waited for where the way is a stream: longer than a network takes to send again.
const SILENCE_OF_STREAMS: Duration = Duration::from_secs(2);

/// What a link knows of itself.
#[derive(Debug)]
pub(super) struct Shared {
    pub(super) peers: Peers,
    pub(super) counters: Arc<Counters>,
    /// Where it listens.
    pub(super) local: Option<SocketAddr>,
    /// Whether anybody may be at the other end: then no key goes to all.
    pub(super) is_open_to_all: bool,
    pub(super) send_timeout: Duration,
    closed: AtomicBool,
}

impl Shared {
    pub(super) fn new(peers: Peers, options: &Options) -> Self {
        Self {
            peers,
            counters: Arc::default(),
            local: None,
            is_open_to_all: false,
            send_timeout: options.send_timeout,
            closed: AtomicBool::new(false),
        }
    }

    /// The same of a link that listens there, for whoever comes.
    pub(super) fn listening(self, local: Option<SocketAddr>) -> Self {
        Self { local, is_open_to_all: true, ..self }
    }

    /// The same of a link that sends there, whoever answers.
    pub(super) fn towards(self, to: Peer) -> Self {
        self.peers.name(Some(to));
        self
    }

    pub(super) fn close(&self) {
        self.closed.store(true, Ordering::Release);
    }

    /// An error, if the link was closed.
    pub(super) fn check(&self) -> Result<(), LinkError> {
        if self.closed.load(Ordering::Acquire) { Err(LinkError::Closed) } else { Ok(()) }
    }
}

impl Options {
    /// The peers of a link of datagrams.
    pub(super) fn peers(&self) -> Peers {
        let peers = Peers::new();
        if let Some(limit) = self.peer_limit {
            peers.set_limit(limit);
        }
        if let Some(expiry) = self.peer_expiry {
            peers.set_expiry(expiry);
        }
        peers
    }

    /// The peers of a link with one at the other end, who stays until the connection is lost.
    pub(super) fn only_peer(&self) -> Peers {
        let peers = Peers::new();
        peers.set_expiry(Duration::MAX);
        peers
    }

    /// What finds the frames.
    pub(super) fn inbox(&self, peers: &Peers, is_stream: bool) -> Inbox<'static> {
        let silence = if is_stream { SILENCE_OF_STREAMS } else { crate::adapters::udp::SILENCE };
        #[cfg_attr(not(feature = "signing"), expect(unused_mut, reason = "nothing more is set"))]
        let mut inbox = Inbox::new(self.table, peers.clone(), silence);
        #[cfg(feature = "signing")]
        {
            inbox.verifier.clone_from(&self.verifier);
            inbox.allow = self.allow;
        }
        inbox
    }

    /// What makes the frames.
    pub(super) fn outbox(&self, peers: &Peers) -> Outbox {
        let mut outbox = Outbox::new(self.sender.clone(), peers.clone());
        outbox.only = self.version;
        outbox
    }
}
