//! How a link behaves.

use std::time::Duration;

#[cfg(feature = "signing")]
use super::inbox::is_of_radio;
#[cfg(feature = "signing")]
use crate::Frame;
#[cfg(feature = "signing")]
use crate::signing::Verifier;
use crate::{Sender, Table, Version};

/// How long a send waits for room if nothing else is said.
const SEND_TIMEOUT: Duration = Duration::from_secs(1);

/// How a link behaves: what it knows, who it is, whom it trusts.
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
    /// A link that verifies the messages of this table, and sends what this sender makes: with its ids, with its signature,
    /// and in its version until the peer is heard, who is then spoken to in his own.
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
            allow: is_of_radio,
        }
    }

    /// The same that sends in this version alone, whatever a peer speaks. Some autopilots speak MAVLink 1 until they hear
    /// MAVLink 2.
    #[must_use]
    pub const fn with_version(mut self, version: Version) -> Self {
        self.version = Some(version);
        self
    }

    /// The same with room for so many peers, instead of 16. For `udpin` and `udpbcast`.
    #[must_use]
    pub const fn with_peer_limit(mut self, limit: usize) -> Self {
        self.peer_limit = Some(limit);
        self
    }

    /// The same that forgets a peer when it has been silent for so long, instead of 3 seconds. For UDP.
    #[must_use]
    pub const fn with_peer_expiry(mut self, silence: Duration) -> Self {
        self.peer_expiry = Some(silence);
        self
    }

    /// The same whose sends wait so long for room in a full buffer, instead of 1 second; at least a millisecond.
    #[must_use]
    pub const fn with_send_timeout(mut self, timeout: Duration) -> Self {
        self.send_timeout = timeout;
        self
    }

    /// The same that is closed when the connection or the device is lost, instead of opening it again.
    #[must_use]
    pub const fn without_reconnecting(mut self) -> Self {
        self.reconnects = false;
        self
    }

    /// The same that hands over only what this verifier trusts, by the clock of the system; on UDP, only who signs is a peer.
    /// Files are handed over as they are: they are older than any clock allows.
    #[cfg(feature = "signing")]
    #[must_use]
    pub fn with_verifier(mut self, verifier: Verifier) -> Self {
        self.verifier = Some(verifier);
        self
    }

    /// The same with a rule of yours for frames that no signature vouches for: unsigned ones, and those whose signature is
    /// wrong or old. Else it is `RADIO_STATUS` alone that passes. `|frame| frame.signature().is_none()` takes what is not
    /// signed. What passes by the rule makes no peer on UDP.
    #[cfg(feature = "signing")]
    #[must_use]
    pub fn with_unsigned(mut self, allow: fn(&Frame<'_>) -> bool) -> Self {
        self.allow = allow;
        self
    }
}
