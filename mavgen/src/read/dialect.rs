//! What stands in a dialect file: enums and messages, and what may be said of anything.

use super::elements::{Broken, Elements};
use crate::source::Spanned;
use crate::syntax::{Entry, Enum, Field, File, Lifecycle, Message, Param, Stage, Tag, Text, Version};

/// Reads an element of a dialect file. Of `<version>` and `<dialect>`, the last counts.
pub(super) fn read_child<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>, file: &mut File) -> Result<(), Broken> {
    let (name, span) = (tag.name, tag.span);
    if matches!(name, "version" | "dialect") {
        elements.check_repeated(&tag, &[name]);
    }
    elements.close_tag(tag);
    match name {
        "enums" => return read_enums(elements, &mut file.enums),
        "messages" => {
            while let Some(tag) = elements.next_child()? {
                file.messages.extend(read_message(elements, tag)?);
            }
        }
        "include" => {
            let path = elements.text()?;
            file.includes.push(path.unwrap_or_else(|| Spanned::new(String::new(), span)));
        }
        "dialect" => file.dialect = elements.text()?,
        _ => {
            let messages_before = file.messages.len();
            file.version = elements.text()?.map(|text| Version { text, messages_before });
        }
    }
    Ok(())
}

/// Reads the enums in an element.
pub(super) fn read_enums(elements: &mut Elements<'_, '_>, enums: &mut Vec<Enum>) -> Result<(), Broken> {
    while let Some(tag) = elements.next_child()? {
        enums.extend(elements.element(tag, |one: &mut Enum, elements, tag| {
            if tag.name == "entry" {
                one.entries.extend(read_entry(elements, tag)?);
                return Ok(());
            }
            read_prose(elements, tag, &mut one.description, &mut one.lifecycle)
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
        read_prose(elements, tag, &mut entry.description, &mut entry.lifecycle)
    })
}

/// Reads a message; `None` if it has no id or no name.
fn read_message<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>) -> Result<Option<Message>, Broken> {
    elements.element(tag, |message: &mut Message, elements, tag| match tag.name {
        "field" => {
            message.fields.extend(elements.leaf(tag, |field: &mut Field, text| field.description = text)?);
            Ok(())
        }
        "extensions" => {
            message.extensions.push(Spanned::new(message.fields.len(), tag.span));
            elements.close_tag(tag);
            elements.text().map(drop)
        }
        _ => read_prose(elements, tag, &mut message.description, &mut message.lifecycle),
    })
}

/// Reads `<description>`, `<wip>`, `<superseded>` or `<deprecated>`. Of two stages the last counts, and descriptions are
/// joined, as pymavlink does it.
fn read_prose<'t>(
    elements: &mut Elements<'t, '_>,
    mut tag: Tag<'t>,
    description: &mut Option<Text>,
    lifecycle: &mut Option<Lifecycle>,
) -> Result<(), Broken> {
    let stage = match tag.name {
        "wip" => Stage::Wip,
        "superseded" => Stage::Superseded,
        "deprecated" => Stage::Deprecated,
        _ => {
            elements.check_repeated(&tag, &["description"]);
            elements.close_tag(tag);
            match (description, elements.text()?) {
                (Some(description), Some(more)) => description.value.push_str(&more.value),
                (description, more) => *description = description.take().or(more),
            }
            return Ok(());
        }
    };
    elements.check_repeated(&tag, &["wip", "superseded", "deprecated"]);
    let (span, since) = (tag.span, tag.take("since"));
    let replaced_by = tag.take("replaced_by").filter(|_| stage != Stage::Wip);
    elements.close_tag(tag);
    *lifecycle = Some(Lifecycle { stage, since, replaced_by, description: elements.text()?, span });
    Ok(())
}
