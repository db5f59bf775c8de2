//! `<view>`: its keys, its sentinels and its bits, or its values.

use super::super::elements::{Broken, Elements};
use super::super::grammar;
use super::super::tag::Tag;
use super::{parts, read_condition};
use crate::syntax::overlay::{Invalid, Key, Part, View};

/// Reads a view; `None` if it has no name.
pub(super) fn read<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<View>, Broken> {
    let mut view = View {
        name: tag.require("name"),
        words: tag.take("words"),
        item: tag.take("item"),
        items: tag.take("items"),
        count: tag.take("count"),
        partial: tag.take("partial"),
        condition: read_condition(&mut tag),
        keys: Vec::new(),
        values: Vec::new(),
        invalids: Vec::new(),
        parts: Vec::new(),
        description: None,
        span: tag.span,
    };
    let complete = elements.close_tag(tag);
    let mut described = None;
    while let Some(tag) = elements.next_child(&grammar::VIEW)? {
        match tag.name {
            "key" => view.keys.extend(read_key(elements, tag, &grammar::KEY)?),
            "value" => view.values.extend(read_key(elements, tag, &grammar::VALUE)?),
            "invalid" => view.invalids.extend(read_invalid(elements, tag)?),
            "switch" => view.parts.push(Part::Switch(parts::read_switch(elements, tag)?)),
            "description" => {
                match described {
                    Some(first) => elements.repeated(&tag, first),
                    None => described = Some(tag.span),
                }
                elements.close_tag(tag);
                view.description = elements.trimmed_text(&grammar::DESCRIPTION)?;
            }
            _ => view.parts.extend(parts::read_piece(elements, tag)?.map(Part::Piece)),
        }
    }
    let text = elements.trimmed_content();
    view.description = view.description.or(text);
    Ok(complete.then_some(view))
}

/// A key, or a value, which is spelled alike.
fn read_key<'t>(
    elements: &mut Elements<'t, '_>,
    mut tag: Tag<'t>,
    grammar: &'static grammar::Element,
) -> Result<Option<Key>, Broken> {
    let mut key = Key {
        name: tag.require("name"),
        field: tag.require("field"),
        units: tag.take("units"),
        invalid: tag.take("invalid"),
        description: None,
        span: tag.span,
    };
    let complete = elements.close_tag(tag);
    key.description = elements.trimmed_text(grammar)?;
    Ok(complete.then_some(key))
}

fn read_invalid<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Invalid>, Broken> {
    let invalid = Invalid { field: tag.take("field"), value: tag.require("value"), span: tag.span };
    let complete = elements.close_tag(tag);
    elements.text(&grammar::INVALID)?;
    Ok(complete.then_some(invalid))
}
