//! Overlays: `<mavlink-overlay>` and what stands in it.

#[cfg(test)]
mod tests;

use super::dialect::read_enums;
use super::elements::{Broken, Elements};
use super::{document, grammar};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::source::{FileId, Sources, Span};
use crate::syntax::overlay::{
    Additions, Bind, Bits, Case, Command, Invalid, Key, NamedParam, Note, Part, Piece, Refinement, Reserved, Switch,
    View,
};
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
            read_enums(elements, &mut overlay.enums)?;
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
                _ => message.views.extend(read_view(elements, tag)?),
            }
            Ok(())
        })?),
    }
    Ok(())
}

/// Reads a view; `None` if it has no name.
fn read_view<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>) -> Result<Option<View>, Broken> {
    let view = elements.element(tag, |view: &mut View, elements, tag| {
        match tag.name {
            "key" => view.keys.extend(read_key(elements, tag)?),
            "value" => view.values.extend(read_key(elements, tag)?),
            "invalid" => view.invalids.extend(elements.leaf(tag, |_: &mut Invalid, _| {})?),
            "switch" => view.parts.extend(read_switch(elements, tag)?.map(Part::Switch)),
            "description" => {
                elements.check_repeated(&tag, &["description"]);
                elements.close_tag(tag);
                view.description = elements.text()?;
            }
            _ => view.parts.extend(read_piece(elements, tag)?.map(Part::Piece)),
        }
        Ok(())
    })?;
    Ok(view.map(|view| View { description: view.description.or(elements.trimmed_content()), ..view }))
}

/// Reads a key, or a value, which is spelled alike.
fn read_key<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>) -> Result<Option<Key>, Broken> {
    elements.leaf(tag, |key: &mut Key, text| key.description = text)
}

/// Reads `<bits>` or `<reserved>`. A text may say why bits are reserved; nobody but the reader of the file needs it.
fn read_piece<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>) -> Result<Option<Piece>, Broken> {
    Ok(match tag.name {
        "bits" => {
            let bits = elements.leaf(tag, |bits: &mut Bits, text| bits.description = text)?;
            bits.map(|bits| Piece::Bits(bits.into()))
        }
        _ => elements.leaf(tag, |_: &mut Reserved, _| {})?.map(Piece::Reserved),
    })
}

fn read_switch<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>) -> Result<Option<Switch>, Broken> {
    elements.element(tag, |switch: &mut Switch, elements, tag| {
        switch.cases.extend(read_case(elements, tag, switch.span)?);
        Ok(())
    })
}

fn read_case<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>, switch: Span) -> Result<Option<Case>, Broken> {
    let value = (tag.name == "case").then(|| tag.require("value"));
    let mut case = Case { value, pieces: Vec::new(), span: tag.span };
    let is_complete = elements.close_tag(tag);
    while let Some(tag) = elements.next_child()? {
        if tag.name == "switch" {
            elements.refuse(nested(tag.span, switch));
            elements.pass_over()?;
        } else {
            case.pieces.extend(read_piece(elements, tag)?);
        }
    }
    Ok(is_complete.then_some(case))
}

fn nested(inner: Span, outer: Span) -> Diagnostic {
    let problem = Diagnostic::new(Code::NestedSwitch, inner, "a switch stands inside another switch");
    let problem = problem.label("a view has one switch").related(outer, "the outer one");
    problem.help("give each value of the outer one a view of its own, with `if` and `is`")
}
