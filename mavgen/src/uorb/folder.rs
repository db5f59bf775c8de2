//! A folder of `.msg` files: each is read when it is asked for.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::source::{FileId, Sources, Span};

/// The files of a folder by name, `EscStatus` for `EscStatus.msg`.
#[derive(Clone, Debug)]
pub(super) struct Folder {
    path: PathBuf,
    files: BTreeMap<String, PathBuf>,
}

impl Folder {
    /// The `.msg` files of a folder, or the one file and those beside it.
    pub(super) fn of(path: &Path) -> Result<Self, Diagnostic> {
        let folder = Self::path_of(path);
        let unreadable = |error: std::io::Error| {
            Diagnostic::without_place(Code::Unreadable, format!("cannot read {}: {error}", folder.display()))
        };
        let mut files = BTreeMap::new();
        for entry in fs::read_dir(folder).map_err(unreadable)? {
            let path = entry.map_err(unreadable)?.path();
            if path.extension().is_some_and(|extension| extension == "msg")
                && let Some(name) = path.file_stem().and_then(|name| name.to_str())
            {
                files.insert(name.to_owned(), path);
            }
        }
        Ok(Self { path: folder.to_owned(), files })
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

    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.files.keys().map(String::as_str)
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.files.contains_key(name)
    }

    /// Adds the file of this message to the sources. `None` if there is none, or if it cannot be read, which is told.
    pub(super) fn open(&self, name: &str, sources: &mut Sources, diagnostics: &mut Diagnostics) -> Option<FileId> {
        let path = self.files.get(name)?;
        let id = crate::read::open(path, sources, diagnostics)?;
        if begins_with_mark(path) {
            let problem =
                Diagnostic::new(Code::UorbEncoding, Span::new(id, 0..0), "the file begins with a byte order mark");
            diagnostics.push(problem.help("save it as UTF-8 without one: PX4's generator does not take it"));
        }
        Some(id)
    }
}

/// Whether the first bytes are a byte order mark; the text in the sources never has it.
fn begins_with_mark(path: &Path) -> bool {
    let mut bytes = [0; 3];
    File::open(path).is_ok_and(|mut file| file.read_exact(&mut bytes).is_ok()) && bytes == *b"\xef\xbb\xbf"
}
