//! The bytes that wait for the rest of a frame.

use crate::MAX_FRAME;
use crate::frame::key::wipe_around;
use crate::message::wire::{copy, put};

/// A frame of an unknown message, and behind its last byte the rest of a known one that may start there.
const CAPACITY: usize = 2 * MAX_FRAME;

/// Bytes of earlier chunks, and behind them as many of the present one as it takes to go on.
#[derive(Clone)]
pub(super) struct Held {
    /// At `start..end`, behind those of the frame that was handed out last.
    bytes: [u8; CAPACITY],
    start: usize,
    end: usize,
}

impl Held {
    pub(super) const EMPTY: Self = Self { bytes: [0; CAPACITY], start: 0, end: 0 };

    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        self.start == self.end
    }

    #[inline]
    fn length(&self) -> usize {
        self.end - self.start
    }

    /// The bytes that are still to be searched.
    pub(super) fn bytes(&self) -> &[u8] {
        self.bytes.get(self.start..self.end).unwrap_or_default()
    }

    /// The bytes that were used, as far as they are still here.
    pub(super) fn released(&self) -> &[u8] {
        self.bytes.get(..self.start).unwrap_or_default()
    }

    /// Takes bytes of `input` until so many are held; whether there were enough.
    pub(super) fn fill(&mut self, needed: usize, input: &mut &[u8]) -> bool {
        if self.start + needed > CAPACITY {
            self.move_to_front();
        }
        let free = self.bytes.get_mut(self.end..self.start + needed).unwrap_or_default();
        let count = free.len().min(input.len());
        copy(input, free);
        *input = input.get(count..).unwrap_or_default();
        self.end += count;
        self.length() >= needed
    }

    /// Overwrites what was used.
    fn move_to_front(&mut self) {
        let length = self.length();
        for at in 0..length {
            let byte = self.bytes.get(self.start + at).copied().unwrap_or_default();
            put(&mut self.bytes, at, byte);
        }
        (self.start, self.end) = (0, length);
    }

    /// Overwrites what is not to be searched any more.
    pub(super) fn wipe_used(&mut self) {
        wipe_around(&mut self.bytes, self.start, self.end);
    }

    /// Has used so many bytes.
    #[inline]
    pub(super) fn release(&mut self, count: usize) {
        self.start += count;
    }
}

/// How many bytes, not which: they may be of a `SETUP_SIGNING`, which carries a key.
impl core::fmt::Debug for Held {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Held").field("start", &self.start).field("end", &self.end).finish_non_exhaustive()
    }
}
