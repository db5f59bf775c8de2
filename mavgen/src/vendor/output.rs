//! The folder of the copies: no file in it that a person wrote is touched.

use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use super::{Copy, Vendored, header, prose};
use crate::output::{OutputError, write_together};

/// How much of a file is looked at for its header.
const HEAD: u64 = 4096;

/// What [`write()`] did.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// Files that are new or changed.
    pub written: usize,
    /// Files that were already as they should be, and left untouched.
    pub kept: usize,
    /// Copies in the folder that are not of this dialect. They are left alone: another may need them, and somebody may have
    /// written descriptions into them.
    pub others: Vec<PathBuf>,
}

/// Writes copies into a folder, all of them or, if it fails, none. Each file is replaced in one step.
///
/// # Errors
/// Before anything is written: if a copy would replace its own source, a file that is no copy, one that was edited, or one
/// that has descriptions which are neither in the copies nor [`Vendored::unplaced`]. Else, if the system refuses something.
pub fn write(folder: &Path, vendored: &Vendored) -> Result<Written, OutputError> {
    let files = &vendored.files;
    let copies = copies(folder)?;
    files.iter().try_for_each(|file| check(folder, file, vendored))?;
    let written = write_together(folder, files.iter().map(|file| (Path::new(&file.name), &*file.text)))?;
    let is_ours = |path: &PathBuf| files.iter().any(|file| folder.join(&file.name) == *path);
    let mut others: Vec<PathBuf> = copies.into_iter().filter(|path| !is_ours(path)).collect();
    others.sort();
    Ok(Written { written, kept: files.len() - written, others })
}

/// The copies that are in the folder already; none if there is no folder.
fn copies(folder: &Path) -> Result<Vec<PathBuf>, OutputError> {
    let failed = |source| OutputError { path: folder.to_owned(), source };
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(source) => return Err(failed(source)),
    };
    let mut copies = Vec::new();
    for entry in entries {
        let path = entry.map_err(failed)?.path();
        if header::read(&head(&path)).is_some() {
            copies.push(path);
        }
    }
    Ok(copies)
}

/// Refuses to lose what a person wrote.
fn check(folder: &Path, file: &Copy, vendored: &Vendored) -> Result<(), OutputError> {
    let path = folder.join(&file.name);
    // What is not there can be no source either.
    if !path.exists() {
        return Ok(());
    }
    if is_same(&path, &file.source) {
        return Err(refused(path, "this is the file that would be copied: choose another folder"));
    }
    // What is no text has been edited; the digest says so.
    let text = fs::read(&path).map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).unwrap_or_default();
    let why = match header::read(&text) {
        None => "`mavgen vendor` did not write this file: remove it, or choose another folder",
        Some(ours) if !ours.is_as_written() && ours.facts => {
            "more than descriptions was edited in this file: edit its source, or a file that includes it, and undo it here"
        }
        Some(ours) if !ours.is_as_written() => {
            "this file was edited: move the edit to its source, or to a file that includes it, and remove this one"
        }
        Some(ours) if ours.facts && is_here(folder, vendored) => {
            if vendored.left_out.iter().all(|words| words.file.file_name() != path.file_name()) {
                return Ok(());
            }
            "this file has descriptions of what `--messages` leaves out: choose another folder, or remove it"
        }
        Some(ours) if ours.facts && prose::is_lost(&text, vendored.files.iter().map(|file| &*file.text)) => {
            "this file has descriptions of its own: keep them with `--prose-from` its folder, or remove it"
        }
        Some(_) => return Ok(()),
    };
    Err(refused(path, why))
}

/// Whether the descriptions are those of the folder itself.
fn is_here(folder: &Path, vendored: &Vendored) -> bool {
    vendored.words_from.as_ref().is_some_and(|from| is_same(from, folder))
}

/// Whether two paths lead to one file or folder; on Unix also by a hard link.
fn is_same(one: &Path, other: &Path) -> bool {
    #[cfg(unix)]
    let identity = |path: &Path| {
        use std::os::unix::fs::MetadataExt as _;
        fs::metadata(path).map(|there| (there.dev(), there.ino()))
    };
    #[cfg(not(unix))]
    let identity = |path: &Path| fs::canonicalize(path);
    identity(one).ok().zip(identity(other).ok()).is_some_and(|(one, other)| one == other)
}

fn refused(path: PathBuf, text: &str) -> OutputError {
    OutputError { path, source: io::Error::other(text.to_owned()) }
}

/// The start of a file; nothing of one that cannot be read.
fn head(path: &Path) -> String {
    let mut head = Vec::new();
    // A folder, or a file that may not be read, is no copy of ours.
    let _ = fs::File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head));
    String::from_utf8_lossy(&head).into_owned()
}
