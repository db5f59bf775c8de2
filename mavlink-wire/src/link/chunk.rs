//! The bytes that are being searched.

use std::boxed::Box;
use std::vec;

use super::Peer;
use crate::frame::key::{WIPES, wipe_around};

/// No datagram is longer.
pub(crate) const MAX_CHUNK: usize = 65_536;

/// What came last; the search has still to see `start..end` of it.
#[derive(Clone)]
pub(super) struct Chunk {
    buffer: Box<[u8]>,
    start: usize,
    end: usize,
    /// Who sent it, until it is used up.
    pub(super) from: Option<Peer>,
    /// A frame that carries a key was found, and is to be wiped once it is used.
    pub(super) found_key: bool,
}

impl Chunk {
    pub(super) fn new() -> Self {
        Self { buffer: vec![0; MAX_CHUNK].into_boxed_slice(), start: 0, end: 0, from: None, found_key: false }
    }

    /// Overwrites the key that was handed over last, in pieces of former chunks, too.
    pub(super) fn wipe_used_key(&mut self) {
        if WIPES && core::mem::take(&mut self.found_key) {
            wipe_around(&mut self.buffer, self.start, self.end);
        }
    }

    /// Where to receive to, when all is used.
    pub(super) fn space(&mut self) -> &mut [u8] {
        (self.start, self.end, self.from) = (0, 0, None);
        &mut self.buffer
    }

    /// Takes what was received.
    pub(super) fn fill(&mut self, length: usize, from: Peer) {
        (self.start, self.end, self.from) = (0, length.min(self.buffer.len()), Some(from));
    }

    /// What is still to be searched.
    pub(super) fn rest(&self) -> &[u8] {
        self.buffer.get(self.start..self.end).unwrap_or_default()
    }

    /// What was searched.
    pub(super) fn used(&self) -> &[u8] {
        self.buffer.get(..self.start).unwrap_or_default()
    }

    /// Says how much is still to be searched.
    pub(super) fn leave(&mut self, rest: usize) {
        self.start = self.end.saturating_sub(rest);
    }
}

/// What it holds is left out: it may be a key.
impl core::fmt::Debug for Chunk {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self { start, end, from, .. } = self;
        f.debug_struct("Chunk").field("start", start).field("end", end).field("from", from).finish_non_exhaustive()
    }
}
