//! Booleans, and those that pymavlink takes for something else.
//!
//! The schema allows `true`, `false`, `1` and `0` everywhere, and so do we. pymavlink's `mavparse` compares texts, each
//! attribute in its own way, so that some spellings mean the opposite to whoever generates C or Python from the same file.

use super::number;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::syntax::Text;

/// An attribute with a boolean, by the way in which pymavlink reads it.
#[derive(Clone, Copy, Debug)]
pub(super) enum Attribute {
    /// Only the text `true` counts: `bitmask`.
    OnlyTrue(&'static str),
    /// Any text counts but an empty one, even `false`: `instance`, `reserved`.
    AnyText(&'static str),
    /// Anything but `true` and `false` is refused: `hasLocation`.
    OnlyWords(&'static str),
    /// Never looked at: `isDestination`.
    Unread(&'static str),
}

impl Attribute {
    fn name(self) -> &'static str {
        match self {
            Self::OnlyTrue(name) | Self::AnyText(name) | Self::OnlyWords(name) | Self::Unread(name) => name,
        }
    }
}

/// A boolean of a dialect; absent is false. A text that is none is what pymavlink takes it for, where it decides nothing but
/// documentation.
pub(super) fn read(text: &Option<Text>, attribute: Attribute, diagnostics: &mut Diagnostics) -> bool {
    let Some(text) = text else { return false };
    let (name, spelled) = (attribute.name(), text.value.as_str());
    let problem = |message| Diagnostic::new(Code::TruthSpelling, text.span, message);
    let Some(value) = number::boolean(spelled) else {
        let value = matches!(attribute, Attribute::AnyText(_)) && !spelled.is_empty();
        diagnostics.push(match attribute {
            Attribute::OnlyTrue(_) | Attribute::OnlyWords(_) => not_a_boolean(text),
            Attribute::AnyText(_) | Attribute::Unread(_) => {
                let problem = problem(format!("`{name}=\"{spelled}\"` is neither `true` nor `false`"));
                let problem = problem.label(format!("taken for {value}"));
                problem.help("write `true` or `false`; pymavlink's validation refuses anything else")
            }
        });
        return value;
    };
    let taken = match attribute {
        Attribute::OnlyTrue(_) if value && spelled != "true" => "takes for false",
        Attribute::AnyText(_) if !value => "takes for true",
        Attribute::OnlyWords(_) if !matches!(spelled, "true" | "false") => "refuses",
        _ => return value,
    };
    let problem = problem(format!("`{name}=\"{spelled}\"` is {value}, which pymavlink {taken}"));
    diagnostics.push(problem.help(match attribute {
        Attribute::AnyText(_) => format!("leave `{name}` out"),
        _ => format!("write `{name}=\"{value}\"`"),
    }));
    value
}

/// A boolean of an overlay; `None` if it is none, which is reported, or absent.
pub(super) fn of_overlay(text: &Option<Text>, diagnostics: &mut Diagnostics) -> Option<bool> {
    let text = text.as_ref()?;
    let value = number::boolean(&text.value);
    if value.is_none() {
        diagnostics.push(not_a_boolean(text));
    }
    value
}

fn not_a_boolean(text: &Text) -> Diagnostic {
    let message = format!("`{}` is not a truth value", text.value.trim());
    Diagnostic::new(Code::BadBoolean, text.span, message).help("write `true` or `false`")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::{Sources, Span};

    #[test]
    fn as_pymavlink_takes_them() {
        let (only_true, any, words) = (Attribute::OnlyTrue("a"), Attribute::AnyText("a"), Attribute::OnlyWords("a"));
        let unread = Attribute::Unread("a");
        let (spelling, bad) = (Some(Code::TruthSpelling), Some(Code::BadBoolean));
        for (attribute, text, expected, told) in [
            (only_true, "true", true, None),
            (only_true, "1", true, spelling),
            (only_true, " true", true, spelling),
            (only_true, "false", false, None),
            (only_true, "yes", false, bad),
            (any, "1", true, None),
            (any, "false", false, spelling),
            (any, "0", false, spelling),
            (any, "maybe", true, spelling),
            (any, "", false, spelling),
            (words, "true", true, None),
            (words, "false", false, None),
            (words, "1", true, spelling),
            (words, "0", false, spelling),
            (words, "maybe", false, bad),
            (unread, "1", true, None),
            (unread, "maybe", false, spelling),
        ] {
            let span = Span::new(Sources::default().add("a.xml", text), 0..text.len());
            let mut diagnostics = Diagnostics::default();
            assert_eq!(read(&Some(Text::new(text.to_owned(), span)), attribute, &mut diagnostics), expected, "{text}");
            assert_eq!(diagnostics.iter().next().map(|problem| problem.code), told, "{attribute:?} {text}");
        }
    }
}
