//! Recordings: tlogs from files, with a bar while a long one is read.

use std::fs::File;
use std::io::{Read, Seek};
use std::path::{Path, PathBuf};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressBarIter, ProgressStyle};
use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::Dialect;
use mavlink_autoquad::wire::tlog::{Entry, Reader};
use mavlink_autoquad::wire::uorb::ulog::{Log, LogError};

use crate::failure::Failure;

/// Bytes from which on a bar is shown.
const LONG: u64 = 8 << 20;

/// As many bytes as the header of a log of PX4 has.
const ULOG_HEADER: u64 = 16;

/// A tlog that is read from its start to its end.
pub(crate) struct Recording {
    path: PathBuf,
    reader: Reader<'static, ProgressBarIter<File>>,
    bar: ProgressBar,
}

impl Recording {
    /// Opens a recording.
    ///
    /// # Errors
    ///
    /// If there is no entry in it: then it is something else.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        let refused = |error| Failure::file(path, error);
        let mut file = File::open(path).map_err(refused)?;
        let metadata = file.metadata().map_err(refused)?;
        if metadata.is_dir() {
            return Err(Failure::file(path, "is a folder, not a recording"));
        }
        let bytes = metadata.len();
        if Reader::new(&mut file, Autoquad::TABLE).read().map_err(refused)?.is_none() {
            let mut first = Vec::new();
            file.rewind().and_then(|()| file.take(ULOG_HEADER).read_to_end(&mut first)).map_err(refused)?;
            return Err(no_recording(path, bytes, &first));
        }
        file.rewind().map_err(refused)?;
        let bar = bar(bytes);
        let reader = Reader::new(bar.wrap_read(file), Autoquad::TABLE);
        Ok(Self { path: path.to_owned(), reader, bar })
    }

    /// The next entry; `None` at the end.
    pub(crate) fn read(&mut self) -> Result<Option<Entry<'_>>, Failure> {
        self.reader.read().map_err(|error| Failure::file(&self.path, error))
    }

    /// Ends the reading, and says what was no entry, if there was any.
    pub(crate) fn finish(self) {
        self.bar.finish_and_clear();
        let (path, skipped) = (self.path.display(), self.reader.skipped_bytes());
        if skipped > 0 {
            eprintln!("autoquad: {path}: {skipped} bytes belong to no entry and were skipped");
        }
    }
}

/// Why a file without an entry, which begins with these bytes, is no recording, and what reads it.
fn no_recording(path: &Path, bytes: u64, first: &[u8]) -> Failure {
    Failure::file(
        path,
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

/// A whole file in memory, with a bar if it is long.
pub(crate) fn read_whole(path: &Path) -> Result<Vec<u8>, Failure> {
    let refused = |error| Failure::file(path, error);
    let file = File::open(path).map_err(refused)?;
    let length = file.metadata().map_err(refused)?.len();
    let bar = bar(length);
    let mut bytes = Vec::with_capacity(usize::try_from(length).unwrap_or_default());
    bar.wrap_read(file).read_to_end(&mut bytes).map_err(refused)?;
    bar.finish_and_clear();
    Ok(bytes)
}

/// A bar on standard error; hidden for short work, and where nobody sees it.
pub(crate) fn bar(bytes: u64) -> ProgressBar {
    if bytes < LONG {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{wide_bar} {bytes} of {total_bytes}, {eta} to go");
    let bar = ProgressBar::new(bytes).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
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
