//! `<message>` and its fields.

use super::elements::{Broken, Elements};
use super::grammar;
use super::prose::Prose;
use super::tag::Tag;
use crate::source::Spanned;
use crate::syntax::{Field, Message};

/// Reads a message; `None` if it has no id or no name.
pub(super) fn read<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Message>, Broken> {
    let span = tag.span;
    let (id, name) = (tag.require("id"), tag.require("name"));
    let complete = elements.close_tag(tag);
    let mut prose = Prose::default();
    let (mut fields, mut extensions) = (Vec::new(), Vec::new());
    while let Some(tag) = elements.next_child(&grammar::MESSAGE)? {
        match tag.name {
            "field" => fields.extend(read_field(elements, tag)?),
            "extensions" => {
                extensions.push(Spanned::new(fields.len(), tag.span));
                elements.close_tag(tag);
                elements.text(&grammar::EXTENSIONS)?;
            }
            _ => prose.read(elements, tag)?,
        }
    }
    let Prose { description, lifecycle, .. } = prose;
    Ok(complete.then_some(Message { id, name, lifecycle, description, fields, extensions, span }))
}

fn read_field<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Field>, Broken> {
    let mut field = Field {
        ty: tag.require("type"),
        name: tag.require("name"),
        enum_: tag.take("enum"),
        display: tag.take("display"),
        units: tag.take("units"),
        print_format: tag.take("print_format"),
        default: tag.take("default"),
        min: tag.take("minValue"),
        max: tag.take("maxValue"),
        increment: tag.take("increment"),
        multiplier: tag.take("multiplier"),
        invalid: tag.take("invalid"),
        instance: tag.take("instance"),
        description: None,
        span: tag.span,
    };
    let complete = elements.close_tag(tag);
    field.description = elements.text(&grammar::FIELD)?;
    Ok(complete.then_some(field))
}
