//! The records of a log, one after the other; what is damaged is passed over.

use super::sections::Sections;
use crate::seek;

/// A record of a log: its kind and its payload.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Record<'a> {
    /// The letter that stands for the kind: `b'D'` for data.
    pub kind: u8,
    /// What follows the header of three bytes.
    pub payload: &'a [u8],
}

/// How a log ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum End {
    /// With a whole record.
    #[default]
    Complete,
    /// Inside a record: the logger was cut off, as in a crash.
    Truncated,
    /// Something in it is no record; what follows was found again by a synchronisation record, if there was one.
    Damaged {
        /// Offset in the file of the first byte that could not be read.
        at: usize,
    },
}

/// The kinds of records that a ULog has.
const KINDS: &[u8] = b"ABCDFILMOPQRS";

/// A whole synchronisation record.
const SYNC: [u8; 11] = [8, 0, b'S', 0x2f, 0x73, 0x13, 0x20, 0x25, 0x0c, 0xbb, 0x12];

/// Iterates over the records of a log. Takes time linear in the file, whatever is in it.
#[derive(Clone, Debug)]
pub struct Records<'a> {
    sections: Sections<'a>,
    section: &'a [u8],
    end: End,
}

impl<'a> Records<'a> {
    pub(super) fn new(sections: Sections<'a>) -> Self {
        Self { sections, section: &[], end: End::Complete }
    }

    /// How the log ends, as far as it was read: final when the iterator has given `None`.
    #[must_use]
    pub const fn end(&self) -> End {
        self.end
    }

    /// Offset in the file of the next record.
    #[must_use]
    pub(super) fn offset(&self) -> usize {
        self.sections.offset().saturating_sub(self.section.len())
    }

    /// Goes on behind a place that is no record.
    fn recover(&mut self) {
        let at = self.offset();
        // Not at the place itself: a synchronisation record there would have been read.
        let found = self.section.get(1..).and_then(synchronised);
        let damaged = found.is_some() || !self.is_cut();
        if damaged && !matches!(self.end, End::Damaged { .. }) {
            self.end = End::Damaged { at };
        } else if self.end == End::Complete && self.sections.is_last() {
            self.end = End::Truncated;
        }
        self.section = found.unwrap_or_default();
    }

    /// Whether what is left could be the beginning of a record.
    fn is_cut(&self) -> bool {
        self.section.get(2).is_none_or(|kind| KINDS.contains(kind))
    }
}

/// What begins with the first synchronisation record. Looks for a byte of its magic: a search for all of it could panic, as far as
/// a linker can see.
fn synchronised(bytes: &[u8]) -> Option<&[u8]> {
    const MAGIC_AT: usize = 3;
    let first = SYNC.get(MAGIC_AT).copied()?;
    let mut from = MAGIC_AT;
    loop {
        let at = from + seek::first(bytes.get(from..)?, |byte| byte == first)?;
        let found = bytes.get(at - MAGIC_AT..).filter(|rest| rest.starts_with(&SYNC));
        if found.is_some() {
            return found;
        }
        from = at + 1;
    }
}

impl<'a> Iterator for Records<'a> {
    type Item = Record<'a>;

    #[inline]
    fn next(&mut self) -> Option<Record<'a>> {
        loop {
            if self.section.is_empty() {
                self.section = self.sections.next()?;
                continue;
            }
            if let [low, high, kind, rest @ ..] = self.section
                && KINDS.contains(kind)
                && let Some((payload, rest)) = rest.split_at_checked(u16::from_le_bytes([*low, *high]).into())
            {
                self.section = rest;
                return Some(Record { kind: *kind, payload });
            }
            self.recover();
        }
    }
}
