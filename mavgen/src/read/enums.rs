//! `<enums>`: enums, their entries and the params of these.

use super::elements::{Broken, Elements};
use super::prose;
use crate::syntax::{Entry, Enum, Param, Tag};

/// Reads the enums in an element.
pub(super) fn read(elements: &mut Elements<'_, '_>, enums: &mut Vec<Enum>) -> Result<(), Broken> {
    while let Some(tag) = elements.next_child()? {
        enums.extend(elements.element(tag, |one: &mut Enum, elements, tag| {
            if tag.name == "entry" {
                one.entries.extend(read_entry(elements, tag)?);
                return Ok(());
            }
            prose::read(elements, tag, &mut one.description, &mut one.lifecycle)
        })?);
    }
    Ok(())
}

fn read_entry<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>) -> Result<Option<Entry>, Broken> {
    elements.element(tag, |entry: &mut Entry, elements, tag| {
        if tag.name == "param" {
            entry.params.extend(elements.leaf(tag, |param: &mut Param, text| param.description = text)?);
            return Ok(());
        }
        prose::read(elements, tag, &mut entry.description, &mut entry.lifecycle)
    })
}
