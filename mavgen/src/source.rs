//! Source files and places in them.
//!
//! Knows nothing of XML: it keeps texts, and turns a byte range into file, line and column.

mod part;

pub(crate) use part::Part;

use crate::collect::CollectVec as _;
use std::collections::HashSet;
use std::ffi::OsString;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// A source file of one run, by the order in which it was loaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FileId(u32);

/// A place in a source file: a range of bytes.
///
/// Files are at most 4 GiB long, so 32 bits are enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// The file.
    pub file: FileId,
    /// The first byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// A span over `range` of `file`; positions beyond 4 GiB are cut to it.
    pub fn new(file: FileId, range: Range<usize>) -> Self {
        let cut = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
        Self { file, start: cut(range.start), end: cut(range.end) }
    }

    /// The bytes, as an index range.
    pub fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

/// A value and where it was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spanned<T> {
    /// The value.
    pub value: T,
    /// Where it was written.
    pub span: Span,
}

impl<T> Spanned<T> {
    /// Joins a value and its place.
    pub fn new(value: T, span: Span) -> Self {
        Self { value, span }
    }
}

/// Line and column of a place, both counted from one; the column counts characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Position {
    /// The line.
    pub line: usize,
    /// The column, in characters.
    pub column: usize,
}

/// One source file.
#[derive(Clone, Debug)]
pub struct SourceFile {
    path: PathBuf,
    text: String,
    /// It began with a byte order mark, which the text lacks.
    #[cfg(feature = "uorb")]
    marked: bool,
    /// An earlier file has its name.
    is_name_taken: bool,
    /// Where lines start; made when the first position is asked for.
    lines: OnceLock<Vec<usize>>,
}

impl SourceFile {
    /// The path as diagnostics show it.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The last component of the path.
    pub fn name(&self) -> String {
        self.path.file_name().unwrap_or(self.path.as_os_str()).to_string_lossy().into_owned()
    }

    /// The whole text, without a byte order mark.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether a byte order mark was before the text.
    #[cfg(feature = "uorb")]
    pub(crate) fn begins_with_mark(&self) -> bool {
        self.marked
    }

    /// Line and column of a byte offset.
    pub fn position(&self, offset: u32) -> Position {
        let lines = self.lines.get_or_init(|| {
            let after_breaks = self.text.match_indices('\n').map(|(at, _)| at + 1);
            std::iter::once(0).chain(after_breaks).collect_vec()
        });
        let offset = (offset as usize).min(self.text.len());
        let line = lines.partition_point(|&start| start <= offset);
        let start = line.checked_sub(1).and_then(|index| lines.get(index)).copied().unwrap_or_default();
        let column = self.text.get(start..offset).unwrap_or_default().chars().count() + 1;
        Position { line, column }
    }
}

/// All files of one run.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    files: Vec<SourceFile>,
    /// The last components of their paths.
    names: HashSet<OsString>,
}

impl Sources {
    /// Adds a text, without its byte order mark; `path` is shown in diagnostics as it is given here.
    pub fn add(&mut self, path: impl Into<PathBuf>, text: impl Into<String>) -> FileId {
        let id = FileId(u32::try_from(self.files.len()).unwrap_or(u32::MAX));
        let (path, mut text) = (path.into(), text.into());
        let marks = text.len() - text.trim_start_matches('\u{feff}').len();
        text.drain(..marks);
        let is_name_taken = !self.names.insert(path.file_name().unwrap_or(path.as_os_str()).to_owned());
        self.files.push(SourceFile {
            path,
            text,
            #[cfg(feature = "uorb")]
            marked: marks > 0,
            is_name_taken,
            lines: OnceLock::new(),
        });
        id
    }

    /// The file behind an id; ids come from [`Sources::add`] of the same value.
    pub fn get(&self, id: FileId) -> Option<&SourceFile> {
        self.files.get(id.0 as usize)
    }

    /// How the model and generated code name a file: the last component of its path, and before it the folder if an earlier
    /// file has that name, as `overlay/acme.xml` beside `acme.xml`. Empty if there is no such file.
    pub fn name(&self, id: FileId) -> String {
        let Some(file) = self.get(id) else { return String::new() };
        let name = file.name();
        match file.path.parent().and_then(Path::file_name) {
            Some(folder) if file.is_name_taken => format!("{}/{name}", folder.to_string_lossy()),
            _ => name,
        }
    }

    /// All files, in the order in which they were loaded.
    pub fn iter(&self) -> impl Iterator<Item = (FileId, &SourceFile)> {
        (0..).map(FileId).zip(&self.files)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters() {
        let mut sources = Sources::default();
        let id = sources.add("a.xml", "ab\n°c\n");
        let file = sources.get(id).unwrap();
        assert_eq!(file.position(0), Position { line: 1, column: 1 });
        assert_eq!(file.position(3), Position { line: 2, column: 1 });
        assert_eq!(file.position(5), Position { line: 2, column: 2 });
        assert_eq!(file.position(99), Position { line: 3, column: 1 });
    }

    #[test]
    fn a_second_file_of_one_name_is_named_with_its_folder() {
        let mut sources = Sources::default();
        let names = ["x/a.xml", "x/overlay/a.xml", "x/b.xml", "b.xml"].map(|path| {
            let id = sources.add(path, "");
            sources.name(id)
        });
        assert_eq!(names, ["a.xml", "overlay/a.xml", "b.xml", "b.xml"]);
    }
}
