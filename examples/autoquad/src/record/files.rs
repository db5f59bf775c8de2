//! The files of a recording: one, or one after another.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use mavlink_autoquad::wire::Frame;
use mavlink_autoquad::wire::tlog::{MAX_ENTRY, encode};

use crate::failure::Failure;
use crate::output::{Output, Overwriting};

/// When another file begins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Rotation {
    pub(super) bytes: Option<u64>,
    pub(super) time: Option<Duration>,
}

/// The files that are written.
pub(super) struct Files {
    first: PathBuf,
    read: Option<PathBuf>,
    overwriting: Overwriting,
    rotation: Rotation,
    number: u32,
    current: Current,
    frames: u64,
}

/// The file that is written now.
struct Current {
    output: Output,
    bytes: u64,
    since: Instant,
}

impl Current {
    fn create(path: &Path, read: Option<&Path>, overwriting: Overwriting) -> Result<Self, Failure> {
        Ok(Self { output: overwriting.growing(path, read)?.of_bytes()?, bytes: 0, since: Instant::now() })
    }

    fn write(&mut self, entry: &[u8]) -> Result<(), Failure> {
        self.bytes += entry.len() as u64;
        self.output.write_all(entry).map_err(Failure::written)
    }
}

impl Files {
    /// Begins the first file. None of them is the file that is `read`.
    pub(super) fn create(
        path: &Path,
        read: Option<PathBuf>,
        overwriting: Overwriting,
        rotation: Rotation,
    ) -> Result<Self, Failure> {
        let current = Current::create(path, read.as_deref(), overwriting)?;
        if rotation != Rotation::default() && !current.output.is_file() {
            return Err(Failure::file(
                path,
                "is no file, so there cannot be a second one; leave out --rotate-size and --rotate-time",
            ));
        }
        Ok(Self { first: path.to_owned(), read, overwriting, rotation, number: 1, current, frames: 0 })
    }

    /// Writes a frame that was received at this Unix time in µs.
    pub(super) fn write(&mut self, time_us: u64, frame: &Frame<'_>) -> Result<(), Failure> {
        if self.is_full() {
            self.rotate()?;
        }
        let mut buffer = [0; MAX_ENTRY];
        if let Some(entry) = encode(time_us, frame, &mut buffer) {
            self.current.write(entry)?;
            self.frames += 1;
        }
        Ok(())
    }

    /// Gives to the system what was written.
    pub(super) fn flush(&mut self) -> Result<(), Failure> {
        self.current.output.flush().map_err(Failure::written)
    }

    /// What users call the file that is written now.
    pub(super) fn name(&self) -> &str {
        self.current.output.name()
    }

    /// Ends the last file, and gives the number of all frames.
    pub(super) fn finish(self) -> Result<u64, Failure> {
        self.current.output.finish()?;
        Ok(self.frames)
    }

    fn is_full(&self) -> bool {
        let Current { bytes, since, .. } = &self.current;
        self.rotation.bytes.is_some_and(|most| *bytes >= most)
            || self.rotation.time.is_some_and(|most| since.elapsed() >= most)
    }

    /// Begins the next file. Where one of its name is there, it takes the next number: a recording goes on.
    fn rotate(&mut self) -> Result<(), Failure> {
        loop {
            self.number += 1;
            let path = numbered(&self.first, self.number);
            if self.overwriting.force || !path.exists() {
                let next = Current::create(&path, self.read.as_deref(), self.overwriting)?;
                return std::mem::replace(&mut self.current, next).output.finish();
            }
        }
    }
}

/// `flight.tlog` with the number 2 is `flight-2.tlog`.
fn numbered(first: &Path, number: u32) -> PathBuf {
    let mut name = first.file_stem().unwrap_or_default().to_os_string();
    name.push(format!("-{number}"));
    if let Some(extension) = first.extension() {
        name.push(".");
        name.push(extension);
    }
    first.with_file_name(name)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::recording::Recording;
    use crate::simulate::flight;

    #[test]
    fn files_follow_each_other_without_a_loss() {
        let folder = tempfile::tempdir().unwrap();
        let (log, copy) = (folder.path().join("flight.tlog"), folder.path().join("copy.tlog"));
        flight(&log, 4, 20, 1_462_017_600_000_000);
        // Somebody's recording is in the way of the second file.
        fs::write(folder.path().join("copy-2.tlog"), b"mine").unwrap();
        let rotation = Rotation { bytes: Some(20_000), time: None };
        let mut files = Files::create(&copy, None, Overwriting::default(), rotation).unwrap();
        let (mut recording, mut written) = (Recording::open(&log).unwrap(), 0);
        while let Some(entry) = recording.read().unwrap() {
            files.write(entry.time_us.unwrap(), &entry.frame).unwrap();
            written += 1;
        }
        assert_eq!(files.finish().unwrap(), written);
        assert_eq!(fs::read(folder.path().join("copy-2.tlog")).unwrap(), b"mine");
        let parts = [None, Some(3), Some(4), Some(5)]
            .map(|number| number.map_or(copy.clone(), |number| numbered(&copy, number)));
        let bytes: Vec<u8> = parts.iter().filter_map(|path| fs::read(path).ok()).flatten().collect();
        assert_eq!(bytes, fs::read(&log).unwrap());
        assert!(fs::metadata(&copy).unwrap().len() < 20_300);
        assert!(Files::create(&copy, None, Overwriting::default(), rotation).is_err());
    }

    #[test]
    fn a_recording_that_is_read_is_not_overwritten() {
        let folder = tempfile::tempdir().unwrap();
        let log = folder.path().join("flight.tlog");
        fs::write(&log, b"mine").unwrap();
        let (forced, rotation) = (Overwriting { force: true }, Rotation { bytes: None, time: None });
        assert!(Files::create(&log, Some(log.clone()), forced, rotation).is_err());
        assert_eq!(fs::read(&log).unwrap(), b"mine");
    }

    #[test]
    fn numbers_stand_before_the_extension() {
        assert_eq!(numbered(Path::new("a/flight.tlog"), 2), Path::new("a/flight-2.tlog"));
        assert_eq!(numbered(Path::new("flight"), 12), Path::new("flight-12"));
    }
}
