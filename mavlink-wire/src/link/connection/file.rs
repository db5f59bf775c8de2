//! Logs and streams that were kept.

use std::boxed::Box;
use std::fs::File;
use std::io::{ErrorKind, Read, Seek};
use std::path::Path;
use std::vec;

use crate::link::LinkError;
use crate::{Frame, Statistics, Table, tlog};

/// Bytes at the start of a file that tell what it is.
const HEAD: usize = 4096;

/// A file, and how it is read.
pub(in crate::link) enum Recording {
    /// Frames, and perhaps others' bytes between them.
    Stream(File),
    /// A time in front of each frame.
    Log(Box<Log>),
}

/// The reader of a log, and what it found.
pub(in crate::link) struct Log {
    reader: tlog::Reader<'static, File>,
    found: Statistics,
}

impl Recording {
    pub(in crate::link) fn open(path: &str, table: &'static Table<'static>) -> Result<Self, LinkError> {
        let open = || {
            let mut file = File::open(path)?;
            if file.metadata()?.is_dir() {
                return Err(ErrorKind::IsADirectory.into());
            }
            let is_log = is_called_log(path) || begins_like_log(&mut file, table)?;
            Ok((file, is_log))
        };
        let (file, is_log) = open().map_err(|error| LinkError::of_file(error, path))?;
        Ok(if is_log {
            Self::Log(Box::new(Log { reader: tlog::Reader::new(file, table), found: Statistics::default() }))
        } else {
            Self::Stream(file)
        })
    }
}

impl Log {
    /// The next frame; `None` at the end.
    pub(in crate::link) fn next(&mut self) -> Result<Option<Frame<'_>>, LinkError> {
        let Self { reader, found } = self;
        let entry = reader.read_reporting_bad_checksums(|_| found.bad_checksums += 1).map_err(LinkError::Io)?;
        if let Some(entry) = &entry {
            found.frames += 1;
            found.unverified += u64::from(!entry.frame.is_verified());
        }
        Ok(entry.map(|entry| entry.frame))
    }

    pub(in crate::link) fn statistics(&self) -> Statistics {
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
    let mut head = vec![0; HEAD];
    let mut length = 0;
    while let Some(space) = head.get_mut(length..).filter(|space| !space.is_empty()) {
        match file.read(space) {
            Ok(0) => break,
            Ok(count) => length += count,
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    file.rewind()?;
    let head = head.get(..length).unwrap_or_default();
    let first = tlog::entries(head, table).next();
    Ok(first
        .is_some_and(|entry| entry.skipped == 0 && entry.time_us.is_some_and(|time| tlog::CENTURY_US.contains(&time))))
}
