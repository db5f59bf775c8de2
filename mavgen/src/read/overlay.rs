//! Overlays: `<mavlink-overlay>` and what stands directly in it.

mod parts;
#[cfg(test)]
mod tests;
mod view;

use super::elements::{Broken, Elements};
use super::{enums, grammar};
use crate::diag::Diagnostics;
use crate::source::{FileId, Sources};
use crate::syntax::overlay::{Additions, Bind, Command, Condition, NamedParam, Note, Refinement};
use crate::syntax::{Overlay, Text};

use super::tag::Tag;

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
    (overlay.version, overlay.base) = document(id, sources, diagnostics, &grammar::OVERLAY, |elements, tag| {
        match tag.name {
            "enums" => {
                elements.close_tag(tag);
                while let Some(tag) = elements.next_child(&grammar::ENUMS)? {
                    overlay.enums.extend(enums::read(elements, tag)?);
                }
            }
            "refine" => overlay.refinements.extend(read_refinement(elements, tag)?),
            "note" => overlay.notes.push(read_note(elements, tag)?),
            "command" => overlay.commands.extend(read_command(elements, tag)?),
            _ => overlay.messages.extend(read_message(elements, tag)?),
        }
        Ok(())
    });
    overlay
}

/// Reads the root of an overlay of any kind, its children by `child`, and nothing after it: which version of the grammar it has,
/// and what it is for.
pub(super) fn document(
    id: FileId,
    sources: &Sources,
    diagnostics: &mut Diagnostics,
    root: &'static grammar::Element,
    mut child: impl for<'t, 'd> FnMut(&mut Elements<'t, 'd>, Tag<'t>) -> Result<(), Broken>,
) -> (Option<Text>, Option<Text>) {
    let Some(source) = sources.get(id) else { return (None, None) };
    let (mut elements, mut attributes) = (Elements::new(id, source.text(), diagnostics), (None, None));
    let mut document = || {
        let mut tag = elements.root(root)?;
        let (version, base) = (tag.require("version"), tag.require("for"));
        if elements.close_tag(tag) {
            attributes = (Some(version), Some(base));
        }
        while let Some(tag) = elements.next_child(root)? {
            child(&mut elements, tag)?;
        }
        elements.end()
    };
    match document() {
        Ok(()) | Err(Broken) => attributes,
    }
}

fn read_refinement<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Refinement>, Broken> {
    let refinement = Refinement {
        enum_: tag.require("enum"),
        bitmask: tag.take("bitmask"),
        deprecated: tag.take("deprecated"),
        span: tag.span,
    };
    let complete = elements.close_tag(tag);
    elements.text(&grammar::REFINE)?;
    Ok(complete.then_some(refinement))
}

fn read_note<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Note, Broken> {
    let mut note = Note {
        message: tag.take("message"),
        field: tag.take("field"),
        enum_: tag.take("enum"),
        entry: tag.take("entry"),
        text: None,
        span: tag.span,
    };
    elements.close_tag(tag);
    note.text = elements.trimmed_text(&grammar::NOTE)?;
    Ok(note)
}

fn read_command<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Command>, Broken> {
    let mut command = Command {
        name: tag.require("name"),
        has_location: tag.take("hasLocation"),
        is_destination: tag.take("isDestination"),
        params: Vec::new(),
    };
    let complete = elements.close_tag(tag);
    while let Some(tag) = elements.next_child(&grammar::COMMAND)? {
        command.params.extend(read_param(elements, tag)?);
    }
    Ok(complete.then_some(command))
}

fn read_param<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<NamedParam>, Broken> {
    let param = NamedParam {
        index: tag.require("index"),
        label: tag.require("label"),
        units: tag.take("units"),
        enum_: tag.take("enum"),
        span: tag.span,
    };
    let complete = elements.close_tag(tag);
    elements.text(&grammar::NAMED_PARAM)?;
    Ok(complete.then_some(param))
}

fn read_message<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Additions>, Broken> {
    let mut message = Additions { name: tag.require("name"), bindings: Vec::new(), views: Vec::new(), span: tag.span };
    let complete = elements.close_tag(tag);
    while let Some(tag) = elements.next_child(&grammar::ADDITIONS)? {
        match tag.name {
            "bind" => message.bindings.extend(read_bind(elements, tag)?),
            _ => message.views.extend(view::read(elements, tag)?),
        }
    }
    Ok(complete.then_some(message))
}

fn read_bind<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Bind>, Broken> {
    let mut bind = Bind {
        name: tag.require("name"),
        field: tag.require("field"),
        enum_: tag.require("enum"),
        condition: read_condition(&mut tag),
        description: None,
    };
    let complete = elements.close_tag(tag);
    bind.description = elements.trimmed_text(&grammar::BIND)?;
    Ok(complete.then_some(bind))
}

/// `if` and `is`, of which each demands the other.
fn read_condition(tag: &mut Tag<'_>) -> Condition {
    let (field, value) = (tag.take("if"), tag.take("is"));
    match (field, value) {
        (Some(field), None) => Condition { field: Some(field), value: Some(tag.require("is")) },
        (None, Some(value)) => Condition { field: Some(tag.require("if")), value: Some(value) },
        (field, value) => Condition { field, value },
    }
}
