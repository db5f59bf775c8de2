//! A dialect and all that it includes, copied into one folder, with a note of where it comes from.
//!
//! A copy is the source's text, byte for byte, below its header; or it is made of the source's facts, with no description or
//! with those of another folder ([`Prose`]). The facts are the elements and attributes of `mavlink.xsd`: names, ids, types,
//! order, values, units, ranges, labels, flags and stages of life. Elements and attributes that it does not have might be
//! prose, and stay behind with the comments. An original and its copy resolve to the same model.
//!
//! Includes lead to the flat folder. A copy begins with a header that names the source and its SHA-256, by which a later run
//! knows it as its own.
//!
//! # A part
//!
//! With [`Builder::messages`], the copies have only those messages and what they need. All files stay, also those that nothing
//! is left of, because versions and who includes whom are facts as well. An element that goes takes its comments along: those
//! right above it, up to a blank line, and the one behind it on its line.
//!
//! What stays is what it is in the whole dialect, to the types and names of the generated Rust. Where a dropped message
//! decides on that, it stays, and [`Vendored::retained`] says so: an enum is as wide as the widest field of its file that carries
//! it, so that `COMMAND_LONG`, which needs all commands and the enums of their params, takes along messages that have fields of
//! those enums. Generated with the same selection, the part and the whole are the same.
//!
//! # Nothing that a person wrote is lost
//!
//! [`write()`] refuses, before it writes anything, if something would be lost. In a copy of the source's text every edit
//! counts. In a copy of facts people may write descriptions and comments, which `Prose::From` of that very folder keeps; all
//! else in it counts as an edit. The header has a digest to tell by; line ends do not count.
//!
//! Descriptions of what is no longer in the definitions have no place to be kept in: [`Vendored::unplaced`] has them. Those of
//! what a selection leaves out are [`Vendored::left_out`], and no copy of a part takes the place of a file with such.

mod cut;
mod digest;
mod facts;
mod header;
mod original;
mod output;
mod part;
mod prose;
mod tree;

#[cfg(test)]
mod tests;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::builder::{Builder, Failure};
use crate::diag::Diagnostics;
use crate::internal::Internal;
use crate::problems::Problems;
use crate::read::{self, load};
use crate::roots::resolve;
use crate::source::Sources;

use original::{Original, originals};
use part::Part;
use prose::{Key, Library};
use tree::Element;

pub use output::{Written, write};
pub use part::Retained;

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
    /// With [`Builder::messages`]: what is in the copies although it was neither asked for nor needed.
    pub retained: Vec<Retained>,
    /// With [`Prose::From`]: what the folder has words about that the definitions no longer have.
    pub unplaced: Vec<Unplaced>,
    /// With [`Prose::From`] and [`Builder::messages`]: what the folder has words about that is left out.
    pub left_out: Vec<Unplaced>,
    /// Warnings about the definitions.
    pub diagnostics: Diagnostics,
    /// The texts that the warnings point into.
    pub sources: Sources,
    /// The folder of the descriptions.
    words_from: Option<PathBuf>,
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

/// Words about something that is not there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unplaced {
    /// The file they stood in.
    pub file: PathBuf,
    /// What they were about: `message HEARTBEAT field type`.
    pub name: String,
    /// The words, in one line.
    pub words: String,
}

/// Reads and resolves the dialect of a builder, and copies its files; writes nothing: see [`write()`].
///
/// What the builder says of generated code has no say here.
///
/// ```no_run
/// use mavgen::vendor::{Prose, vendor, write};
///
/// let upstream = mavgen::Builder::new("mavlink/message_definitions/v1.0/ardupilotmega.xml").deny_warnings(true);
/// write("xml".as_ref(), &vendor(&upstream, &Prose::Keep).unwrap()).unwrap();
/// ```
///
/// # Errors
/// [`Failure::Definitions`] if the definitions, or the files that descriptions are taken from, are wrong, and
/// [`Failure::Denied`] as in [`Builder::resolve`]. [`Failure::Usage`] if two files of different folders have the same name, or
/// names that some file systems take for the same; if [`Builder::messages`] names what there is not; or if the builder has
/// several dialects, or an overlay: those are not copied.
pub fn vendor(builder: &Builder, prose: &Prose) -> Result<Vendored, Failure> {
    let ([xml], []) = (&*builder.roots, &*builder.overlays) else {
        return Err(Failure::Usage("definitions are copied one dialect at a time, and without overlays".into()));
    };
    let selection = builder.selection()?;
    let (mut sources, mut diagnostics) = (Sources::default(), builder.diagnostics()?);
    let loaded = load(xml, &builder.include_dirs, &[], &mut sources, &mut diagnostics);
    let whole = resolve(&loaded, &sources, &mut diagnostics);
    let found = Problems { diagnostics, sources, watched: loaded.watched.clone() };
    let Problems { diagnostics, sources, .. } = builder.judged(found)?;
    let whole = whole.ok_or_else(|| Internal::new("a dialect without errors is not resolved"))?;
    let part = selection.map(|selection| Part::of(&selection, &whole, &loaded, &sources)).transpose()?;
    let mut originals = originals(&loaded, &sources)?;
    for (original, file) in originals.iter_mut().zip(&loaded.files) {
        part.iter().for_each(|part| original.leave_out(file, part));
    }
    let words_from = if let Prose::From(folder) = prose { Some(folder.clone()) } else { None };
    let mut library = words_from.as_ref().map(|folder| library(&originals, folder)).transpose()?;
    let copy = |original: &Original<'_>| match prose {
        Prose::Keep => original.whole(),
        Prose::Drop | Prose::From(_) => original.facts(library.as_mut()),
    };
    let files = originals.iter().map(copy).collect();
    let gone: BTreeSet<Key> = originals.iter().flat_map(Original::left_out_keys).collect();
    let rest = library.iter().flat_map(Library::rest);
    let (left_out, unplaced) = rest.partition(|words| gone.contains(prose::item(&words.name)));
    let retained = part.map(|part| part.retained).unwrap_or_default();
    Ok(Vendored { files, retained, unplaced, left_out, diagnostics, sources, words_from })
}

/// The words of the files in a folder.
fn library(originals: &[Original<'_>], folder: &Path) -> Result<Library, Failure> {
    if !folder.is_dir() {
        return Err(Failure::Usage(format!("{}: there is no such folder to take descriptions from", folder.display())));
    }
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let mut library = Library::of(folder);
    for original in originals {
        library.claim(&original.name, original.keys());
        let path = folder.join(&original.name);
        if path.exists()
            && let Some(id) = read::open(&path, read::bytes_of(&path), &mut sources, &mut diagnostics)
        {
            read::read(id, &sources, &mut diagnostics);
            let root = sources.get(id).and_then(|source| Element::root(source.text()));
            root.iter().for_each(|root| library.add(&original.name, root));
        }
    }
    if diagnostics.has_errors() {
        return Err(Failure::Definitions(Box::new(Problems { diagnostics, sources, watched: Vec::new() })));
    }
    Ok(library)
}
