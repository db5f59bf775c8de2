//! The checksums of candidates that lie in each other, without walking over any byte twice.
//!
//! Where a frame fails, the next one may start at any byte inside of it, and has a checksum of its own. But the register of
//! a CRC is linear in the bytes that it walked over: that of a range is the register at its end, less that at its start
//! advanced by as many zero bytes. To advance is to multiply, by a power of x modulo the polynomial. So one walk, which keeps
//! the register on the way, answers for every range: the work for a byte is bounded, however many candidates it belongs to.

use crate::MAX_FRAME;
use crate::frame::crc::{self, WORD};

/// A register is kept in front of every so many bytes. Between two of them every candidate walks by itself.
const STRIDE: usize = WORD;

/// Registers that are kept: at least as many as a frame can reach, and a power of two.
const REGISTERS: usize = (MAX_FRAME / STRIDE + 1).next_power_of_two();

/// Bytes that they reach.
const REACH: usize = STRIDE * REGISTERS;

/// Whether a checksum may be calculated by itself, in blocks: that is faster than registers where candidates are few. Where
/// flash counts more than time, all get theirs by registers.
const BY_ITSELF: bool = cfg!(feature = "fast-crc");

/// Bytes that may be walked over in that way for each byte of the stream: they take as long as one by registers.
const CREDIT: usize = 8;

/// The most of them that are saved up: for some candidates in a row.
const MOST_CREDIT: usize = 4 * MAX_FRAME;

/// Checksums of ranges of a stream, from a place that moves on.
// Small fields lie in front: that makes the code smaller which reaches for them.
#[derive(Clone, Debug)]
#[repr(C)]
pub(crate) struct Prefixes {
    /// Where the present place is in the stream.
    place: usize,
    /// Where the last register is, if it is at most `REACH` further.
    walked: usize,
    /// Bytes that may be walked over for checksums by themselves.
    credit: usize,
    /// A ring. The first one of a walk may be any: only differences count.
    registers: [u16; REGISTERS],
}

impl Prefixes {
    pub(crate) const NEW: Self =
        Self { place: 0, walked: 0, credit: if BY_ITSELF { MOST_CREDIT } else { 0 }, registers: [0; REGISTERS] };

    /// The checksum of `bytes[start..end]`, where `bytes` begin at the present place.
    #[inline]
    pub(crate) fn checksum(&mut self, bytes: &[u8], start: usize, end: usize) -> u16 {
        if BY_ITSELF && let Some(credit) = self.credit.checked_sub(end) {
            self.credit = credit;
            crc::checksum(bytes.get(start..end).unwrap_or_default())
        } else {
            self.combined(bytes, start, end)
        }
    }

    /// Whether there are many candidates around the present place.
    #[inline]
    pub(crate) fn is_contested(&self) -> bool {
        self.credit < MAX_FRAME
    }

    /// Where the present place is in the stream.
    pub(crate) fn place(&self) -> usize {
        self.place
    }

    /// Moves on by so many bytes.
    #[inline]
    pub(crate) fn advance(&mut self, count: usize) {
        self.place = self.place.wrapping_add(count);
        if BY_ITSELF {
            self.credit = self.credit.saturating_add(count.saturating_mul(CREDIT)).min(MOST_CREDIT);
        }
    }

    /// The checksum by the registers in the range, and a walk to the first and from the last of them.
    #[inline(never)]
    fn combined(&mut self, bytes: &[u8], start: usize, end: usize) -> u16 {
        let next = self.next_register(start);
        let first = next.min(end);
        let words = (end - first) / STRIDE;
        let last = first + words * STRIDE;
        let crc = crc::extend(crc::INITIAL, bytes, start..first);
        if self.walked.wrapping_sub(self.place) > REACH {
            // A new walk, for everything behind the present place. If it begins with this register, there is nothing to advance by.
            self.keep(self.next_register(1), crc);
        }
        self.walk(bytes, end);
        let crc = self.register(last) ^ crc::advance(crc ^ self.register(first), words);
        crc::extend(crc, bytes, last..end)
    }

    /// Walks on as far as there are registers for a range that ends there.
    fn walk(&mut self, bytes: &[u8], end: usize) {
        let mut at = self.walked.wrapping_sub(self.place);
        while at + STRIDE <= end {
            let register = crc::extend(self.register(at), bytes, at..at + STRIDE);
            at += STRIDE;
            self.keep(at, register);
        }
    }

    /// Keeps the register so many bytes from the present place, to which it was walked.
    fn keep(&mut self, offset: usize, register: u16) {
        self.walked = self.place.wrapping_add(offset);
        let index = self.index(offset);
        if let Some(kept) = self.registers.get_mut(index) {
            *kept = register;
        }
    }

    /// How many bytes from the present place the next register is that is so many from it, or more.
    fn next_register(&self, offset: usize) -> usize {
        offset + self.place.wrapping_add(offset).wrapping_neg() % STRIDE
    }

    /// The register so many bytes from the present place, where one is kept.
    fn register(&self, offset: usize) -> u16 {
        self.registers.get(self.index(offset)).copied().unwrap_or_default()
    }

    fn index(&self, offset: usize) -> usize {
        self.place.wrapping_add(offset) / STRIDE % REGISTERS
    }
}
