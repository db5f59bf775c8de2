//! The bytes that wait for the rest of a frame.

use crate::{MAX_FRAME, zero_extended};

/// A frame of an unknown message, and behind its last byte the rest of a known one that may start there.
const CAPACITY: usize = 2 * MAX_FRAME;

/// Bytes of earlier chunks. Behind them, bytes of the present one can be borrowed.
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
    pub(super) fn length(&self) -> usize {
        self.end - self.start
    }

    /// The held bytes, and so many borrowed ones.
    pub(super) fn with_borrowed(&self, borrowed: usize) -> &[u8] {
        self.bytes.get(self.start..self.end + borrowed).unwrap_or_default()
    }

    /// The bytes that were given up, as far as they are still here.
    pub(super) fn released(&self) -> &[u8] {
        self.bytes.get(..self.start).unwrap_or_default()
    }

    /// Puts bytes of `input` behind the held ones, as many as `needed` bytes lack; gives their number.
    pub(super) fn borrow(&mut self, needed: usize, input: &[u8]) -> usize {
        if self.start + needed > CAPACITY {
            self.bytes = zero_extended(self.with_borrowed(0));
            (self.start, self.end) = (0, self.length());
        }
        let free = self.bytes.get_mut(self.end..self.start + needed).unwrap_or_default();
        free.iter_mut().zip(input).map(|(to, from)| *to = *from).count()
    }

    /// Keeps all of `input`, with which fewer than `needed` bytes are held.
    pub(super) fn keep(&mut self, needed: usize, input: &mut &[u8]) {
        self.end += self.borrow(needed, input);
        *input = &[];
    }

    /// Gives up bytes: first held ones, then of `input`.
    pub(super) fn release(&mut self, count: usize, input: &mut &[u8]) {
        self.start += count;
        *input = input.get(self.start.saturating_sub(self.end)..).unwrap_or_default();
        self.end = self.end.max(self.start);
    }

    /// Goes back to the beginning of an empty space.
    pub(super) fn reset(&mut self) {
        (self.start, self.end) = (0, 0);
    }
}

/// How many bytes, not which: they may be of a `SETUP_SIGNING`, which carries a key.
impl core::fmt::Debug for Held {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Held").field("start", &self.start).field("end", &self.end).finish_non_exhaustive()
    }
}
