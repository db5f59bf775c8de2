//! What XML says of single characters: which are legal, which make a name, and what references stand for.

use std::borrow::Cow;
use std::ops::Range;

use quick_xml::escape::{EscapeError, unescape};

use super::fault::{Fault, not_well_formed};
use crate::diag::{Code, Diagnostic};
use crate::source::Part;

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
pub(super) fn expand(reference: Part<'_>) -> Result<Cow<'_, str>, Fault> {
    let (span, reference) = (reference.span(), reference.text);
    match unescape(reference) {
        Ok(text) if illegal(&text).is_none() => Ok(text),
        Ok(_) | Err(EscapeError::InvalidCharRef(_)) => {
            Err(not_well_formed(span, format!("`{reference}` is not a character that XML allows")).into())
        }
        Err(EscapeError::UnrecognizedEntity(_, name)) if is_name(&name) => {
            let help = "XML knows `&amp;`, `&lt;`, `&gt;`, `&quot;` and `&apos;`; write any other character itself, or by its number as in `&#176;`";
            Err(Diagnostic::new(Code::UnknownEntity, span, format!("unknown entity `{reference}`")).help(help).into())
        }
        Err(_) => Err(not_well_formed(span, "`&` starts no reference").help("write `&amp;` for a plain `&`").into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Sources;

    #[test]
    fn references() {
        let id = Sources::default().add("a.xml", "");
        let code = |reference: &'static str| expand(Part::whole(id, reference)).map_err(|diagnostic| diagnostic.code);
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
