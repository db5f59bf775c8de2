//! The bytes that wait for the rest of a frame.

use super::work;
use crate::MAX_FRAME;
use crate::frame::key::wipe_around;
use crate::header::LONGEST;
use crate::message::wire::copy;

/// Twice a frame of an unknown message and a header that starts with its last byte: where there is no room for that many
/// more bytes, more than is held was used.
const CAPACITY: usize = 2 * (MAX_FRAME + LONGEST);

/// Bytes of earlier chunks, and behind them as many of the present one as it takes to go on.
// Small fields lie in front: that makes the code smaller which reaches for them.
#[derive(Clone)]
#[repr(C)]
pub(super) struct Held {
    start: usize,
    end: usize,
    /// At `start..end`, behind those of the frame that was handed out last.
    bytes: [u8; CAPACITY],
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

    /// The last of the bytes that were used, so many of them as far as they are still here.
    pub(super) fn released(&self, count: usize) -> &[u8] {
        self.bytes.get(self.start.saturating_sub(count)..self.start).unwrap_or_default()
    }

    /// Takes bytes of `input` until so many are held, or more if there are to be `many`; whether there were enough.
    #[cfg_attr(feature = "fast-crc", inline(always))]
    pub(super) fn fill(&mut self, needed: usize, input: &mut &[u8], many: bool) -> bool {
        if self.length() >= needed {
            return true;
        }
        if self.start + needed > CAPACITY {
            self.move_to_front();
        }
        let end = if many { CAPACITY } else { self.start + needed };
        let free = self.bytes.get_mut(self.end..end).unwrap_or_default();
        let count = free.len().min(input.len());
        copy(input, free);
        work::count(count);
        *input = input.get(count..).unwrap_or_default();
        self.end += count;
        self.length() >= needed
    }

    /// Gives what is held back to `input`, if all of it was taken of this chunk, of which `input` is what is left.
    #[inline]
    pub(super) fn give_back<'i>(&mut self, chunk: &'i [u8], input: &mut &'i [u8]) {
        if let Some(start) = (chunk.len() - input.len()).checked_sub(self.length()) {
            *input = chunk.get(start..).unwrap_or_default();
            self.end = self.start;
        }
    }

    /// Overwrites what was used, which is more than what is held.
    #[cfg_attr(feature = "fast-crc", inline(never))]
    fn move_to_front(&mut self) {
        debug_assert!(self.length() <= self.start, "what is overwritten is not in use");
        if let Some((used, held)) = self.bytes.split_at_mut_checked(self.start) {
            copy(held, used);
        }
        (self.start, self.end) = (0, self.length());
        work::count(self.end);
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
