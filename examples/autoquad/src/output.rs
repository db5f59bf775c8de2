//! Files that the program writes. None is overwritten unless the user asked for it.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use clap::Args;

use crate::failure::Failure;

/// Whether files may be overwritten.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct Overwriting {
    /// Overwrites the file if it exists.
    #[arg(long)]
    pub(crate) force: bool,
}

impl Overwriting {
    /// Creates a file that is written to as data comes in. It is never the file that is read meanwhile, not even by force.
    pub(crate) fn create(self, path: &Path, read: Option<&Path>) -> Result<File, Failure> {
        not_onto(path, read)?;
        let file = match self.force {
            true => File::create(path),
            false => OpenOptions::new().write(true).create_new(true).open(path),
        };
        file.map_err(|error| refused(path, &error))
    }

    /// Writes a file that is complete from the start. On an error nothing is left of it, and an older file stays as it was.
    pub(crate) fn write(self, path: &Path, bytes: &[u8], read: Option<&Path>) -> Result<(), Failure> {
        not_onto(path, read)?;
        if !self.force {
            drop(self.create(path, read)?);
        }
        let beside = beside(path);
        let result = fs::write(&beside, bytes).and_then(|()| fs::rename(&beside, path));
        result.map_err(|error| {
            let _ = fs::remove_file(&beside);
            if !self.force {
                let _ = fs::remove_file(path);
            }
            Failure::file(path, error)
        })
    }
}

/// Refuses to write onto what is read.
fn not_onto(path: &Path, read: Option<&Path>) -> Result<(), Failure> {
    let (read, written) = (read.and_then(|read| fs::canonicalize(read).ok()), fs::canonicalize(path).ok());
    if written.is_some() && written == read {
        return Err(Failure::file(path, "is what is read; give another name for what is written"));
    }
    Ok(())
}

/// A name in the same folder, for a file that is not complete yet.
fn beside(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(format!(".{}.part", std::process::id()));
    path.with_file_name(name)
}

fn refused(path: &Path, error: &io::Error) -> Failure {
    match error.kind() {
        ErrorKind::AlreadyExists => {
            Failure::file(path, "exists already; give another name, or --force to overwrite it")
        }
        _ => Failure::file(path, error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_overwritten_without_force() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("flight.tlog");
        let (asked, forced) = (Overwriting { force: false }, Overwriting { force: true });
        asked.write(&path, b"first", None).unwrap();
        let Err(Failure::Sentence(sentence)) = asked.write(&path, b"second", None) else { panic!("overwritten") };
        assert!(sentence.contains("exists already") && sentence.contains("--force"), "{sentence}");
        assert!(asked.create(&path, None).is_err());
        assert_eq!(fs::read(&path).unwrap(), b"first");
        forced.write(&path, b"third", None).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"third");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn nothing_is_written_onto_what_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let (log, forced) = (folder.path().join("flight.tlog"), Overwriting { force: true });
        fs::write(&log, b"first").unwrap();
        let (same, other) = (folder.path().join(".").join("flight.tlog"), folder.path().join("other.tlog"));
        assert!(forced.create(&same, Some(&log)).is_err());
        assert!(forced.write(&same, b"second", Some(&log)).is_err());
        assert_eq!(fs::read(&log).unwrap(), b"first");
        assert!(forced.create(&other, Some(&log)).is_ok());
    }

    #[test]
    fn a_folder_that_is_not_there_is_said() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("missing").join("flight.tlog");
        let Err(Failure::Sentence(sentence)) = Overwriting { force: true }.write(&path, b"", None) else {
            panic!("written")
        };
        assert!(sentence.contains("No such file or directory"), "{sentence}");
    }
}
