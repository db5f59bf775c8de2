//! Logs and streams that were kept.

use std::fs::File;
use std::io::{ErrorKind, Read, Seek};
use std::path::Path;
use std::time::Duration;
use std::vec::Vec;

use super::{Inbox, LinkError, Peer};
use crate::{Frame, Statistics, Table, tlog};

/// Bytes at the start of a file that tell what it is.
const HEAD: u64 = 4096;

/// A file.
pub(super) struct Recording {
    pub(super) file: File,
    /// A time stands in front of each frame. Else there are frames, and perhaps others' bytes between them.
    pub(super) is_log: bool,
}

/// A stream that was kept. Its end is told once what was before it is handed over.
pub(super) struct Kept<F> {
    pub(super) file: F,
    ended: bool,
}

impl<F> Kept<F> {
    pub(super) const fn new(file: F) -> Self {
        Self { file, ended: false }
    }

    /// An error, if the end is to be told.
    pub(super) fn check(&mut self) -> Result<(), LinkError> {
        if core::mem::take(&mut self.ended) { Err(LinkError::Ended) } else { Ok(()) }
    }

    /// Takes what was read; nothing is the end.
    pub(super) fn take(&mut self, inbox: &mut Inbox<'_>, length: usize) {
        self.ended = length == 0;
        if self.ended { inbox.end() } else { inbox.fill(length, Peer::NEARBY, Duration::ZERO) }
    }
}

/// The reader of a log, and what it found.
pub(super) struct Log<R> {
    reader: tlog::Reader<'static, R>,
    found: Statistics,
}

impl Recording {
    pub(super) fn open(path: &str, table: &'static Table<'static>) -> Result<Self, LinkError> {
        let open = || {
            let mut file = File::open(path)?;
            if file.metadata()?.is_dir() {
                return Err(ErrorKind::IsADirectory.into());
            }
            let is_log = is_called_log(path) || begins_like_log(&mut file, table)?;
            Ok(Self { file, is_log })
        };
        open().map_err(|error| LinkError::of_file(error, path))
    }
}

impl<R: Read> Log<R> {
    pub(super) fn new(input: R, table: &'static Table<'static>) -> Self {
        Self { reader: tlog::Reader::new(input, table), found: Statistics::default() }
    }

    /// The next frame; `None` at the end.
    pub(super) fn next(&mut self) -> std::io::Result<Option<Frame<'_>>> {
        let Self { reader, found } = self;
        let entry = reader.read_reporting_bad_checksums(|_| found.bad_checksums += 1)?;
        if let Some(entry) = &entry {
            found.frames += 1;
            found.unverified += u64::from(!entry.frame.is_verified());
        }
        Ok(entry.map(|entry| entry.frame))
    }

    /// What is read from.
    #[cfg(feature = "tokio")]
    pub(super) fn input(&mut self) -> &mut R {
        self.reader.get_mut()
    }

    pub(super) fn statistics(&self) -> Statistics {
        Statistics { skipped_bytes: self.reader.skipped_bytes(), ..self.found }
    }
}

fn is_called_log(path: &str) -> bool {
    Path::new(path).extension().is_some_and(|extension| extension.eq_ignore_ascii_case("tlog"))
}

/// Whether the first frame has a time in front. Of a stream, or of what is no file to go back in, nothing is used up.
fn begins_like_log(file: &mut File, table: &Table<'_>) -> std::io::Result<bool> {
    if file.rewind().is_err() {
        return Ok(false);
    }
    let mut head = Vec::new();
    file.by_ref().take(HEAD).read_to_end(&mut head)?;
    file.rewind()?;
    let first = tlog::entries(&head, table).next();
    Ok(first
        .is_some_and(|entry| entry.skipped == 0 && entry.time_us.is_some_and(|time| tlog::CENTURY_US.contains(&time))))
}
