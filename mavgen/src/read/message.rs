//! `<message>` and its fields.

use super::elements::{Broken, Elements};
use super::prose;
use crate::source::Spanned;
use crate::syntax::{Field, Message, Tag};

/// Reads a message; `None` if it has no id or no name.
pub(super) fn read<'t>(elements: &mut Elements<'t, '_>, tag: Tag<'t>) -> Result<Option<Message>, Broken> {
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
        _ => prose::read(elements, tag, &mut message.description, &mut message.lifecycle),
    })
}
