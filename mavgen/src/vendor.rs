//! A dialect and all that it includes, copied into one folder, with a note of where it comes from.
//!
//! A copy is the source's text, byte for byte, below its header; or it is made of the source's facts, with no description or
//! with those of another folder ([`Prose`]). The facts are the elements and attributes of `mavlink.xsd`: names, ids, types,
//! order, values, units, ranges, labels, flags and stages of life. Elements and attributes that it does not have might be
//! prose, and stay behind with the comments. An original and its copy resolve to the same model.
//!
//! Includes lead to the flat folder. A copy begins with a header that names the source and its SHA-256, by which a later run
//! knows it as its own.

mod facts;
mod flat;
mod grammar;
mod header;
mod output;
mod prose;
mod tree;

#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};

use crate::builder::{Builder, Failure, Problems};
use crate::diag::Diagnostics;
use crate::read::{self, Loaded, load};
use crate::resolve::resolve;
use crate::source::{FileId, Sources};

use header::{Kind, header, split_declaration};
use tree::Element;

pub use output::{Written, write};

/// What becomes of descriptions and comments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Prose {
    /// They are copied with all else.
    Keep,
    /// They are left behind.
    Drop,
    /// Those of the files of this folder take their place, each where an element has the same names: `message HEARTBEAT field
    /// type`. One whose element has moved to another file goes with it.
    From(PathBuf),
}

/// A dialect's files, ready to be written.
#[derive(Clone, Debug)]
pub struct Vendored {
    /// The copies, the dialect's own file first.
    pub files: Vec<Copy>,
    /// With [`Prose::From`]: what the folder has words about that the definitions no longer have.
    pub homeless: Vec<Homeless>,
    /// Warnings about the definitions.
    pub diagnostics: Diagnostics,
    /// The texts that the warnings point into.
    pub sources: Sources,
}

/// The copy of one file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Copy {
    /// Its name, without folders.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Where it comes from.
    pub source: PathBuf,
    /// Its messages, fields, enums, entries and params; nothing with [`Prose::Keep`].
    pub items: Vec<Item>,
    /// Whether its descriptions are from [`Prose::From`].
    described_here: bool,
}

/// Something that should have a description.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    /// Its names: `message HEARTBEAT field type`.
    pub name: String,
    /// Whether it has one.
    pub described: bool,
    /// Whether the folder of the descriptions does not know it.
    pub new: bool,
}

/// Words about something that is no longer there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Homeless {
    /// The file they stood in.
    pub file: PathBuf,
    /// What they were about: `message HEARTBEAT field type`.
    pub name: String,
    /// The words, in one line.
    pub words: String,
}

/// Reads and resolves the dialect of a builder, and copies its files; writes nothing: see [`write()`].
///
/// ```no_run
/// use mavgen::vendor::{Prose, vendor, write};
///
/// let upstream = mavgen::Builder::new("mavlink/message_definitions/v1.0/ardupilotmega.xml").deny_warnings(true);
/// write("xml".as_ref(), &vendor(&upstream, &Prose::Keep).unwrap().files).unwrap();
/// ```
///
/// # Errors
/// [`Failure::Definitions`] if the definitions, or the files that descriptions are taken from, are wrong, and
/// [`Failure::Denied`] as in [`Builder::resolve`]. [`Failure::Usage`] if two files of different folders have the same name, or
/// names that some file systems take for the same; or if the builder has several dialects, or an overlay: those are not copied.
pub fn vendor(builder: &Builder, prose: &Prose) -> Result<Vendored, Failure> {
    let ([xml], []) = (&*builder.roots, &*builder.overlays) else {
        return Err(Failure::Usage("definitions are copied one dialect at a time, and without overlays".into()));
    };
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let loaded = load(xml, &builder.include_dirs, &[], &mut sources, &mut diagnostics);
    if resolve(&loaded, &sources, &mut diagnostics).is_none() {
        let watched = loaded.watched;
        return Err(Failure::Definitions(Box::new(Problems { diagnostics, sources, watched })));
    }
    builder.check_denied(&diagnostics, &sources, &loaded.watched)?;
    let originals = originals(&loaded, &sources)?;
    let (files, homeless) = match prose {
        Prose::Keep => (originals.iter().map(Original::whole).collect(), Vec::new()),
        Prose::Drop => (originals.iter().map(|original| original.facts(None)).collect(), Vec::new()),
        Prose::From(folder) => described(&originals, folder)?,
    };
    Ok(Vendored { files, homeless, diagnostics, sources })
}

/// A file to copy.
struct Original<'t> {
    name: String,
    path: &'t Path,
    text: &'t str,
    /// The places of its includes, and what they are called in the folder.
    includes: Vec<flat::Include>,
    root: Element<'t>,
}

fn originals<'t>(loaded: &Loaded, sources: &'t Sources) -> Result<Vec<Original<'t>>, Failure> {
    let names = flat::names(loaded, sources)?;
    let mut originals = Vec::new();
    for (at, file) in loaded.files.iter().enumerate() {
        let Some((source, name)) = sources.get(file.id).zip(names.get(at)) else { continue };
        let unread = || Failure::Usage(format!("{}: no XML to copy", source.path().display()));
        let root = Element::root(source.text()).ok_or_else(unread)?;
        let includes = flat::includes(loaded, at, &names);
        originals.push(Original { name: name.clone(), path: source.path(), text: source.text(), includes, root });
    }
    Ok(originals)
}

impl Original<'_> {
    /// The text below a header.
    fn whole(&self) -> Copy {
        let (text, changed) = flat::rewrite(self.text, &self.includes);
        let header = header(&self.name, self.text, Kind::Whole { includes: changed });
        let line_end = if self.text.contains("\r\n") { "\r\n" } else { "\n" };
        let text = match split_declaration(&text) {
            ("", rest) => format!("{header}{line_end}{rest}"),
            (declaration, rest) => format!("{declaration}{line_end}{header}{rest}"),
        };
        self.copy(text, Vec::new(), false)
    }

    /// The facts below a header, with the words of a library if there is one.
    fn facts(&self, library: Option<&mut prose::Library>) -> Copy {
        let includes: Vec<String> = self.includes.iter().map(|include| include.name.clone()).collect();
        let kind = if library.is_some() { Kind::Described } else { Kind::Facts };
        let (facts, known) = match library {
            Some(library) => {
                let facts = facts::write(&self.root, &includes, &mut |key| library.take(&self.name, key));
                (facts, Some(library))
            }
            None => (facts::write(&self.root, &includes, &mut |_| None), None),
        };
        let item = |(name, described): (String, bool)| {
            let new = known.as_ref().is_some_and(|library| !library.knows(&name));
            Item { name, described, new }
        };
        let items = facts.described.into_iter().map(item).collect();
        let header = header(&self.name, self.text, kind);
        let text = format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{header}\n{}", facts.text);
        self.copy(text, items, kind == Kind::Described)
    }

    fn copy(&self, text: String, items: Vec<Item>, described_here: bool) -> Copy {
        Copy { name: self.name.clone(), text, source: self.path.to_owned(), items, described_here }
    }
}

/// Copies with the words of the files in a folder, and what is left of those.
fn described(originals: &[Original<'_>], folder: &Path) -> Result<(Vec<Copy>, Vec<Homeless>), Failure> {
    if !folder.is_dir() {
        return Err(Failure::Usage(format!("{}: there is no such folder to take descriptions from", folder.display())));
    }
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let mut read_files: Vec<(&str, FileId)> = Vec::new();
    for original in originals {
        let path = folder.join(&original.name);
        if path.exists()
            && let Some(id) = read::open(&path, &mut sources, &mut diagnostics)
        {
            read::read(id, &sources, &mut diagnostics);
            read_files.push((&original.name, id));
        }
    }
    if diagnostics.has_errors() {
        return Err(Failure::Definitions(Box::new(Problems { diagnostics, sources, watched: Vec::new() })));
    }
    let mut library = prose::Library::default();
    for (name, id) in read_files {
        if let Some(root) = sources.get(id).and_then(|source| Element::root(source.text())) {
            library.add(name, &root);
        }
    }
    originals.iter().for_each(|original| library.claim(&original.name, facts::keys(&original.root)));
    let copies = originals.iter().map(|original| original.facts(Some(&mut library))).collect();
    let rest = library.rest().map(|(file, name, words)| Homeless { file: folder.join(file), name, words });
    Ok((copies, rest.collect()))
}
