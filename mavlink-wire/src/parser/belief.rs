//! Whether a frame of an unknown message is one, although its checksum proves little.

use crate::frame::Facts;
use crate::header::{STX_V1, STX_V2, to_next_start};
use crate::{FrameError, Table};

/// What is known about the bytes around the place where the parser is.
///
/// The checksum of a false frame is explained by some `crc_extra` in one of 256 cases. So a frame of an unknown message is
/// believed if no known frame starts inside of it, or if it stands where a frame has to stand: behind another one, or at the
/// beginning, and directly before the start of the next, or at the end. Then it carries the known frame in its payload.
#[derive(Clone, Debug)]
pub(super) struct Belief {
    /// Whether a frame ended here, or the stream begins here.
    expected: bool,
    /// In so many bytes from here on, without the first, starts no known frame; but
    clear: usize,
    /// whether one starts behind them is known.
    known: bool,
}

/// What comes of a frame of an unknown message.
pub(super) enum Judgement {
    Believed,
    Refused,
    /// It takes so many bytes from the frame's start to know.
    Undecided {
        needed: usize,
    },
}

/// What starts inside of a frame.
enum Inside {
    Nothing,
    Known,
    Perhaps { needed: usize },
}

impl Belief {
    /// At the beginning of a stream.
    pub(super) const NEW: Self = Self { expected: true, clear: 0, known: false };

    /// Goes on behind a verified frame. None starts before it, so nothing is known about the bytes behind it.
    #[inline]
    pub(super) fn hand_over(&mut self) {
        *self = Self::NEW;
    }

    /// Goes on behind an unverified frame.
    pub(super) fn believe(&mut self, length: usize) {
        self.go_on(length);
        self.expected = true;
    }

    /// Goes on behind bytes that start no frame.
    #[inline]
    pub(super) fn pass(&mut self, count: usize) {
        self.go_on(count);
        self.expected = false;
    }

    #[inline]
    fn go_on(&mut self, count: usize) {
        self.known &= count <= self.clear;
        self.clear = self.clear.saturating_sub(count);
    }

    /// Judges the unverified frame of this length at the start of `bytes`, which may go on behind it.
    pub(super) fn judge(&mut self, bytes: &[u8], length: usize, table: &Table<'_>, at_end: bool) -> Judgement {
        let next = bytes.get(length);
        if self.expected && next.map_or(at_end, |&byte| matches!(byte, STX_V1 | STX_V2)) {
            return Judgement::Believed;
        }
        match self.search(bytes, length, table, at_end) {
            Inside::Nothing => Judgement::Believed,
            // What follows the frame may save it.
            Inside::Known | Inside::Perhaps { .. } if self.expected && next.is_none() => {
                Judgement::Undecided { needed: length + 1 }
            }
            Inside::Known => Judgement::Refused,
            Inside::Perhaps { needed } => Judgement::Undecided { needed },
        }
    }

    /// The first known frame that starts inside of the first `length` bytes; no byte is looked at twice, however often
    /// this is asked.
    fn search(&mut self, bytes: &[u8], length: usize, table: &Table<'_>, at_end: bool) -> Inside {
        self.clear = self.clear.max(1);
        while self.clear < length {
            if self.known {
                return Inside::Known;
            }
            let rest = bytes.get(self.clear..).unwrap_or_default();
            match Facts::among(rest, table, false) {
                Ok(_) => self.known = true,
                Err(FrameError::Incomplete { needed }) if !at_end => {
                    return Inside::Perhaps { needed: self.clear + needed };
                }
                Err(_) => self.clear += to_next_start(rest),
            }
        }
        Inside::Nothing
    }
}
