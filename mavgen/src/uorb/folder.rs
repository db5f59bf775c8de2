//! A folder of `.msg` files: each is read when it is asked for.

use std::fs;
use std::path::{Path, PathBuf};

use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::order;
use crate::source::{FileId, SourceFile, Sources, Span};

/// PX4's own tree has the messages that have versions in a folder of this name, below that of the others.
const VERSIONED: &str = "versioned";

/// Files in the order of their names, `EscStatus` for `EscStatus.msg`.
type Files = Vec<(String, PathBuf)>;

/// The files of a folder.
#[derive(Clone, Debug)]
pub(super) struct Folder {
    path: PathBuf,
    files: Files,
    /// What its messages may nest as well.
    beside: Files,
}

impl Folder {
    /// The `.msg` files of a folder, or the one file and those beside it.
    pub(super) fn of(path: &Path) -> Result<Self, Diagnostic> {
        let folder = Self::path_of(path);
        let unreadable = |error: std::io::Error| {
            Diagnostic::without_place(Code::Unreadable, format!("cannot read {}: {error}", folder.display()))
        };
        let (versioned, above) = (folder.join(VERSIONED), folder.join(".."));
        let versioned = versioned.is_dir().then_some(versioned.as_path());
        let above = folder.ends_with(VERSIONED).then_some(above.as_path());
        let files = files(std::iter::once(folder).chain(versioned)).map_err(unreadable)?;
        let beside = self::files(above).map_err(unreadable)?;
        let found = Self { path: folder.to_owned(), files, beside };
        if path == folder && found.files.is_empty() {
            let message = format!("no `.msg` file is in {}", folder.display());
            return Err(Diagnostic::without_place(Code::Unreadable, message));
        }
        let is_there = found.meant(path).all(|name| of(&found.files, name).is_some());
        is_there
            .then_some(found)
            .ok_or_else(|| Diagnostic::without_place(Code::Unreadable, format!("there is no file {}", path.display())))
    }

    /// The folder that this is, or that this `.msg` file is in.
    pub(super) fn path_of(path: &Path) -> &Path {
        if path.is_dir() || path.extension().is_none_or(|extension| extension != "msg") {
            return path;
        }
        path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
    }

    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// The messages that `path` means, from which this was made: all of the folder, or the one.
    pub(super) fn meant<'f>(&'f self, path: &'f Path) -> impl Iterator<Item = &'f str> {
        let one = path.file_stem().and_then(|name| name.to_str()).filter(|_| !path.is_dir());
        let all = path.is_dir().then(|| self.files.iter().map(|(name, _)| name.as_str()));
        one.into_iter().chain(all.into_iter().flatten())
    }

    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.files.iter().chain(&self.beside).map(|(name, _)| name.as_str())
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.get(name).is_some()
    }

    fn get(&self, name: &str) -> Option<&Path> {
        of(&self.files, name).or_else(|| of(&self.beside, name))
    }

    /// The bytes of the file of this message, if there is one.
    pub(super) fn load(&self, name: &str) -> Option<std::io::Result<Vec<u8>>> {
        self.get(name).map(crate::read::bytes_of)
    }

    /// Adds the file of this message, whose bytes these are, to the sources. `None` if it cannot be read, which is told.
    pub(super) fn open(
        &self,
        name: &str,
        bytes: std::io::Result<Vec<u8>>,
        sources: &mut Sources,
        diagnostics: &mut Diagnostics,
    ) -> Option<FileId> {
        let path = self.get(name)?;
        let id = crate::read::open(path, bytes, sources, diagnostics)?;
        if sources.get(id).is_some_and(SourceFile::begins_with_mark) {
            let problem =
                Diagnostic::new(Code::UorbEncoding, Span::new(id, 0..0), "the file begins with a byte order mark");
            diagnostics.push(problem.help("save it as UTF-8 without one: PX4's generator does not take it"));
        }
        Some(id)
    }
}

/// The `.msg` files of folders, by name; of two with one name, that in the folder named first.
fn files<'f>(folders: impl IntoIterator<Item = &'f Path>) -> std::io::Result<Files> {
    let mut files = Files::new();
    for folder in folders {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if path.extension().is_some_and(|extension| extension == "msg")
                && let Some(name) = path.file_stem().and_then(|name| name.to_str())
            {
                files.push((name.to_owned(), path));
            }
        }
    }
    order::sort_by_key(&mut files, |(name, _)| name.clone());
    files.dedup_by(|(later, _), (first, _)| later == first);
    Ok(files)
}

fn of<'f>(files: &'f Files, name: &str) -> Option<&'f Path> {
    let at = files.binary_search_by(|(known, _)| known.as_str().cmp(name)).ok()?;
    files.get(at).map(|(_, path)| path.as_path())
}
