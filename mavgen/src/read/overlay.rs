//! Overlays: `<mavlink-overlay>` and what stands directly in it.

#[cfg(test)]
mod tests;
mod view;

use super::elements::{Broken, Elements};
use super::{document, enums, grammar};
use crate::diag::Diagnostics;
use crate::source::{FileId, Sources};
use crate::syntax::overlay::{Additions, Bind, Command, NamedParam, Note, Refinement};
use crate::syntax::{Overlay, Tag};

/// Reads one overlay, as [`super::read`] reads a dialect file.
pub fn read(id: FileId, sources: &Sources, diagnostics: &mut Diagnostics) -> Overlay {
    let mut overlay = Overlay {
        id,
        version: None,
        base: None,
        enums: Vec::new(),
        refinements: Vec::new(),
        notes: Vec::new(),
        messages: Vec::new(),
        commands: Vec::new(),
    };
    (overlay.version, overlay.base) =
        document(id, sources, diagnostics, &grammar::OVERLAY, |elements, tag| read_child(elements, tag, &mut overlay));
    overlay
}

fn read_child<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>, overlay: &mut Overlay) -> Result<(), Broken> {
    match tag.name {
        "enums" => {
            elements.close_tag(tag);
            enums::read(elements, &mut overlay.enums)?;
        }
        "refine" => overlay.refinements.extend(elements.leaf(tag, |_: &mut Refinement, _| {})?),
        "note" => overlay.notes.extend(elements.leaf(tag, |note: &mut Note, text| note.text = text)?),
        "command" => overlay.commands.extend(elements.element(tag, |command: &mut Command, elements, tag| {
            command.params.extend(elements.leaf(tag, |_: &mut NamedParam, _| {})?);
            Ok(())
        })?),
        _ => overlay.messages.extend(elements.element(tag, |message: &mut Additions, elements, tag| {
            match tag.name {
                "bind" => message.bindings.extend(elements.leaf(tag, |bind: &mut Bind, text| bind.description = text)?),
                _ => message.views.extend(view::read(elements, tag)?),
            }
            Ok(())
        })?),
    }
    Ok(())
}
