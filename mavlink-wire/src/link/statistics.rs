//! What a link counts.

use std::sync::{Mutex, PoisonError};

use crate::Statistics;

/// Counts of what a link received and sent so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct LinkStatistics {
    /// Frames found in the received bytes, and bytes that could not be read.
    pub received: Statistics,
    /// Frames that the verifier refused. They also count as received.
    pub refused: u64,
    /// Frames sent; one that went to three peers counts three times.
    pub sent: u64,
    /// Frames that were not sent, or only in part: the buffer was full, or the connection was lost.
    pub unsent: u64,
    /// How often the link was opened; each time after the first is a reconnection.
    pub connections: u64,
}

/// Counts what both halves of a link do.
#[derive(Debug, Default)]
pub(super) struct Counters(Mutex<LinkStatistics>);

impl Counters {
    pub(super) fn count_sent(&self, count: usize) {
        self.count(|counted| counted.sent += count as u64);
    }

    pub(super) fn count_unsent(&self, count: usize) {
        self.count(|counted| counted.unsent += count as u64);
    }

    pub(super) fn count_connection(&self) {
        self.count(|counted| counted.connections += 1);
    }

    fn count(&self, change: impl FnOnce(&mut LinkStatistics)) {
        change(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner));
    }

    /// Together with what the receiving half has counted.
    pub(super) fn with(&self, received: Statistics, refused: u64) -> LinkStatistics {
        LinkStatistics { received, refused, ..*self.0.lock().unwrap_or_else(PoisonError::into_inner) }
    }
}
