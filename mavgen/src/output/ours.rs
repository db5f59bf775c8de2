//! Which files of a folder are ours: those that begin with our header.

use std::collections::HashSet;
use std::fs::{self, DirEntry, File};
use std::io::{BufRead, BufReader, ErrorKind, Read};
use std::path::{Path, PathBuf};

use super::OutputError;
use crate::collect::CollectVec as _;
use crate::emit::GeneratedFile;
use crate::lower::{MARK, ROOT_MARK};
use crate::order;

/// How many folders below the top one may hold files of ours.
const DEEPEST: usize = 3;

/// The generated files of a tree, by their paths in it.
pub(super) struct Ours(Vec<PathBuf>);

impl Ours {
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Those that are not among `files`, by path.
    pub(super) fn stale(&self, files: &[GeneratedFile]) -> Vec<PathBuf> {
        let wanted: HashSet<PathBuf> = files.iter().map(|file| PathBuf::from(&file.path)).collect();
        self.0.iter().filter(|path| !wanted.contains(*path)).cloned().collect_vec()
    }
}

/// The generated files in `folder` and below it; none if there is no such folder, or if none lies in it itself: then a tree below
/// is another one, and `folder` is a place that many things lie in.
///
/// Links to folders are not followed: what is behind them may be reached, and claimed, on another way.
pub(super) fn ours(folder: &Path) -> Result<Ours, OutputError> {
    let mut ours = Vec::new();
    let mut open = vec![PathBuf::new()];
    while let Some(below) = open.pop() {
        let entries = match fs::read_dir(folder.join(&below)) {
            Ok(entries) => entries,
            // There is no folder yet, or one below it is nobody's that we know.
            Err(error) if error.kind() == ErrorKind::NotFound || below != Path::new("") => continue,
            Err(error) => return Err(OutputError::new(folder, error)),
        };
        for entry in entries.filter_map(Result::ok) {
            let path = below.join(entry.file_name());
            if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
                open.extend((path.components().count() <= DEEPEST && may_be_ours(&entry)).then_some(path));
            } else if path.extension().is_some_and(|extension| extension == "rs") && has_mark(&entry.path()) {
                ours.push(path);
            }
        }
        if ours.is_empty() {
            break;
        }
    }
    order::sort_by_key(&mut ours, PathBuf::clone);
    Ok(Ours(ours))
}

/// Whether a folder can hold files of the tree above it: it is not hidden, and no tree of its own.
fn may_be_ours(folder: &DirEntry) -> bool {
    !folder.file_name().as_encoded_bytes().starts_with(b".") && !is_root(&folder.path().join("mod.rs"))
}

/// Whether a file begins with our header.
pub(super) fn has_mark(path: &Path) -> bool {
    let mut head = [0; MARK.len()];
    File::open(path).is_ok_and(|mut file| file.read_exact(&mut head).is_ok()) && head == *MARK.as_bytes()
}

/// Whether a file is the root module of a generated tree: its second line says what the tree was made of.
fn is_root(path: &Path) -> bool {
    let Ok(file) = File::open(path) else { return false };
    let head = BufReader::new(file.take(1024)).lines().take(2).map_while(Result::ok).collect_vec();
    matches!(&*head, [first, second] if first.starts_with(MARK) && second.starts_with(ROOT_MARK))
}
