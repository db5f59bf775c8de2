//! Which files are read, in which order, and what is said of those that cannot be.

use std::fs;
use std::path::{Path, PathBuf};

use super::load;
use crate::diag::{Code, Diagnostics, Style, one_line, render};
use crate::ir::FileIndex;
use crate::source::Sources;

/// A folder of dialect files, and what reading one of them gives.
struct Folder(tempfile::TempDir);

struct Run {
    files: Vec<PathBuf>,
    overlays: Vec<PathBuf>,
    includes: Vec<Vec<usize>>,
    watched: Vec<PathBuf>,
    sources: Sources,
    diagnostics: Diagnostics,
}

impl Folder {
    fn new(files: &[(&str, &[&str])]) -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        for (name, includes) in files {
            let includes: String = includes.iter().map(|path| format!("<include>{path}</include>")).collect();
            folder.write(name, format!("<mavlink>{includes}</mavlink>").as_bytes());
        }
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, bytes: &[u8]) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }

    fn load(&self, top: &str, include_dirs: &[&str]) -> Run {
        self.load_with(top, include_dirs, &[])
    }

    fn load_with(&self, top: &str, include_dirs: &[&str], overlays: &[&str]) -> Run {
        let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
        let include_dirs: Vec<PathBuf> = include_dirs.iter().map(|name| self.path(name)).collect();
        let overlays: Vec<PathBuf> = overlays.iter().map(|name| self.path(name)).collect();
        let loaded = load(&self.path(top), &include_dirs, &overlays, &mut sources, &mut diagnostics);
        let local = |path: &Path| path.strip_prefix(self.0.path()).unwrap_or(path).to_owned();
        Run {
            files: loaded.files.iter().map(|file| local(sources.get(file.id).unwrap().path())).collect(),
            overlays: loaded.overlays.iter().map(|file| local(sources.get(file.id).unwrap().path())).collect(),
            includes: loaded.includes.iter().map(|to| to.iter().map(|FileIndex(n)| *n).collect()).collect(),
            watched: loaded.watched.iter().map(|path| local(path)).collect(),
            sources,
            diagnostics,
        }
    }
}

fn codes(run: &Run) -> Vec<Code> {
    run.diagnostics.iter().map(|diagnostic| diagnostic.code).collect()
}

fn paths<const N: usize>(names: [&str; N]) -> [PathBuf; N] {
    names.map(PathBuf::from)
}

#[test]
fn breadth_first_and_each_file_once() {
    let folder = Folder::new(&[
        ("top.xml", &["a.xml", "sub/b.xml", "a.xml"]),
        ("a.xml", &["deep.xml", "sub/b.xml"]),
        ("sub/b.xml", &["../common.xml", "./c.xml"]),
        ("sub/c.xml", &["../deep.xml"]),
        ("deep.xml", &["common.xml"]),
        ("common.xml", &[]),
    ]);
    let run = folder.load("top.xml", &[]);
    assert!(run.diagnostics.is_empty(), "{:?}", run.diagnostics);
    let order = ["top.xml", "a.xml", "sub/b.xml", "deep.xml", "common.xml", "sub/c.xml"];
    assert_eq!(run.files, paths(order));
    assert_eq!(run.watched, paths(order));
    assert_eq!(run.includes, [vec![1, 2, 1], vec![3, 2], vec![4, 5], vec![4], vec![], vec![3]]);
}

#[test]
fn absolute_paths_and_include_folders() {
    let folder = Folder::new(&[
        ("xml/a.xml", &[]),
        ("one/b.xml", &[]),
        ("two/a.xml", &[]),
        ("two/b.xml", &[]),
        ("two/c.xml", &["d.xml"]),
        ("two/d.xml", &[]),
    ]);
    let absolute = folder.path("two/a.xml");
    let includes = ["a.xml", "b.xml", "c.xml", absolute.to_str().unwrap()];
    let includes = includes.map(|path| format!("<include>{path}</include>")).concat();
    folder.write("xml/top.xml", format!("<mavlink>{includes}</mavlink>").as_bytes());
    let run = folder.load("xml/top.xml", &["one", "two"]);
    assert!(run.diagnostics.is_empty(), "{:?}", run.diagnostics);
    let order = ["xml/top.xml", "xml/a.xml", "one/b.xml", "two/c.xml", "two/a.xml", "two/d.xml"];
    assert_eq!(run.files, paths(order));
}

#[test]
fn missing_includes_are_watched_wherever_they_were_looked_for() {
    let folder = Folder::new(&[("xml/top.xml", &["comon.xml"]), ("one/common.xml", &[])]);
    let run = folder.load("xml/top.xml", &["one"]);
    assert_eq!(codes(&run), [Code::MissingInclude]);
    assert_eq!(run.watched, paths(["xml/top.xml", "xml/comon.xml", "one/comon.xml"]));
    let drawn = render(run.diagnostics.iter().next().unwrap(), &run.sources, Style::Plain);
    assert!(drawn.contains("did you mean `common.xml`?"), "{drawn}");
}

#[test]
fn five_levels_and_no_more() {
    let names: Vec<String> = (0..8).map(|level| format!("{level}.xml")).collect();
    let chain = |length: usize| {
        let folder = Folder::new(&[]);
        for (level, name) in names.iter().enumerate().take(length) {
            let next = names.get(level + 1).filter(|_| level + 1 < length);
            let include = next.map_or(String::new(), |next| format!("<include>{next}</include>"));
            folder.write(name, format!("<mavlink>{include}</mavlink>").as_bytes());
        }
        folder.load("0.xml", &[])
    };
    assert_eq!((codes(&chain(6)), chain(6).files.len()), (vec![], 6));
    assert_eq!((codes(&chain(7)), chain(7).files.len()), (vec![Code::IncludeDepth], 6));
}

#[test]
fn every_circle_is_reported_once() {
    let folder = Folder::new(&[
        ("top.xml", &["a.xml", "b.xml"]),
        ("a.xml", &["c.xml"]),
        ("b.xml", &["c.xml", "b.xml"]),
        ("c.xml", &["a.xml"]),
    ]);
    let run = folder.load("top.xml", &[]);
    assert_eq!(codes(&run), [Code::IncludeCycle, Code::IncludeCycle]);
    assert_eq!(run.files.len(), 4);
}

#[test]
fn files_that_cannot_be_read() {
    let folder = Folder::new(&[("sub/a.xml", &[])]);
    for (top, reason) in [("none.xml", "there is no such file"), ("sub", "it is a folder")] {
        let run = folder.load(top, &[]);
        assert_eq!((codes(&run), run.files.len()), (vec![Code::Unreadable], 0));
        assert_eq!(run.watched, paths([top]));
        let line = one_line(run.diagnostics.iter().next().unwrap(), &run.sources);
        assert!(line.starts_with("error[M001]: `") && line.ends_with(reason), "{line}");
    }
}

#[test]
fn overlays_are_read_after_the_dialect_and_once() {
    let folder = Folder::new(&[("top.xml", &["base.xml"]), ("base.xml", &[])]);
    for name in ["b.overlay.xml", "a.overlay.xml"] {
        folder.write(name, b"<mavlink-overlay version='1' for='top.xml'/>");
    }
    let run = folder.load_with("top.xml", &[], &["b.overlay.xml", "a.overlay.xml", "./b.overlay.xml"]);
    assert!(run.diagnostics.is_empty(), "{:?}", run.diagnostics);
    assert_eq!(run.overlays, paths(["b.overlay.xml", "a.overlay.xml"]));
    assert_eq!(run.watched, paths(["top.xml", "base.xml", "b.overlay.xml", "a.overlay.xml"]));
}

#[test]
fn an_overlay_that_is_not_there_is_an_error_and_watched() {
    let folder = Folder::new(&[("top.xml", &[])]);
    let run = folder.load_with("top.xml", &[], &["none.overlay.xml"]);
    assert_eq!((codes(&run), run.overlays.len()), (vec![Code::Unreadable], 0));
    assert_eq!(run.watched, paths(["top.xml", "none.overlay.xml"]));
}

#[test]
fn a_file_may_not_be_larger_than_any_dialect() {
    let folder = Folder::new(&[("top.xml", &["large.xml"])]);
    let large = fs::File::create(folder.path("large.xml")).unwrap();
    large.set_len(super::bytes::MAX_SIZE + 1).unwrap();
    let run = folder.load("top.xml", &[]);
    assert_eq!((codes(&run), run.files.len()), (vec![Code::TooLarge], 1));
}

#[test]
fn a_byte_that_is_not_utf8_is_named_with_its_line() {
    let folder = Folder::new(&[]);
    folder.write("mark.xml", b"\xef\xbb\xbf<mavlink>\n<!--\xe9-->\n</mavlink>");
    let run = folder.load("mark.xml", &[]);
    assert_eq!(codes(&run), [Code::NotUtf8]);
    let line = one_line(run.diagnostics.iter().next().unwrap(), &run.sources);
    assert!(line.ends_with("mark.xml:2:5: error[M002]: the byte 0xE9 in line 2 is not UTF-8"), "{line}");
}
