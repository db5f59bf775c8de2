//! What XML says of single characters: which are legal, which make a name, and what references stand for.

use std::borrow::Cow;
use std::ops::Range;

use quick_xml::escape::{EscapeError, unescape};

use crate::diag::{Code, Diagnostic};
use crate::source::Span;

/// The blanks of XML; Unicode has more.
pub(super) const BLANKS: [char; 4] = [' ', '\t', '\r', '\n'];

/// What to do about a character in what should be a name that looks like a blank, and is none to XML.
pub(super) fn wrong_blank(name: &str) -> Option<String> {
    let blank = name.chars().find(|letter| letter.is_whitespace())?;
    Some(format!("write a plain blank for the character U+{:04X}, which only looks like one", u32::from(blank)))
}

/// Whether XML 1.0 allows a character in a document, even as a reference.
fn is_legal(character: char) -> bool {
    !matches!(character, '\0'..='\x08' | '\x0b' | '\x0c' | '\x0e'..='\x1f' | '\u{fffe}' | '\u{ffff}')
}

/// The first character that XML does not allow at all.
pub(super) fn illegal(text: &str) -> Option<(Range<usize>, char)> {
    let (at, character) = text.char_indices().find(|&(_, character)| !is_legal(character))?;
    Some((at..at + character.len_utf8(), character))
}

/// Whether `text` is a name of an element, an attribute or a processing instruction.
pub(super) fn is_name(text: &str) -> bool {
    let mut letters = text.chars();
    letters.next().is_some_and(|first| first.is_alphabetic() || matches!(first, '_' | ':'))
        && letters.all(|next| next.is_alphanumeric() || matches!(next, '_' | ':' | '-' | '.' | '·'))
}

/// What a reference stands for: `reference` is all of it, from `&` to `;`.
pub(super) fn expand(reference: &str, span: Span) -> Result<Cow<'_, str>, Box<Diagnostic>> {
    let wrong = |code, message: String| Diagnostic::new(code, span, message);
    let plain = "write `&amp;` for a plain `&`";
    match unescape(reference) {
        Ok(text) if illegal(&text).is_none() => Ok(text),
        Ok(_) | Err(EscapeError::InvalidCharRef(_)) => {
            let message = format!("`{reference}` is not a character that XML allows");
            Err(wrong(Code::NotWellFormed, message).into())
        }
        Err(EscapeError::UnrecognizedEntity(_, name)) if is_name(&name) => {
            let help = "XML knows `&amp;`, `&lt;`, `&gt;`, `&quot;` and `&apos;`; write any other character itself, or by its number as in `&#176;`";
            Err(wrong(Code::UnknownEntity, format!("unknown entity `{reference}`")).help(help).into())
        }
        Err(_) => {
            let message = "`&` starts no reference";
            Err(wrong(Code::NotWellFormed, message.to_owned()).help(plain).into())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Sources;

    #[test]
    fn references() {
        let span = Span::new(Sources::default().add("a.xml", ""), 0..0);
        let code = |reference: &'static str| expand(reference, span).map_err(|diagnostic| diagnostic.code);
        for (reference, expected) in [
            ("&amp;", Ok("&")),
            ("&lt;", Ok("<")),
            ("&gt;", Ok(">")),
            ("&quot;", Ok("\"")),
            ("&apos;", Ok("'")),
            ("&#176;", Ok("°")),
            ("&#xB0;", Ok("°")),
            ("&#x1F600;", Ok("😀")),
            ("&#10;", Ok("\n")),
            ("&deg;", Err(Code::UnknownEntity)),
            ("&#0;", Err(Code::NotWellFormed)),
            ("&#1;", Err(Code::NotWellFormed)),
            ("&#xD800;", Err(Code::NotWellFormed)),
            ("&#x110000;", Err(Code::NotWellFormed)),
            ("&#99999999999999999999;", Err(Code::NotWellFormed)),
            ("&#;", Err(Code::NotWellFormed)),
            ("&;", Err(Code::NotWellFormed)),
            ("& b;", Err(Code::NotWellFormed)),
            ("&a&amp;", Err(Code::NotWellFormed)),
        ] {
            assert_eq!(code(reference).as_deref(), expected.as_deref(), "{reference}");
        }
    }

    #[test]
    fn names() {
        for name in ["a", "_a", "xsi:noNamespaceSchemaLocation", "print_format", "é1", "a-b.c"] {
            assert!(is_name(name), "{name}");
        }
        for name in ["", "1a", "-a", "a b", "a<b", "a\"", "/"] {
            assert!(!is_name(name), "{name}");
        }
    }

    #[test]
    fn control_characters_are_illegal() {
        assert_eq!(illegal("a\t\r\n°\u{85}"), None);
        assert_eq!(illegal("°\0"), Some((2..3, '\0')));
        assert_eq!(illegal("\u{ffff}"), Some((0..3, '\u{ffff}')));
    }
}
