//! The first stage: XML text to spanned syntax.
//!
//! Checks what XML demands and which elements and attributes the MAVLink grammar has. What a value means is the work of
//! [`crate::Builder::resolve`].

mod bytes;
mod characters;
mod dialect;
mod elements;
mod encoding;
mod fault;
pub(crate) mod grammar;
mod include;
mod overlay;
mod schema;
mod tag;
#[cfg(feature = "uorb")]
mod uorb_overlay;
mod xml;

#[cfg(any(feature = "vendor", feature = "uorb"))]
pub(crate) use bytes::load as bytes_of;
#[cfg(feature = "uorb")]
pub(crate) use include::absolute;
pub use include::{Loaded, load, load_all};
pub use overlay::read as read_overlay;
#[cfg(feature = "uorb")]
pub use uorb_overlay::read as read_uorb_overlay;
#[cfg(feature = "vendor")]
pub(crate) use xml::MAX_DEPTH;

use crate::diag::Diagnostics;
use crate::source::{FileId, Part, Sources};
use crate::syntax::{File, Tag, Text};
use elements::{Broken, Elements};

/// Adds the text of a file that was asked for by name to the sources, once its [bytes](bytes_of) are there; what is wrong with it
/// goes to `diagnostics`.
#[cfg(any(feature = "vendor", feature = "uorb"))]
pub(crate) fn open(
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
    document(id, sources, diagnostics, &grammar::MAVLINK, |elements, tag| {
        dialect::read_child(elements, tag, &mut file)
    });
    file
}

/// Reads the root element of a file, its children by `child`, and nothing after it. Returns what the root of an overlay says: the
/// version of its grammar, and what it is for.
fn document(
    id: FileId,
    sources: &Sources,
    diagnostics: &mut Diagnostics,
    root: &'static grammar::Element,
    mut child: impl for<'t, 'd> FnMut(&mut Elements<'t, 'd>, Tag<'t>) -> Result<(), Broken>,
) -> (Option<Text>, Option<Text>) {
    let Some(source) = sources.get(id) else { return (None, None) };
    let is_dialect = std::ptr::eq(root, &grammar::MAVLINK);
    let mut elements = Elements::new(Part::whole(id, source.text()), is_dialect, diagnostics);
    let mut attributes = (None, None);
    let mut document = || {
        let mut tag = elements.root(root)?;
        let said = (!is_dialect).then(|| (tag.require("version"), tag.require("for")));
        if elements.close_tag(tag) {
            attributes = said.unzip();
        }
        while let Some(tag) = elements.next_child()? {
            child(&mut elements, tag)?;
        }
        elements.end()
    };
    match document() {
        Ok(()) | Err(Broken) => attributes,
    }
}

#[cfg(test)]
mod tests;
