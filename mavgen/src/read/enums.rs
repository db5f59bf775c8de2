//! `<enum>`, its entries and their params.

use super::elements::{Broken, Elements};
use super::grammar;
use super::prose::Prose;
use super::tag::Tag;
use crate::syntax::{Entry, Enum, Param};

/// Reads an enum; `None` if it has no name.
pub(super) fn read<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Enum>, Broken> {
    let span = tag.span;
    let (name, bitmask) = (tag.require("name"), tag.take("bitmask"));
    let complete = elements.close_tag(tag);
    let mut prose = Prose::default();
    let mut entries = Vec::new();
    while let Some(tag) = elements.next_child(&grammar::ENUM)? {
        match tag.name {
            "entry" => entries.extend(read_entry(elements, tag)?),
            _ => prose.read(elements, tag)?,
        }
    }
    let Prose { description, lifecycle, .. } = prose;
    Ok(complete.then_some(Enum { name, bitmask, lifecycle, description, entries, span }))
}

fn read_entry<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Entry>, Broken> {
    let mut entry = Entry {
        name: tag.require("name"),
        value: tag.take("value"),
        has_location: tag.take("hasLocation"),
        is_destination: tag.take("isDestination"),
        mission_only: tag.take("missionOnly"),
        lifecycle: None,
        description: None,
        params: Vec::new(),
        span: tag.span,
    };
    let complete = elements.close_tag(tag);
    let mut prose = Prose::default();
    while let Some(tag) = elements.next_child(&grammar::ENTRY)? {
        match tag.name {
            "param" => entry.params.extend(read_param(elements, tag)?),
            _ => prose.read(elements, tag)?,
        }
    }
    (entry.description, entry.lifecycle) = (prose.description, prose.lifecycle);
    Ok(complete.then_some(entry))
}

fn read_param<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Param>, Broken> {
    let mut param = Param {
        index: tag.require("index"),
        label: tag.take("label"),
        units: tag.take("units"),
        enum_: tag.take("enum"),
        increment: tag.take("increment"),
        min: tag.take("minValue"),
        max: tag.take("maxValue"),
        reserved: tag.take("reserved"),
        default: tag.take("default"),
        description: None,
        span: tag.span,
    };
    let complete = elements.close_tag(tag);
    param.description = elements.text(&grammar::PARAM)?;
    Ok(complete.then_some(param))
}
