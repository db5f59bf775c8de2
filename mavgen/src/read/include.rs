//! The files of a dialect: the top file and all that it includes, each once, breadth first.

mod circle;
mod overlays;
mod paths;
#[cfg(test)]
mod tests;

#[cfg(feature = "uorb")]
pub(crate) use paths::absolute;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::bytes::{self, NoText};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::FileIndex;
use crate::source::{Sources, Span};
use crate::syntax::{File, Message, Overlay, Text};

/// How many levels of includes pymavlink follows below the top file.
const MAX_LEVEL: usize = 5;

/// The files of a dialect.
#[derive(Clone, Debug, Default)]
pub struct Loaded {
    /// What the dialect is called: after its top file, without extension.
    pub name: String,
    /// The files in merge order, the top file first. One that several dialects include was read once.
    pub files: Vec<Arc<File>>,
    /// For each file, those that it includes, in the order of its `<include>` elements.
    pub includes: Vec<Vec<FileIndex>>,
    /// The overlays, in the order in which they were given.
    pub overlays: Vec<Arc<Overlay>>,
    /// Every path that was read, and every place where a missing include was looked for.
    pub watched: Vec<PathBuf>,
}

impl Loaded {
    /// Orders the files by age: what is included comes before what includes it, overlays come last. Of two definitions that cannot
    /// stand together the younger one is wrong: its author knew of the other, and can mend it.
    pub(crate) fn age(&self, file: FileIndex) -> usize {
        let files = self.files.len();
        if file.0 < files { files - 1 - file.0 } else { file.0 }
    }

    /// The messages of all files.
    pub(crate) fn messages(&self) -> impl Iterator<Item = &Message> {
        self.files.iter().flat_map(|file| &file.messages)
    }

    /// The overlays, which are numbered after the files.
    pub(crate) fn numbered_overlays(&self) -> impl Iterator<Item = (FileIndex, &Overlay)> {
        (self.files.len()..).map(FileIndex).zip(self.overlays.iter().map(Arc::as_ref))
    }

    /// Whether a file of that name is included: if it is not among the files, it could not be read, which was said.
    pub(crate) fn has_include(&self, name: &str) -> bool {
        let mut includes = self.files.iter().flat_map(|file| &file.includes);
        includes.any(|include| Path::new(&include.value).file_name().is_some_and(|file| file == name))
    }
}

/// Reads a dialect file and all that it includes.
///
/// Include paths are relative to the file that names them; one that leads nowhere is looked for in `include_dirs`, in
/// order. Paths are compared as absolute paths without `.` and `..`; symbolic links are not resolved. The order is that
/// of pymavlink: breadth first. Then the `overlays` are read; one that is named twice is read once.
///
/// Problems go to `diagnostics`; a file that cannot be read is missing in the result.
pub fn load(
    top: &Path,
    include_dirs: &[PathBuf],
    overlays: &[PathBuf],
    sources: &mut Sources,
    diagnostics: &mut Diagnostics,
) -> Loaded {
    let all = load_all(&[top], include_dirs, overlays, sources, diagnostics);
    all.into_iter().next().unwrap_or_default()
}

/// Reads several dialect files as [`load`] reads one; what more than one of them includes is read once.
///
/// With several, an overlay belongs to those that have the file that it says it is for, and one that belongs to none is
/// an error.
pub fn load_all(
    tops: &[impl AsRef<Path>],
    include_dirs: &[PathBuf],
    overlays: &[PathBuf],
    sources: &mut Sources,
    diagnostics: &mut Diagnostics,
) -> Vec<Loaded> {
    let mut read = HashMap::new();
    let mut all: Vec<Loaded> = Vec::with_capacity(tops.len());
    for top in tops {
        all.push(load_top(top.as_ref(), include_dirs, &mut read, sources, diagnostics));
    }
    overlays::load(overlays, &mut all, sources, diagnostics);
    all
}

/// The files that were read so far, by absolute path; `None` for one that is no text, which was said already.
type Read = HashMap<PathBuf, Option<Arc<File>>>;

fn load_top(
    top: &Path,
    include_dirs: &[PathBuf],
    read: &mut Read,
    sources: &mut Sources,
    diagnostics: &mut Diagnostics,
) -> Loaded {
    let mut loader = Loader {
        include_dirs,
        read,
        sources,
        diagnostics,
        loaded: Loaded::default(),
        edges: Vec::new(),
        found: Vec::new(),
        seen: HashMap::new(),
        same: HashMap::new(),
    };
    loader.top(top);
    let mut next = 0;
    while next < loader.loaded.files.len() {
        loader.follow(FileIndex(next));
        next += 1;
    }
    circle::report(&loader.edges, &loader.names(), loader.diagnostics);
    loader.loaded.name = top.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let targets = |edges: &Vec<Edge>| edges.iter().map(|edge| edge.to).collect_vec();
    loader.loaded.includes = loader.edges.iter().map(targets).collect_vec();
    loader.loaded
}

/// An include that was followed: the file it leads to and where it is written.
#[derive(Clone, Copy)]
struct Edge {
    to: FileIndex,
    span: Span,
}

/// How a file was found.
#[derive(Clone, Copy)]
struct Found {
    /// How many includes below the top file.
    level: usize,
    /// The file that includes it, and where; `None` for the top file.
    by: Option<(FileIndex, Span)>,
}

struct Loader<'a> {
    include_dirs: &'a [PathBuf],
    /// The files of this dialect and of those before it.
    read: &'a mut Read,
    sources: &'a mut Sources,
    diagnostics: &'a mut Diagnostics,
    loaded: Loaded,
    /// For each file its includes.
    edges: Vec<Vec<Edge>>,
    /// For each file how it was found first.
    found: Vec<Found>,
    /// The files by absolute path; `None` for one that cannot be read, which was said already.
    seen: HashMap<PathBuf, Option<FileIndex>>,
    /// The files by the path without symbolic links. Never `None`: as `seen`, so that one kind of map is compiled.
    same: HashMap<PathBuf, Option<FileIndex>>,
}

impl Loader<'_> {
    fn top(&mut self, path: &Path) {
        if let Err(why) = self.open(path, Found { level: 0, by: None }) {
            if matches!(why, NoText::Io(_)) {
                self.loaded.watched.push(path.to_owned());
            }
            self.diagnostics.push(why.diagnostic(path));
        }
    }

    /// Takes in the file at `path`, which this dialect does not have yet; `None` if it is no text, which was said of another
    /// dialect.
    fn open(&mut self, path: &Path, found: Found) -> Result<Option<FileIndex>, NoText> {
        let absolute = paths::absolute(path);
        let file = match self.read.get(&absolute) {
            Some(file) => Ok(file.clone()),
            None => bytes::read(path, self.sources)
                .map(|id| Some(Arc::new(super::read(id, self.sources, self.diagnostics)))),
        };
        let index = FileIndex(self.loaded.files.len());
        if !matches!(file, Err(NoText::Io(_))) {
            let text = file.as_ref().ok().and_then(Option::as_ref);
            self.loaded.watched.push(path.to_owned());
            self.seen.insert(absolute.clone(), text.map(|_| index));
            self.read.insert(absolute, text.cloned());
        }
        let Some(file) = file? else { return Ok(None) };
        self.same.extend(std::fs::canonicalize(path).map(|path| (path, Some(index))));
        self.loaded.files.push(file);
        self.edges.push(Vec::new());
        self.found.push(found);
        Ok(Some(index))
    }

    /// Reads what a file includes.
    fn follow(&mut self, from: FileIndex) {
        let Some(file) = self.loaded.files.get(from.0).cloned() else { return };
        let Some(path) = self.sources.get(file.id).map(|source| source.path().to_owned()) else { return };
        for include in &file.includes {
            let places = paths::places(&path, &include.value, self.include_dirs);
            if let Some(to) = self.resolve(from, include, &places)
                && let Some(edges) = self.edges.get_mut(from.0)
            {
                edges.push(Edge { to, span: include.span });
            }
        }
    }

    /// The file that an include names: the first of `places` where there is one.
    fn resolve(&mut self, from: FileIndex, include: &Text, places: &[PathBuf]) -> Option<FileIndex> {
        if include.value.is_empty() {
            let error = Diagnostic::new(Code::MissingInclude, include.span, "an include without a path");
            self.diagnostics.push(error.help("the path is its text: `<include>common.xml</include>`"));
            return None;
        }
        let level = self.found.get(from.0).map_or(0, |found| found.level + 1);
        let (mut tried, mut there) = (Vec::new(), false);
        for place in places {
            if let Some(seen) = self.seen.get(&paths::absolute(place)) {
                return *seen;
            }
            if let Some(index) = self.by_other_path(place, include) {
                return Some(index);
            }
            if level > MAX_LEVEL && place.is_file() {
                self.too_deep(from, include);
                return None;
            }
            match self.open(place, Found { level, by: Some((from, include.span)) }) {
                Ok(index) => return index,
                Err(NoText::NotText(diagnostic)) => {
                    self.diagnostics.push(*diagnostic);
                    return None;
                }
                Err(NoText::Io(error)) => {
                    there |= place.exists();
                    tried.push(format!("`{}`: {}", place.display(), bytes::reason(&error)));
                }
            }
        }
        self.missing(from, include, places, (&tried.join(", "), there));
        None
    }

    /// The file at `place`, if it was read by another path: through a symbolic link, say. It is not read again.
    fn by_other_path(&mut self, place: &Path, include: &Text) -> Option<FileIndex> {
        let index = (*self.same.get(&std::fs::canonicalize(place).ok()?)?)?;
        self.seen.insert(paths::absolute(place), Some(index));
        self.loaded.watched.push(place.to_owned());
        let message = format!("`{}` is `{}` by another path", place.display(), self.name(index));
        let problem = Diagnostic::new(Code::SameFile, include.span, message)
            .help("include it by one path: pymavlink reads it twice, and finds all of it twice");
        let first = self.found.get(index.0).and_then(|found| found.by);
        self.diagnostics.push(match first {
            Some((_, first)) => problem.related(first, "included here first"),
            None => problem,
        });
        Some(index)
    }

    /// Says that an include cannot be read: where it was looked for, and whether something was there.
    fn missing(&mut self, from: FileIndex, include: &Text, places: &[PathBuf], (tried, there): (&str, bool)) {
        self.loaded.watched.extend_from_slice(places);
        let message = format!("the included file `{}` cannot be read", include.value);
        let help = if include.value.contains('\\') {
            let path = include.value.replace('\\', "/");
            format!("write `{path}`: a backslash separates folders on Windows alone; looked for {tried}")
        } else if let Some(name) = paths::similar(places) {
            format!("looked for {tried}; did you mean `{name}`?")
        } else if there {
            format!("looked for {tried}")
        } else {
            format!(
                "looked for {tried}; name the folder that has it (`--include-dir`, `Builder::include_dir`), or copy \
                 the dialect with all that it includes by `mavgen vendor`"
            )
        };
        let error = Diagnostic::new(Code::MissingInclude, include.span, message);
        let error = self.with_chain(from, error);
        self.diagnostics.push(error.help(help));
    }

    fn too_deep(&mut self, from: FileIndex, include: &Text) {
        let message = format!("`{}` is more than {MAX_LEVEL} includes below the top file", include.value);
        let error = self.with_chain(from, Diagnostic::new(Code::IncludeDepth, include.span, message));
        let help = "pymavlink follows no further: include it from a file nearer to the top";
        self.diagnostics.push(error.help(help));
    }

    /// Adds how the file `from` was come to, from the top.
    fn with_chain(&self, from: FileIndex, problem: Diagnostic) -> Diagnostic {
        let mut chain = Vec::new();
        let mut at = from;
        while let Some((parent, span)) = self.found.get(at.0).and_then(|found| found.by) {
            chain.push((span, format!("includes `{}`", self.name(at))));
            at = parent;
        }
        chain.into_iter().rev().fold(problem, |problem, (span, label)| problem.related(span, label))
    }

    fn name(&self, index: FileIndex) -> String {
        let file = self.loaded.files.get(index.0).and_then(|file| self.sources.get(file.id));
        file.map(|source| source.path().display().to_string()).unwrap_or_default()
    }

    fn names(&self) -> Vec<String> {
        (0..self.loaded.files.len()).map(|index| self.name(FileIndex(index))).collect_vec()
    }
}
