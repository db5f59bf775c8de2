//! Overlays of uORB messages: `<uorb-overlay>` and what stands in it.

use super::elements::{Broken, Elements};
use super::grammar;
use super::overlay::document;
use super::tag::Tag;
use crate::diag::Diagnostics;
use crate::source::{FileId, Sources};
use crate::syntax::uorb_overlay::{Field, Message, Overlay};

/// Reads one overlay of uORB messages, as [`super::read_overlay`] reads one of a dialect.
pub fn read(id: FileId, sources: &Sources, diagnostics: &mut Diagnostics) -> Overlay {
    let mut overlay = Overlay { id, version: None, base: None, messages: Vec::new() };
    (overlay.version, overlay.base) = document(id, sources, diagnostics, &grammar::UORB_OVERLAY, |elements, tag| {
        overlay.messages.extend(read_message(elements, tag)?);
        Ok(())
    });
    overlay
}

fn read_message<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Message>, Broken> {
    let mut message = Message { name: tag.require("name"), fields: Vec::new(), span: tag.span };
    let complete = elements.close_tag(tag);
    while let Some(tag) = elements.next_child(&grammar::UORB_MESSAGE)? {
        message.fields.extend(read_field(elements, tag)?);
    }
    Ok(complete.then_some(message))
}

fn read_field<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>) -> Result<Option<Field>, Broken> {
    let field = Field {
        name: tag.require("name"),
        enum_: tag.take("enum"),
        flags: tag.take("flags"),
        constants: tag.take("constants"),
        bits: tag.take("bits"),
        except: tag.take("except"),
        units: tag.take("units"),
        invalid: tag.take("invalid"),
        was: tag.take("was"),
        span: tag.span,
    };
    let complete = elements.close_tag(tag);
    elements.text(&grammar::UORB_FIELD)?;
    Ok(complete.then_some(field))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::Text;

    #[test]
    fn everything_of_an_overlay() {
        let text = concat!(
            "<uorb-overlay version='1' for='msg'><message name='M'>",
            "<field name='f' enum='E' flags='F' constants='A_*' bits='B_*' except='C' units='m' invalid='0' was='g'/>",
            "</message></uorb-overlay>",
        );
        let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
        let id = sources.add("a.xml", text);
        let overlay = read(id, &sources, &mut diagnostics);
        assert!(diagnostics.is_empty(), "{diagnostics:?}");
        let value = |text: &Option<Text>| {
            let text = text.as_ref().unwrap();
            assert_eq!(sources.get(id).unwrap().text()[text.span.range()], text.value);
            text.value.clone()
        };
        assert_eq!([&overlay.version, &overlay.base].map(value), ["1", "msg"]);
        let message = &overlay.messages[0];
        let field = &message.fields[0];
        assert_eq!((message.name.value.as_str(), field.name.value.as_str()), ("M", "f"));
        let Field { enum_, flags, constants, bits, except, units, invalid, was, .. } = field;
        let attributes = [enum_, flags, constants, bits, except, units, invalid, was].map(value);
        assert_eq!(attributes, ["E", "F", "A_*", "B_*", "C", "m", "0", "g"]);
    }
}
