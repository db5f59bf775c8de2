//! All or nothing: what is new is written beside the tree first, and what was there is kept until all of it is in place.
//!
//! Writing is what fails, for want of space or permission, and it comes first. Renaming needs neither; should it fail all the
//! same, what was renamed before is taken back.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, SystemTime};

use super::OutputError;
use crate::collect::CollectVec as _;

/// The first letters of the folder in the output folder that holds what is new, until it is in place. The rest is a number of
/// the process and one of the run in it: runs side by side, which tests and build scripts are, do not see each other.
const STAGING: &str = ".mavgen-staging";

/// A staging folder of that age is of a run that was killed.
const ABANDONED: Duration = Duration::from_secs(3600);

/// Changes to a folder that are made together.
pub(super) struct Staged<'f> {
    folder: &'f Path,
    staging: PathBuf,
    /// Folders that were made, each after the one that it lies in.
    made: Vec<PathBuf>,
    steps: Vec<Step>,
    /// How many of the steps are done.
    done: usize,
}

/// What becomes of one file.
struct Step {
    /// Its path in the folder.
    path: PathBuf,
    /// Whether it is replaced; if not, it is removed.
    wanted: bool,
    /// Whether there was one before.
    present: bool,
}

impl<'f> Staged<'f> {
    /// Makes the folder hold what is new, and no longer what is stale.
    pub(super) fn replace(folder: &'f Path, new: &[(&Path, &str)], stale: &[PathBuf]) -> Result<(), OutputError> {
        if new.is_empty() && stale.is_empty() {
            return Ok(());
        }
        let mut staged = Self::new(folder);
        let replaced = staged.prepare(new, stale).and_then(|()| staged.commit());
        if replaced.is_err() {
            staged.undo();
        }
        // If the staging folder cannot be removed the tree is no worse for it, and a later run removes it.
        let _ = fs::remove_dir_all(&staged.staging);
        // Folders are removed only if they are empty, and those that are not have to stay.
        if replaced.is_err() {
            staged.made.iter().rev().for_each(|folder| drop(fs::remove_dir(folder)));
        } else {
            let above = stale.iter().flat_map(|path| path.ancestors().skip(1));
            let below = above.filter(|above| !above.as_os_str().is_empty());
            below.for_each(|emptied| drop(fs::remove_dir(folder.join(emptied))));
        }
        replaced
    }

    pub(super) fn new(folder: &'f Path) -> Self {
        static RUNS: AtomicUsize = AtomicUsize::new(0);
        let run = RUNS.fetch_add(1, Ordering::Relaxed);
        let staging = folder.join(format!("{STAGING}-{}-{run}", std::process::id()));
        Self { folder, staging, made: Vec::new(), steps: Vec::new(), done: 0 }
    }

    /// Where a new file waits.
    fn new_file(&self, path: &Path) -> PathBuf {
        self.staging.join("new").join(path)
    }

    /// Where an old file is kept.
    fn old_file(&self, path: &Path) -> PathBuf {
        self.staging.join("old").join(path)
    }

    /// Writes what is new beside the tree, keeps what is there, and makes the folders: all that can fail for good reasons.
    pub(super) fn prepare(&mut self, new: &[(&Path, &str)], stale: &[PathBuf]) -> Result<(), OutputError> {
        remove_abandoned(self.folder);
        for &(path, text) in new {
            self.make_parent(&self.folder.join(path))?;
            self.keep(path, true)?;
            self.make_parent(&self.new_file(path))?;
            fs::write(self.new_file(path), text).map_err(|error| self.failed(path, error))?;
        }
        stale.iter().try_for_each(|path| self.keep(path, false))
    }

    /// Keeps what is there of a file, and notes what becomes of it.
    fn keep(&mut self, path: &Path, wanted: bool) -> Result<(), OutputError> {
        let at = self.folder.join(path);
        let present = at.symlink_metadata();
        if present.as_ref().is_ok_and(|present| present.is_dir()) {
            return Err(self.failed(path, io::Error::other("there is a folder of that name: move or delete it")));
        }
        if present.is_ok() {
            let old = self.old_file(path);
            self.make_parent(&old)?;
            // Not every file system has links.
            let kept = fs::hard_link(&at, &old).or_else(|_| fs::copy(&at, &old).map(drop));
            unless(io::ErrorKind::NotFound, kept).map_err(|error| self.failed(path, error))?;
        }
        self.steps.push(Step { path: path.to_owned(), wanted, present: present.is_ok() });
        Ok(())
    }

    /// Puts everything in place.
    pub(super) fn commit(&mut self) -> Result<(), OutputError> {
        for step in &self.steps {
            let at = self.folder.join(&step.path);
            let done = if step.wanted {
                fs::rename(self.new_file(&step.path), &at)
            } else {
                unless(io::ErrorKind::NotFound, fs::remove_file(&at))
            };
            done.map_err(|error| self.failed(&step.path, error))?;
            self.done += 1;
        }
        Ok(())
    }

    /// Takes back what was put in place. There is nobody to tell if that fails as well: the first error is the one to tell.
    pub(super) fn undo(&mut self) {
        for step in self.steps.iter().take(self.done).rev() {
            let at = self.folder.join(&step.path);
            let _ = if step.present { fs::rename(self.old_file(&step.path), &at) } else { fs::remove_file(&at) };
        }
        self.done = 0;
    }

    /// Makes the folder that a file lies in, and those above it.
    fn make_parent(&mut self, file: &Path) -> Result<(), OutputError> {
        let above = file.ancestors().skip(1);
        let missing = above.take_while(|folder| !folder.as_os_str().is_empty() && !folder.is_dir()).collect_vec();
        for folder in missing.into_iter().rev() {
            let made = fs::create_dir(folder);
            let made = if folder.is_dir() { unless(io::ErrorKind::AlreadyExists, made) } else { made };
            made.map_err(|error| self.not_made(folder, error))?;
            self.made.push(folder.to_owned());
        }
        Ok(())
    }

    /// Nobody has to know of the staging folder: that it cannot be made is said of the folder that it lies in.
    fn not_made(&self, folder: &Path, error: io::Error) -> OutputError {
        let named = if folder.starts_with(&self.staging) { self.folder } else { folder };
        match error.kind() {
            io::ErrorKind::AlreadyExists => {
                let text = "there is something of that name that is no folder: move or delete it";
                OutputError::new(named, io::Error::other(text))
            }
            _ => OutputError::new(named, error),
        }
    }

    fn failed(&self, path: &Path, error: io::Error) -> OutputError {
        OutputError::new(&self.folder.join(path), error)
    }
}

/// Another run may have been there first; that is as good.
fn unless(expected: io::ErrorKind, result: io::Result<()>) -> io::Result<()> {
    result.or_else(|error| if error.kind() == expected { Ok(()) } else { Err(error) })
}

/// Removes staging folders of runs that were killed. One that cannot be removed is in nobody's way.
fn remove_abandoned(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let age = || SystemTime::now().duration_since(entry.metadata()?.modified()?).map_err(io::Error::other);
        if is_staging(&entry) && age().is_ok_and(|age| age > ABANDONED) {
            let _ = fs::remove_dir_all(entry.path());
        }
    }
}

/// Whether this is a folder of a run, of this one or another.
pub(super) fn is_staging(entry: &fs::DirEntry) -> bool {
    entry.file_name().as_encoded_bytes().starts_with(STAGING.as_bytes())
        && entry.file_type().is_ok_and(|kind| kind.is_dir())
}
