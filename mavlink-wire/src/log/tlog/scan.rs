//! What there is at a place of a log.

use super::{CENTURY_US, DAY_US, Entry, TIME};
use crate::frame::Candidate;
use crate::header::{Header, is_start};
use crate::parser::prefixes::Prefixes;
use crate::seek;
use crate::{Frame, FrameError, Table};

/// The search for entries, from one place to the next.
#[derive(Clone, Debug)]
pub(super) struct Scan<'t> {
    table: &'t Table<'t>,
    prefixes: Prefixes,
    /// Of the entry before; once there is one, all have one.
    time_us: Option<u64>,
    /// Bytes skipped since the entry before, and before it.
    skipped: u64,
    skipped_before: u64,
    /// How many of the next bytes belong to a frame that was taken for a damaged one.
    damaged: usize,
}

/// What there is at the start of some bytes.
pub(super) enum Sight<'b> {
    Entry(Entry<'b>),
    /// It takes more bytes to know, but never more than an entry has.
    Unfinished,
    /// Nothing; so many bytes further there may be something.
    Nothing {
        passed: usize,
    },
}

/// A frame that damage may have made.
struct Unbelievable;

impl<'t> Scan<'t> {
    pub(super) const fn new(table: &'t Table<'t>) -> Self {
        Self { table, prefixes: Prefixes::NEW, time_us: None, skipped: 0, skipped_before: 0, damaged: 0 }
    }

    pub(super) fn skipped_bytes(&self) -> u64 {
        self.skipped_before + self.skipped
    }

    /// What there is at the start of these bytes. The next look is at those behind it, or at more if it was unfinished.
    /// `at_end` says that there are no more. `bad_checksum` is told the message of a damaged frame.
    pub(super) fn look<'b>(&mut self, bytes: &'b [u8], at_end: bool, bad_checksum: impl FnOnce(u32)) -> Sight<'b> {
        let Some((time, rest)) = bytes.split_first_chunk::<TIME>() else {
            return if at_end { self.pass(bytes.len()) } else { Sight::Unfinished };
        };
        let parsed = Candidate::read(rest).and_then(|candidate| {
            let facts =
                candidate.verify(rest, self.table, |end| self.prefixes.checksum(bytes, TIME + 1, TIME + end))?;
            let frame = rest.get(..candidate.header.frame_length()).unwrap_or_default();
            Ok(Frame::with_facts(frame, candidate.header, facts))
        });
        match parsed {
            Ok(frame) => match self.time_of(&frame, u64::from_be_bytes(*time)) {
                Ok(time_us) => Sight::Entry(self.take(frame, time_us)),
                Err(Unbelievable) => self.pass(1),
            },
            Err(FrameError::Incomplete { .. }) if !at_end => Sight::Unfinished,
            Err(error) => {
                if let FrameError::Checksum { message_id } = error
                    && self.damaged == 0
                {
                    bad_checksum(message_id);
                    self.damaged = TIME + Header::read(rest).map_or(0, Header::frame_length);
                }
                let others = rest.get(1..).unwrap_or_default();
                // Without a start, the last bytes may still be the time in front of one.
                self.pass(1 + seek::first(others, is_start).unwrap_or(others.len()))
            }
        }
    }

    /// The time to believe of a frame with this time in front of it, if any, and if the frame is to be believed.
    fn time_of(&self, frame: &Frame<'_>, time_us: u64) -> Result<Option<u64>, Unbelievable> {
        let plausible = match self.time_us {
            Some(before) => before.abs_diff(time_us) <= DAY_US,
            None => CENTURY_US.contains(&time_us),
        };
        match plausible || self.skipped == 0 {
            true => Ok(Some(time_us)),
            false if frame.is_verified() => Ok(self.time_us),
            false => Err(Unbelievable),
        }
    }

    fn take<'b>(&mut self, frame: Frame<'b>, time_us: Option<u64>) -> Entry<'b> {
        self.prefixes.advance(TIME + frame.bytes().len());
        let skipped = core::mem::take(&mut self.skipped);
        self.skipped_before += skipped;
        self.damaged = 0;
        self.time_us = time_us;
        Entry { time_us, frame, skipped }
    }

    fn pass<'b>(&mut self, passed: usize) -> Sight<'b> {
        self.prefixes.advance(passed);
        self.skipped += passed as u64;
        self.damaged = self.damaged.saturating_sub(passed);
        Sight::Nothing { passed }
    }
}
