//! `<bits>`, `<reserved>` and `<switch>`.

use super::super::elements::{Broken, Elements};
use super::super::grammar;
use super::super::tag::Tag;
use crate::diag::{Code, Diagnostic};
use crate::source::Span;
use crate::syntax::overlay::{Bits, Case, Piece, Reserved, Switch};

/// Reads `<bits>` or `<reserved>`; `None` if something required is missing.
pub(super) fn read_piece<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>) -> Result<Option<Piece>, Broken> {
    Ok(match tag.name {
        "bits" => read_bits(elements, tag)?.map(|bits| Piece::Bits(Box::new(bits))),
        _ => read_reserved(elements, tag)?.map(Piece::Reserved),
    })
}

fn read_bits<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Bits>, Broken> {
    let mut bits = Bits {
        name: tag.require("name"),
        at: tag.require("at"),
        width: tag.require("width"),
        enum_: tag.take("enum"),
        signed: tag.take("signed"),
        scale: tag.take("scale"),
        bias: tag.take("bias"),
        units: tag.take("units"),
        exact: tag.take("exact"),
        repeat: tag.take("repeat"),
        stride: tag.take("stride"),
        description: None,
        span: tag.span,
    };
    let complete = elements.close_tag(tag);
    bits.description = elements.trimmed_text(&grammar::BITS)?;
    Ok(complete.then_some(bits))
}

fn read_reserved<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Reserved>, Broken> {
    let reserved = Reserved { at: tag.require("at"), width: tag.require("width"), span: tag.span };
    let complete = elements.close_tag(tag);
    // A text may say why the bits are reserved; nobody but the reader of the file needs it.
    elements.text(&grammar::RESERVED)?;
    Ok(complete.then_some(reserved))
}

/// Reads a switch with its cases.
pub(super) fn read_switch<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Switch, Broken> {
    let mut switch = Switch { field: tag.take("field"), bits: tag.take("bits"), cases: Vec::new(), span: tag.span };
    elements.close_tag(tag);
    while let Some(tag) = elements.next_child(&grammar::SWITCH)? {
        switch.cases.extend(read_case(elements, tag, switch.span)?);
    }
    Ok(switch)
}

fn read_case<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>, switch: Span) -> Result<Option<Case>, Broken> {
    let (value, element) = match tag.name {
        "case" => (Some(tag.require("value")), &grammar::CASE),
        _ => (None, &grammar::DEFAULT),
    };
    let mut case = Case { value, pieces: Vec::new(), span: tag.span };
    let complete = elements.close_tag(tag);
    while let Some(tag) = elements.next_child(element)? {
        if tag.name == "switch" {
            elements.refuse(nested(tag.span, switch));
            elements.skip()?;
        } else {
            case.pieces.extend(read_piece(elements, tag)?);
        }
    }
    Ok(complete.then_some(case))
}

fn nested(inner: Span, outer: Span) -> Diagnostic {
    let problem = Diagnostic::new(Code::NestedSwitch, inner, "a switch stands inside another switch");
    let problem = problem.label("a view has one switch").related(outer, "the outer one");
    problem.help("give each value of the outer one a view of its own, with `if` and `is`")
}
