//! What there is at the start of some bytes, and how to go on where that is nothing.

use super::belief::{Belief, Judgement};
use crate::frame::Facts;
use crate::frame::key::{SETUP_SIGNING, WIPES};
use crate::header::{Header, to_next_start};
use crate::{FrameError, Statistics, Table};

/// The search for frames, from one place to the next.
#[derive(Clone, Debug)]
pub(super) struct Search<'t> {
    table: &'t Table<'t>,
    belief: Belief,
    /// How many of the next bytes belong to a frame that was counted as damaged.
    damaged: usize,
    pub(super) statistics: Statistics,
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

impl<'t> Search<'t> {
    pub(super) const fn new(table: &'t Table<'t>) -> Self {
        Self { table, belief: Belief::NEW, damaged: 0, statistics: Statistics::NONE, found_key: false }
    }

    /// What comes next is the beginning of a stream.
    pub(super) fn restart(&mut self) {
        self.belief = Belief::NEW;
        self.damaged = 0;
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
        match Facts::of(bytes, self.table) {
            Ok((header, facts)) => {
                if facts.verified {
                    self.belief.hand_over();
                } else if let Some(step) = self.doubt(bytes, header.frame_length(), at_end) {
                    return Err(step);
                }
                self.damaged = 0;
                self.statistics.frames += 1;
                self.found_key |= WIPES && facts.id == SETUP_SIGNING;
                Ok((header, facts))
            }
            Err(error) => Err(self.give_up(bytes, error, at_end, bad_checksum)),
        }
    }

    /// What to do instead of handing over an unverified frame; `None` if it is believed. Not inlined, nor is what follows: in
    /// front of known frames, both would cost a tenth of the time.
    #[inline(never)]
    fn doubt(&mut self, bytes: &[u8], length: usize, at_end: bool) -> Option<Step> {
        match self.belief.judge(bytes, length, self.table, at_end) {
            Judgement::Believed => {
                self.belief.believe(length);
                self.statistics.unverified += 1;
                None
            }
            Judgement::Refused => Some(self.pass(1)),
            Judgement::Undecided { needed } => Some(Step::Wait { needed }),
        }
    }

    /// Passes over something that is no frame, if enough of it is there to know.
    #[inline(never)]
    fn give_up(&mut self, bytes: &[u8], error: FrameError, at_end: bool, bad_checksum: &mut impl FnMut(u32)) -> Step {
        match error {
            FrameError::Incomplete { needed } if !at_end => return Step::Wait { needed },
            FrameError::Checksum { message_id } if self.damaged == 0 => {
                bad_checksum(message_id);
                self.statistics.bad_checksums += 1;
                self.damaged = Header::read(bytes).map_or(0, Header::frame_length);
            }
            _ => {}
        }
        self.pass(to_next_start(bytes))
    }

    fn pass(&mut self, count: usize) -> Step {
        self.belief.pass(count);
        self.damaged = self.damaged.saturating_sub(count);
        self.statistics.skipped_bytes += count as u64;
        Step::Pass { count }
    }
}
