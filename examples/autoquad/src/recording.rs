//! Recordings: tlogs from files, with a bar while a long one is read.

use std::io::{Cursor, Read};
use std::path::Path;

use indicatif::{ProgressBar, ProgressBarIter};
use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::tlog::{self, Reader};
use mavlink_autoquad::wire::uorb::ulog::{Log, LogError};
use mavlink_autoquad::wire::{Dialect, Frame, FrameBuf};

use crate::failure::Failure;
use crate::input::Input;
use crate::progress;
use crate::time::END_US;

/// As many bytes as the header of a log of PX4 has.
const ULOG_HEADER: u64 = 16;

/// A tlog that is read from its start to its end.
pub(crate) struct Recording {
    /// What users call it.
    pub(crate) name: String,
    reader: Reader<'static, ProgressBarIter<Box<dyn Read>>>,
    bar: ProgressBar,
    /// Its first entry, which shows that it is one: time, frame, and bytes in front of it.
    first: (Option<u64>, FrameBuf, u64),
    begun: bool,
}

/// A frame of a recording. One that claims to be of the year 10000 or later has no time.
pub(crate) struct Entry<'r> {
    /// When it was received, as Unix time in µs, if it is known.
    pub(crate) time_us: Option<u64>,
    pub(crate) frame: Frame<'r>,
    /// Bytes in front of it that belong to no entry.
    pub(crate) skipped: u64,
}

impl<'r> From<tlog::Entry<'r>> for Entry<'r> {
    fn from(tlog::Entry { time_us, frame, skipped, .. }: tlog::Entry<'r>) -> Self {
        Self { time_us: time_us.filter(|&time_us| time_us < END_US), frame, skipped }
    }
}

impl Recording {
    /// Opens a recording.
    ///
    /// # Errors
    ///
    /// If there is no entry in it: then it is something else.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        let Input { name, length, mut bytes } = Input::open(path)?;
        let refused = |error| Failure::with(&name, error);
        let mut head = Vec::new();
        bytes.by_ref().take(ULOG_HEADER).read_to_end(&mut head).map_err(refused)?;
        let bar = progress::bar(length);
        let all: Box<dyn Read> = Box::new(Cursor::new(head.clone()).chain(bytes));
        let mut reader = Reader::new(bar.wrap_read(all), Autoquad::TABLE);
        let first = reader.read().map_err(refused)?.map(Entry::from);
        let first = first.map(|entry| (entry.time_us, entry.frame.into(), entry.skipped));
        let Some(first) = first else { return Err(no_recording(&name, reader.skipped_bytes(), &head)) };
        Ok(Self { name, reader, bar, first, begun: false })
    }

    /// The next entry; `None` at the end.
    pub(crate) fn read(&mut self) -> Result<Option<Entry<'_>>, Failure> {
        if !self.begun {
            self.begun = true;
            let (time_us, frame, skipped) = &self.first;
            return Ok(Some(Entry { time_us: *time_us, frame: frame.as_frame(), skipped: *skipped }));
        }
        let entry = self.reader.read().map_err(|error| Failure::with(&self.name, error))?;
        Ok(entry.map(Entry::from))
    }

    /// Ends the reading, and says what was no entry, if there was any.
    pub(crate) fn finish(self) {
        self.bar.finish_and_clear();
        let (name, skipped) = (self.name, self.reader.skipped_bytes());
        if skipped > 0 {
            eprintln!("autoquad: {name}: {skipped} bytes belong to no entry and were skipped");
        }
    }
}

/// Why a file without an entry, which begins with these bytes, is no recording, and what reads it.
fn no_recording(name: &str, bytes: u64, first: &[u8]) -> Failure {
    Failure::with(
        name,
        match bytes {
            0 => "is empty".to_owned(),
            _ if !matches!(Log::new(first), Err(LogError::NotALog)) => {
                "is a log of PX4, which `autoquad px4-log` reads".to_owned()
            }
            _ => format!(
                "no MAVLink frame in {bytes} bytes, so it is no tlog; `autoquad salvage` reads the .mavlink logs of AutoQuad's \
                 QGroundControl"
            ),
        },
    )
}

#[cfg(test)]
mod tests {
    use std::fs;

    use mavlink_autoquad::px4::EscStatus;
    use mavlink_autoquad::wire::uorb::ulog::Writer;

    use super::*;

    #[test]
    fn what_is_no_recording_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let log = Writer::new(Vec::new(), 0).topic::<EscStatus>().begin().unwrap().finish().unwrap();
        for (bytes, why) in
            [(&log[..], "px4-log"), (&log[..16], "px4-log"), (b"no log at all", "salvage"), (b"", "empty")]
        {
            let path = folder.path().join("flight.tlog");
            fs::write(&path, bytes).unwrap();
            let Err(Failure::Sentence(sentence)) = Recording::open(&path) else { panic!("read: {why}") };
            assert!(sentence.contains(why), "{sentence}");
        }
    }
}
