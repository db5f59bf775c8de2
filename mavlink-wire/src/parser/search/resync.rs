//! Whether a frame of an unknown message is one, although its checksum proves little.
//!
//! The checksum of a false frame is explained by some `crc_extra` in one of 256 cases. So a frame of an unknown message is
//! believed if it stands where a frame has to stand: behind another one, or at the beginning, and directly before the start
//! of the next, or at the end. Or if its message was seen before, behind other frames. Then it carries what starts inside of
//! it. Else it is believed if no known frame starts there.

use super::{Examined, Search, Step};
use crate::MAX_FRAME;
use crate::frame::Facts;
use crate::header::{LONGEST, is_start, to_next_start};

impl Search<'_> {
    /// Whether the unverified frame of this length at the start of `bytes`, which may go on behind it, is to be handed over;
    /// else what to do instead. Not inlined, as `give_up`.
    #[inline(never)]
    pub(super) fn doubt(&mut self, bytes: &[u8], length: usize, facts: Facts, at_end: bool) -> Result<(), Step> {
        let next = bytes.get(length);
        let between = !self.skipped && next.map_or(at_end, |&byte| is_start(byte));
        if !between && !self.sightings.are_alike(facts) {
            match self.search_inside(bytes, length, at_end) {
                Ok(()) => {}
                // What follows the frame may save it.
                Err(_) if !self.skipped && next.is_none() => return Err(Step::Wait { needed: length + 1 }),
                Err(Step::Pass { count }) => return Err(self.pass(count)),
                Err(wait) => return Err(wait),
            }
        }
        if !self.skipped {
            self.sightings.add(facts);
        }
        self.statistics.unverified += 1;
        Ok(())
    }

    /// Searches the first `length` bytes for the start of a known frame, and tells how to go on if there is one. What was found
    /// to start none is not looked at again, however often this is asked.
    fn search_inside(&mut self, bytes: &[u8], length: usize, at_end: bool) -> Result<(), Step> {
        let place = self.prefixes.place();
        let mut at = self.searched.wrapping_sub(place);
        if !(1..=MAX_FRAME).contains(&at) {
            at = 1;
        }
        while at < length {
            self.searched = place.wrapping_add(at);
            let found = match self.examine(bytes.get(..length).unwrap_or_default(), at, false) {
                Examined::Frame(_, facts) => facts.verified,
                // A known frame may end behind this one; but not if another one starts there, nor at the end.
                Examined::Incomplete { .. } => match self.starts(bytes, at, at_end) {
                    Some(true) if bytes.len() > length || !at_end => match self.starts(bytes, length, at_end) {
                        Some(true) => return Ok(()),
                        Some(false) => true,
                        None => return Err(Step::Wait { needed: length + LONGEST }),
                    },
                    None => return Err(Step::Wait { needed: at + LONGEST }),
                    _ => false,
                },
                _ => false,
            };
            if found {
                return Err(Step::Pass { count: 1 });
            }
            at += to_next_start(bytes.get(at..length).unwrap_or_default());
        }
        self.searched = place.wrapping_add(length.max(at));
        Ok(())
    }

    /// Whether a known frame seems to start so many bytes behind the start of these; `None` if it takes more to know.
    fn starts(&mut self, bytes: &[u8], at: usize, at_end: bool) -> Option<bool> {
        let needed = at + LONGEST;
        match self.examine(bytes.get(..needed).unwrap_or(bytes), at, true) {
            Examined::Incomplete { .. } if bytes.len() < needed && !at_end => None,
            Examined::Incomplete { likely, .. } => Some(likely),
            Examined::Frame(_, facts) => Some(facts.verified),
            _ => Some(false),
        }
    }
}
