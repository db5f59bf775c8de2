//! What there is at the start of some bytes, and how to go on where that is nothing.

mod resync;

use super::prefixes::Prefixes;
use super::sightings::Sightings;
use super::work;
use crate::frame::key::{SETUP_SIGNING, WIPES};
use crate::frame::{Candidate, Facts};
use crate::header::{Header, to_next_start};
use crate::{FrameError, Statistics, Table};

/// The search for frames, from one place to the next.
// Small fields lie in front: that makes the code smaller which reaches for them.
#[derive(Clone, Debug)]
#[repr(C)]
pub(super) struct Search<'t> {
    table: &'t Table<'t>,
    /// Bytes of the frame that was examined last, by its header.
    length: usize,
    /// Up to this place of the stream, as `prefixes` has it, no known frame starts that an unverified one could carry.
    searched: usize,
    /// How many of the next bytes belong to a frame that was counted as damaged.
    damaged: usize,
    /// How many bytes were skipped since a frame ended, or the stream began.
    skipped: bool,
    pub(super) statistics: Statistics,
    prefixes: Prefixes,
    sightings: Sightings,
    /// A frame that carries a key was found, and is to be wiped once it is used.
    pub(super) found_key: bool,
}

/// How to go on where there is no frame.
#[derive(Clone, Copy)]
pub(super) enum Step {
    /// It takes so many bytes to know; never at the end.
    Wait { needed: usize },
    /// So many bytes further there may be something.
    Pass { count: usize },
}

/// What there is at a place.
enum Examined {
    Frame(Header, Facts),
    /// It takes so many bytes to know. It is likely to be a frame if it is of a known message, and has its length; said where
    /// it was asked.
    Incomplete {
        needed: usize,
        likely: bool,
    },
    /// A frame whose checksum is wrong.
    Damaged {
        id: u32,
    },
    Nothing,
}

impl<'t> Search<'t> {
    pub(super) const fn new(table: &'t Table<'t>) -> Self {
        Self {
            table,
            length: 0,
            searched: 0,
            damaged: 0,
            skipped: false,
            statistics: Statistics::NONE,
            prefixes: Prefixes::NEW,
            sightings: Sightings::NONE,
            found_key: false,
        }
    }

    /// Forgets everything but the table and the statistics.
    pub(super) fn reset(&mut self) {
        *self = Self { statistics: self.statistics, ..Self::new(self.table) };
    }

    /// What comes next is the beginning of a stream.
    pub(super) fn restart(&mut self) {
        (self.skipped, self.damaged) = (false, 0);
    }

    /// Whether many frames seem to start around here.
    pub(super) fn is_contested(&self) -> bool {
        self.prefixes.is_contested()
    }

    /// The frame at the start of these bytes, or how to go on: with more bytes, or further behind. `at_end` says that there
    /// are no more. `bad_checksum` is told the message of a frame that is counted as damaged.
    #[inline]
    pub(super) fn look(
        &mut self,
        bytes: &[u8],
        at_end: bool,
        bad_checksum: &mut impl FnMut(u32),
    ) -> Result<(Header, Facts), Step> {
        match self.examine(bytes, 0, false) {
            Examined::Frame(header, facts) => {
                let length = self.length;
                if !facts.verified {
                    self.doubt(bytes, length, facts, at_end)?;
                }
                (self.skipped, self.damaged) = (false, 0);
                self.prefixes.advance(length);
                self.statistics.frames += 1;
                self.found_key |= WIPES && facts.id == SETUP_SIGNING;
                Ok((header, facts))
            }
            Examined::Incomplete { needed, .. } if !at_end => Err(Step::Wait { needed }),
            nothing => Err(self.give_up(bytes, nothing, bad_checksum)),
        }
    }

    /// The frame so many bytes behind the start of these.
    #[cfg_attr(feature = "fast-crc", inline)]
    #[cfg_attr(not(feature = "fast-crc"), inline(never))]
    fn examine(&mut self, bytes: &[u8], at: usize, is_likely_asked: bool) -> Examined {
        work::count(4);
        let Some(there) = bytes.get(at..) else { return Examined::Nothing };
        let candidate = match Candidate::read(there) {
            Ok(candidate) => candidate,
            Err(FrameError::Incomplete { needed }) => return Examined::Incomplete { needed, likely: false },
            Err(_) => return Examined::Nothing,
        };
        self.length = candidate.header.frame_length();
        if there.len() < self.length {
            let likely = is_likely_asked && candidate.is_likely(self.table);
            return Examined::Incomplete { needed: self.length, likely };
        }
        match candidate.verify(there, self.table, |end| self.prefixes.checksum(bytes, at + 1, at + end)) {
            Ok(facts) => Examined::Frame(candidate.header, facts),
            Err(_) => Examined::Damaged { id: candidate.id },
        }
    }

    /// Passes over something that is no frame. Not inlined where time counts: in front of known frames, it would cost a tenth
    /// of it.
    #[cfg_attr(feature = "fast-crc", inline(never))]
    fn give_up(&mut self, bytes: &[u8], examined: Examined, bad_checksum: &mut impl FnMut(u32)) -> Step {
        if let (Examined::Damaged { id }, 0) = (examined, self.damaged) {
            bad_checksum(id);
            self.statistics.bad_checksums += 1;
            self.damaged = self.length;
        }
        self.pass(to_next_start(bytes))
    }

    fn pass(&mut self, count: usize) -> Step {
        self.skipped = true;
        self.prefixes.advance(count);
        self.damaged = self.damaged.saturating_sub(count);
        self.statistics.skipped_bytes += count as u64;
        Step::Pass { count }
    }
}
