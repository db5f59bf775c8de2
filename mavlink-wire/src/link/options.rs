//! How a link behaves.

use std::time::Duration;

#[cfg(feature = "signing")]
use crate::Frame;
#[cfg(feature = "signing")]
use crate::signing::Verifier;
use crate::{Sender, Table, Version};

/// How long a send waits for room if nothing else is said.
const SEND_TIMEOUT: Duration = Duration::from_secs(1);

/// Options of a link: its table of messages, its sender, timeouts, and whose frames it accepts.
///
/// ```
/// use core::time::Duration;
/// # use mavlink_wire::{Table, Version};
/// use mavlink_wire::{Sender, link::Options};
///
/// # static TABLE: Table<'static> = Table::of(&[]);
/// let options = Options::new(&TABLE, Sender::v2(255, 190)).with_send_timeout(Duration::from_millis(100));
/// ```
#[derive(Clone, Debug)]
pub struct Options {
    pub(super) table: &'static Table<'static>,
    pub(super) sender: Sender,
    pub(super) version: Option<Version>,
    pub(super) peer_limit: Option<usize>,
    pub(super) peer_expiry: Option<Duration>,
    pub(super) send_timeout: Duration,
    pub(super) reconnects: bool,
    #[cfg(feature = "signing")]
    pub(super) verifier: Option<Verifier>,
    #[cfg(feature = "signing")]
    pub(super) allow: fn(&Frame<'_>) -> bool,
}

impl Options {
    /// A link that verifies the messages of this table, and sends with the ids and the signature of this sender. It uses the
    /// sender's version of MAVLink until it hears the peer, and then the peer's version.
    #[must_use]
    pub const fn new(table: &'static Table<'static>, sender: Sender) -> Self {
        Self {
            table,
            sender,
            version: None,
            peer_limit: None,
            peer_expiry: None,
            send_timeout: SEND_TIMEOUT,
            reconnects: true,
            #[cfg(feature = "signing")]
            verifier: None,
            #[cfg(feature = "signing")]
            allow: |frame| frame.is_of_radio(),
        }
    }

    /// Always sends this version of MAVLink, whatever a peer sends. Some autopilots send MAVLink 1 until they receive MAVLink 2.
    #[must_use]
    pub const fn with_version(mut self, version: Version) -> Self {
        self.version = Some(version);
        self
    }

    /// Sets the greatest number of peers, instead of 16. For `udpin` and `udpbcast`.
    #[must_use]
    pub const fn with_peer_limit(mut self, limit: usize) -> Self {
        self.peer_limit = Some(limit);
        self
    }

    /// Sets the silence after which a peer is forgotten, instead of 3 seconds. For UDP.
    #[must_use]
    pub const fn with_peer_expiry(mut self, silence: Duration) -> Self {
        self.peer_expiry = Some(silence);
        self
    }

    /// Sets how long a send waits for room in a full buffer, instead of 1 second. At least a millisecond.
    #[must_use]
    pub const fn with_send_timeout(mut self, timeout: Duration) -> Self {
        self.send_timeout = timeout;
        self
    }

    /// Closes the link when the connection or the device is lost, instead of reopening it.
    #[must_use]
    pub const fn without_reconnecting(mut self) -> Self {
        self.reconnects = false;
        self
    }

    /// Returns only frames that this verifier trusts, by the system's clock. On UDP, only a sender of signed frames is a peer.
    /// Files are not verified, because their frames are too old for any clock.
    #[cfg(feature = "signing")]
    #[must_use]
    pub fn with_verifier(mut self, verifier: Verifier) -> Self {
        self.verifier = Some(verifier);
        self
    }

    /// Sets a rule for frames without a valid signature: unsigned ones, and those whose signature is wrong or old. Without a
    /// rule, only `RADIO_STATUS` passes. `|frame| frame.signature().is_none()` accepts unsigned frames. On UDP, a frame that
    /// passes by the rule does not make its sender a peer.
    #[cfg(feature = "signing")]
    #[must_use]
    pub fn with_unsigned(mut self, allow: fn(&Frame<'_>) -> bool) -> Self {
        self.allow = allow;
        self
    }
}
