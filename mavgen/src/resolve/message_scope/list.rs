//! Lists in attributes, each part with its own place.

use crate::collect::CollectVec as _;
use crate::source::Span;
use crate::syntax::Text;

/// The parts of a text between blanks.
///
/// A part of a text with character references has the place of the whole: references make it shorter than its source.
pub(in crate::resolve) fn parts(text: &Text) -> Vec<Text> {
    let exact = text.value.len() == text.span.range().len();
    let start = text.value.as_ptr() as usize;
    let part = |part: &str| {
        let at = (part.as_ptr() as usize).wrapping_sub(start) + text.span.range().start;
        let span = if exact { Span::new(text.span.file, at..at + part.len()) } else { text.span };
        Text::new(part.to_owned(), span)
    };
    text.value.split_whitespace().map(part).collect_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Sources;

    #[test]
    fn parts_have_their_places() {
        let file = Sources::default().add("a.xml", "");
        let spans = |length: usize| -> Vec<_> {
            let text = Text::new(" a  bc ".to_owned(), Span::new(file, 10..10 + length));
            parts(&text).into_iter().map(|part| (part.value, part.span.range())).collect()
        };
        assert_eq!(spans(7), [("a".to_owned(), 11..12), ("bc".to_owned(), 14..16)]);
        assert_eq!(spans(9), [("a".to_owned(), 10..19), ("bc".to_owned(), 10..19)]);
    }
}
