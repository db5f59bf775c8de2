//! Makes signatures.

use super::Key;
use crate::header::SIGNATURE;
use crate::message::wire::put;
use crate::{MAX_FRAME, Timestamp};

/// Signs the frames of one link: the key, the link's number and the timestamp of the next frame.
///
/// The timestamp of a frame is larger than that of the one before, whatever the clock does: receivers refuse what is
/// not. It stays at [`Timestamp::MAX`], in the year 2104: what it signs from then on is refused. A clone counts by itself:
/// never let two of them sign for one link.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signer {
    key: Key,
    link_id: u8,
    timestamp: Timestamp,
}

impl Signer {
    /// A signer whose first frame has this timestamp: the saved one, or the time, whichever is later.
    ///
    /// If it is saved once a minute and there is no clock, start at the saved one [plus](Timestamp::saturating_add) a minute.
    #[must_use]
    pub const fn new(key: Key, link_id: u8, timestamp: Timestamp) -> Self {
        Self { key, link_id, timestamp }
    }

    /// Which of this system's links.
    #[must_use]
    pub const fn link_id(&self) -> u8 {
        self.link_id
    }

    /// The timestamp of the next frame, which is to be saved.
    #[must_use]
    pub const fn timestamp(&self) -> Timestamp {
        self.timestamp
    }

    /// Tells the time: the next frame's timestamp is at least this. An earlier time changes nothing.
    ///
    /// Call it before sending, or about once a second, with the clock and with
    /// [`Verifier::timestamp`](super::Verifier::timestamp): receivers refuse a new stream that is over a minute behind.
    pub fn advance_time(&mut self, now: Timestamp) {
        self.timestamp = self.timestamp.max(now);
    }

    /// Signs the MAVLink 2 frame in the first `length` bytes, checksum included; gives its length with the signature.
    pub(crate) fn sign(&mut self, frame: &mut [u8; MAX_FRAME], length: usize) -> usize {
        put(frame, length, self.link_id);
        put(frame, length + 1, self.timestamp.to_bytes());
        let hash = self.key.hash(frame.get(..length + 7).unwrap_or_default());
        put(frame, length + 7, hash);
        self.timestamp = self.timestamp.next();
        length + SIGNATURE
    }
}
