//! Logs from anything that is read.

use std::io::{Read, Result};

use super::scan::{Scan, Sight};
use super::{Entry, MAX_ENTRY, TIME};
use crate::Table;
use crate::adapters::pause::uninterrupted;
use crate::frame::Outline;

/// Bytes that are held: some entries, and never less than one.
const CHUNK: usize = 4096 + MAX_ENTRY;

/// Reads a log from `R`, which needs no buffer of its own.
#[derive(Debug)]
pub struct Reader<'t, R> {
    inner: R,
    scan: Scan<'t>,
    buffer: [u8; CHUNK],
    /// Still to be searched is `start..end` of the buffer.
    start: usize,
    end: usize,
    ended: bool,
}

impl<'t, R: Read> Reader<'t, R> {
    /// A reader that verifies the messages of this table, and hands over others unverified.
    #[must_use]
    pub const fn new(inner: R, table: &'t Table<'t>) -> Self {
        Self { inner, scan: Scan::new(table), buffer: [0; CHUNK], start: 0, end: 0, ended: false }
    }

    /// The next entry; `None` at the end.
    ///
    /// # Errors
    ///
    /// What `R` says, except for [`Interrupted`](std::io::ErrorKind::Interrupted). Nothing is lost: read again.
    pub fn read(&mut self) -> Result<Option<Entry<'_>>> {
        self.read_reporting_bad_checksums(|_| ())
    }

    /// The next entry, as [`read`](Self::read) gives it. `bad_checksum` is told the message of each frame whose checksum is
    /// wrong, once: if it is often the same one, the log was written by another definition of it.
    ///
    /// # Errors
    ///
    /// As [`read`](Self::read).
    pub fn read_reporting_bad_checksums(&mut self, mut bad_checksum: impl FnMut(u32)) -> Result<Option<Entry<'_>>> {
        let (time_us, outline, skipped) = loop {
            let rest = self.buffer.get(self.start..self.end).unwrap_or_default();
            match self.scan.look(rest, self.ended, &mut bad_checksum) {
                Sight::Entry(Entry { time_us, frame, skipped }) => {
                    self.start += TIME + frame.bytes().len();
                    break (time_us, Outline::of(&frame), skipped);
                }
                Sight::Nothing { passed } if !rest.is_empty() => self.start += passed,
                Sight::Nothing { .. } => {
                    self.ended = false;
                    return Ok(None);
                }
                Sight::Unfinished => self.fill()?,
            }
        };
        let used = self.buffer.get(..self.start).unwrap_or_default();
        Ok(Some(Entry { time_us, frame: outline.at_end_of(used), skipped }))
    }

    /// Reads more behind what is still to be searched.
    fn fill(&mut self) -> Result<()> {
        self.buffer.copy_within(self.start..self.end, 0);
        (self.start, self.end) = (0, self.end - self.start);
        let count = uninterrupted(|| self.inner.read(self.buffer.get_mut(self.end..).unwrap_or_default()))?;
        self.end = CHUNK.min(self.end + count);
        self.ended = count == 0;
        Ok(())
    }
}

impl<R> Reader<'_, R> {
    /// Bytes so far that belong to no entry.
    #[must_use]
    pub fn skipped_bytes(&self) -> u64 {
        self.scan.skipped_bytes()
    }

    /// What is read from.
    #[must_use]
    pub fn get_ref(&self) -> &R {
        &self.inner
    }

    /// What is read from. Bytes that are taken out of it are missing here.
    pub fn get_mut(&mut self) -> &mut R {
        &mut self.inner
    }

    /// What was read from.
    pub fn into_inner(self) -> R {
        self.inner
    }
}
