//! What there is at the start of some bytes.

use memchr::memchr2;

use super::belief::{Belief, Judgement};
use crate::frame::Facts;
use crate::header::{Header, STX_V1, STX_V2};
use crate::{FrameError, Statistics, Table};

/// The search for frames, from one place to the next.
#[derive(Clone, Debug)]
pub(super) struct Search<'t> {
    table: &'t Table<'t>,
    belief: Belief,
    /// How many of the next bytes belong to a frame that was counted as damaged.
    damaged: usize,
    pub(super) statistics: Statistics,
}

/// What there is at the start of some bytes.
pub(super) enum Sight {
    Frame(Header, Facts),
    /// It takes so many bytes to know.
    Unfinished {
        needed: usize,
    },
    /// Nothing; so many bytes further there may be something.
    Nothing {
        passed: usize,
    },
}

impl<'t> Search<'t> {
    pub(super) const fn new(table: &'t Table<'t>) -> Self {
        Self { table, belief: Belief::NEW, damaged: 0, statistics: Statistics::NONE }
    }

    /// What comes next is the beginning of a stream.
    pub(super) fn restart(&mut self) {
        self.belief = Belief::NEW;
        self.damaged = 0;
    }

    /// What there is at the start of these bytes. The next look is at the bytes behind that, or at more bytes if it was
    /// unfinished. `at_end` says that there are no more. `bad_checksum` is told the message of a frame that is counted as
    /// damaged.
    #[inline]
    pub(super) fn look(&mut self, bytes: &[u8], at_end: bool, bad_checksum: &mut impl FnMut(u32)) -> Sight {
        match Facts::of(bytes, self.table) {
            Ok((header, facts)) => {
                if facts.verified {
                    self.belief.hand_over();
                } else if let Some(sight) = self.doubt(bytes, header, at_end) {
                    return sight;
                }
                self.damaged = 0;
                self.statistics.frames += 1;
                Sight::Frame(header, facts)
            }
            Err(FrameError::Incomplete { needed }) if !at_end => Sight::Unfinished { needed },
            Err(error) => self.give_up(bytes, error, bad_checksum),
        }
    }

    /// What there is instead of an unverified frame; `None` if it is believed. Not inlined, nor is what follows: in front
    /// of known frames, both would cost a tenth of the time.
    #[inline(never)]
    fn doubt(&mut self, bytes: &[u8], header: Header, at_end: bool) -> Option<Sight> {
        match self.belief.judge(bytes, header.frame_length(), self.table, at_end) {
            Judgement::Believed => {
                self.belief.believe(header.frame_length());
                self.statistics.unverified += 1;
                None
            }
            Judgement::Refused => Some(self.pass(1)),
            Judgement::Undecided { needed } => Some(Sight::Unfinished { needed }),
        }
    }

    /// Passes over something that is no frame.
    #[inline(never)]
    fn give_up(&mut self, bytes: &[u8], error: FrameError, bad_checksum: &mut impl FnMut(u32)) -> Sight {
        match error {
            // The common case while searching: nothing was found out about the first byte but that it starts nothing.
            FrameError::NotStx { .. } => self.pass(memchr2(STX_V1, STX_V2, bytes).unwrap_or(bytes.len())),
            FrameError::Checksum { id } if self.damaged == 0 => {
                bad_checksum(id);
                self.statistics.bad_checksums += 1;
                self.damaged = Header::read(bytes).map_or(0, Header::frame_length);
                self.pass(1)
            }
            _ => self.pass(1),
        }
    }

    fn pass(&mut self, passed: usize) -> Sight {
        self.belief.pass(passed);
        self.damaged = self.damaged.saturating_sub(passed);
        self.statistics.skipped_bytes += passed as u64;
        Sight::Nothing { passed }
    }
}
