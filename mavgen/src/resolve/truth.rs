//! Truth values that pymavlink takes for something else.
//!
//! The schema allows `true`, `false`, `1` and `0` everywhere, and so do we. pymavlink's `mavparse` compares texts, each
//! attribute in its own way, so that some spellings mean the opposite to whoever generates C or Python from the same file.

use super::number;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::syntax::Text;

/// An attribute with a truth value, by the way in which pymavlink reads it.
#[derive(Clone, Copy)]
pub(super) enum Attribute {
    /// Only the text `true` counts: `bitmask`.
    OnlyTrue(&'static str),
    /// Any text counts, even `false`: `instance`, `reserved`.
    AnyText(&'static str),
    /// Anything but `true` and `false` is refused: `hasLocation`.
    OnlyWords(&'static str),
    /// Never looked at.
    Unread,
}

/// A truth value; absent is false.
pub(super) fn read(text: Option<&Text>, attribute: Attribute, diagnostics: &mut Diagnostics) -> bool {
    let Some(text) = text else { return false };
    let Some(truth) = number::truth(text, diagnostics) else { return false };
    let taken = match (attribute, text.value.as_str()) {
        (Attribute::OnlyTrue(name), value) if truth && value != "true" => Some((name, "takes for false")),
        (Attribute::AnyText(name), _) if !truth => Some((name, "takes for true")),
        (Attribute::OnlyWords(name), value) if !matches!(value, "true" | "false") => Some((name, "refuses")),
        _ => None,
    };
    if let Some((name, taken)) = taken {
        let message = format!("`{name}=\"{}\"` is {truth}, which pymavlink {taken}", text.value);
        let problem = Diagnostic::new(Code::TruthSpelling, text.span, message);
        diagnostics.push(problem.help(match (attribute, truth) {
            (Attribute::AnyText(_), _) => format!("leave `{name}` out"),
            _ => format!("write `{name}=\"{truth}\"`"),
        }));
    }
    truth
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::{Sources, Span};

    #[test]
    fn spellings_that_pymavlink_takes_otherwise() {
        let (only_true, any, words) = (Attribute::OnlyTrue("a"), Attribute::AnyText("a"), Attribute::OnlyWords("a"));
        for (attribute, text, truth, warned) in [
            (only_true, "true", true, false),
            (only_true, "1", true, true),
            (only_true, " true", true, true),
            (only_true, "false", false, false),
            (any, "1", true, false),
            (any, "false", false, true),
            (any, "0", false, true),
            (words, "true", true, false),
            (words, "false", false, false),
            (words, "1", true, true),
            (words, "0", false, true),
            (Attribute::Unread, "1", true, false),
        ] {
            let span = Span::new(Sources::default().add("a.xml", text), 0..text.len());
            let mut diagnostics = Diagnostics::default();
            assert_eq!(read(Some(&Text::new(text.to_owned(), span)), attribute, &mut diagnostics), truth, "{text}");
            assert_eq!(!diagnostics.is_empty(), warned, "{text}");
        }
    }
}
