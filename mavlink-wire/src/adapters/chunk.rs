//! The bytes that are being searched.

use core::fmt;

use super::incoming::Found;
use crate::Parser;
use crate::frame::key::{WIPES, wipe_around};

/// What was read last, in a buffer `B`; the search has still to see `start..end` of it.
#[derive(Clone)]
pub(crate) struct Chunk<B> {
    buffer: B,
    start: usize,
    end: usize,
    /// A frame that carries a key was found, and is to be wiped once it is used.
    pub(crate) found_key: bool,
}

impl<B> Chunk<B> {
    pub(crate) const fn new(buffer: B) -> Self {
        Self { buffer, start: 0, end: 0, found_key: false }
    }
}

impl<B: AsRef<[u8]> + AsMut<[u8]>> Chunk<B> {
    /// Overwrites the key that was handed over last, in pieces of former chunks, too.
    pub(crate) fn wipe_used_key(&mut self) {
        if WIPES && core::mem::take(&mut self.found_key) {
            wipe_around(self.buffer.as_mut(), self.start, self.end);
        }
    }

    /// The parser's next frame in what is still to be searched.
    pub(crate) fn find(&mut self, parser: &mut Parser<'_>, bad_checksum: &mut impl FnMut(u32)) -> Option<Found> {
        let mut input = self.buffer.as_ref().get(self.start..self.end).unwrap_or_default();
        let found = Found::next(parser, &mut input, bad_checksum);
        self.start = self.end - input.len();
        self.found_key = found.is_some_and(|found| found.carries_key());
        found
    }

    /// Where to read to, when all is searched.
    pub(crate) fn space(&mut self) -> &mut [u8] {
        (self.start, self.end) = (0, 0);
        self.buffer.as_mut()
    }

    /// Takes what was read there; gives how many bytes there are now.
    pub(crate) fn fill(&mut self, length: usize) -> usize {
        (self.start, self.end) = (0, length.min(self.buffer.as_ref().len()));
        self.end
    }

    /// What was searched.
    pub(crate) fn used(&self) -> &[u8] {
        self.buffer.as_ref().get(..self.start).unwrap_or_default()
    }
}

/// What it holds is left out: it may be a key.
impl<B> fmt::Debug for Chunk<B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Chunk").field("start", &self.start).field("end", &self.end).finish_non_exhaustive()
    }
}
