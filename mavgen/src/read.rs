//! The first stage: XML text to spanned syntax.
//!
//! Checks what XML demands and which elements and attributes the MAVLink grammar has. What a value means is the work of
//! [`crate::resolve`].

mod bytes;
mod characters;
mod elements;
mod encoding;
mod enums;
mod fault;
pub(crate) mod grammar;
mod include;
mod message;
mod overlay;
mod prose;
mod range;
mod schema;
mod tag;
#[cfg(feature = "uorb")]
mod uorb_overlay;
mod xml;

pub use include::{Loaded, load, load_all};
pub use overlay::read as read_overlay;
#[cfg(feature = "uorb")]
pub use uorb_overlay::read as read_uorb_overlay;
#[cfg(feature = "vendor")]
pub(crate) use xml::MAX_DEPTH;

use crate::diag::Diagnostics;
use crate::source::{FileId, Sources, Span, Spanned};
use crate::syntax::{File, Version};
use elements::{Broken, Elements};
use tag::Tag;

/// Adds the text of a file that was asked for by name to the sources; what is wrong with it goes to `diagnostics`.
#[cfg(any(feature = "vendor", feature = "uorb"))]
pub(crate) fn open(path: &std::path::Path, sources: &mut Sources, diagnostics: &mut Diagnostics) -> Option<FileId> {
    bytes::read(path, sources).map_err(|why| diagnostics.push(why.diagnostic(path))).ok()
}

/// The bytes of a file, for [`open_bytes`].
#[cfg(feature = "uorb")]
pub(crate) fn bytes_of(path: &std::path::Path) -> std::io::Result<Vec<u8>> {
    bytes::load(path)
}

/// As [`open`], of a file whose bytes are there.
#[cfg(feature = "uorb")]
pub(crate) fn open_bytes(
    path: &std::path::Path,
    bytes: std::io::Result<Vec<u8>>,
    sources: &mut Sources,
    diagnostics: &mut Diagnostics,
) -> Option<FileId> {
    bytes::add(path, bytes, sources).map_err(|why| diagnostics.push(why.diagnostic(path))).ok()
}

/// Reads one dialect file.
///
/// Returns what could be understood: an element that lacks a required attribute is left out, and a text that is not
/// well-formed XML is read up to the fault. Every such loss is an error in `diagnostics`.
pub fn read(id: FileId, sources: &Sources, diagnostics: &mut Diagnostics) -> File {
    let mut file =
        File { id, includes: Vec::new(), version: None, dialect: None, enums: Vec::new(), messages: Vec::new() };
    if let Some(source) = sources.get(id) {
        let mut elements = Elements::new(id, source.text(), diagnostics);
        match document(&mut elements, &mut file) {
            Ok(()) | Err(Broken) => {}
        }
    }
    file
}

/// The root element, and nothing after it.
fn document(elements: &mut Elements<'_, '_>, file: &mut File) -> Result<(), Broken> {
    let root = elements.root(&grammar::MAVLINK)?;
    elements.close_tag(root);
    let mut once = Once::default();
    while let Some(tag) = elements.next_child(&grammar::MAVLINK)? {
        match tag.name {
            "enums" => read_enums(elements, tag, file)?,
            "messages" => read_messages(elements, tag, file)?,
            "include" => read_include(elements, tag, file)?,
            _ => once.read(elements, tag, file)?,
        }
    }
    elements.end()
}

/// `<version>` and `<dialect>`, of which the last counts.
#[derive(Default)]
struct Once<'t> {
    seen: Vec<(&'t str, Span)>,
}

impl<'t> Once<'t> {
    fn read(&mut self, elements: &mut Elements<'t, '_>, tag: Tag<'t>, file: &mut File) -> Result<(), Broken> {
        let (name, span) = (tag.name, tag.span);
        match self.seen.iter().find(|(seen, _)| *seen == name) {
            Some(&(_, first)) => elements.repeated(&tag, first),
            None => self.seen.push((name, span)),
        }
        elements.close_tag(tag);
        if name == "dialect" {
            file.dialect = elements.trimmed_text(&grammar::DIALECT)?;
        } else {
            let text = elements.trimmed_text(&grammar::VERSION)?;
            let messages_before = file.messages.len();
            file.version = text.map(|text| Version { text, messages_before });
        }
        Ok(())
    }
}

fn read_include<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>, file: &mut File) -> Result<(), Broken> {
    let span = tag.span;
    elements.close_tag(tag);
    let path = elements.trimmed_text(&grammar::INCLUDE)?;
    file.includes.push(path.unwrap_or_else(|| Spanned::new(String::new(), span)));
    Ok(())
}

fn read_enums<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>, file: &mut File) -> Result<(), Broken> {
    elements.close_tag(tag);
    while let Some(tag) = elements.next_child(&grammar::ENUMS)? {
        file.enums.extend(enums::read(elements, tag)?);
    }
    Ok(())
}

fn read_messages<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>, file: &mut File) -> Result<(), Broken> {
    elements.close_tag(tag);
    while let Some(tag) = elements.next_child(&grammar::MESSAGES)? {
        file.messages.extend(message::read(elements, tag)?);
    }
    Ok(())
}

#[cfg(test)]
mod tests;
