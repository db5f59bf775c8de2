//! Overlays of uORB messages: `<uorb-overlay>` and what stands in it.

use super::{document, grammar};
use crate::diag::Diagnostics;
use crate::source::{FileId, Sources};
use crate::syntax::uorb_overlay::{Field, Message, Overlay};

/// Reads one overlay of uORB messages, as [`super::read_overlay`] reads one of a dialect.
pub fn read(id: FileId, sources: &Sources, diagnostics: &mut Diagnostics) -> Overlay {
    let mut messages = Vec::new();
    let (version, base) = document(id, sources, diagnostics, &grammar::UORB_OVERLAY, |elements, tag| {
        messages.extend(elements.element(tag, |message: &mut Message, elements, tag| {
            message.fields.extend(elements.leaf(tag, |_: &mut Field, _| {})?);
            Ok(())
        })?);
        Ok(())
    });
    Overlay { id, version, base, messages }
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
