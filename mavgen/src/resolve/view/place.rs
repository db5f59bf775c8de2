//! Fields as a view names them: `x` for a scalar, `x[i]` for the element of a slot, `x[*]` for all of an array.

use std::num::NonZeroU8;

use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::resolve::message_scope::{Found, MessageScope};
use crate::source::Span;
use crate::syntax::Text;

/// Which elements of a field are meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Index {
    /// `x`: it is a scalar.
    None,
    /// `x[i]`: the element of the slot.
    Slot,
    /// `x[*]`: all elements.
    All,
}

/// The name and the index; `Err` is what stands in the brackets and is neither.
fn split(text: &str) -> Result<(&str, Index), &str> {
    match text.split_once('[') {
        None => Ok((text, Index::None)),
        Some((name, "i]")) => Ok((name, Index::Slot)),
        Some((name, "*]")) => Ok((name, Index::All)),
        Some((name, _)) => Err(text.get(name.len()..).unwrap_or_default()),
    }
}

/// The field that `text` names, with an index if and only if it is an array.
pub(super) fn found<'s>(
    scope: &MessageScope<'s, '_>,
    text: &Text,
    diagnostics: &mut Diagnostics,
) -> Option<(Found<'s>, Index)> {
    let (name, index) = match split(text.value.trim()) {
        Ok(split) => split,
        Err(index) => {
            let message = format!("`{index}` is no index");
            let problem = Diagnostic::new(Code::Index, text.span, message);
            diagnostics.push(problem.help("`x[i]` is the element of a slot, `x[*]` all elements of an array"));
            return None;
        }
    };
    let name = Text::new(name.to_owned(), text.span);
    let found = scope.field(&name, diagnostics)?;
    let ty = &found.syntax.ty;
    let problem = match (index, found.field.ty.array) {
        (Index::None, Some(_)) => Diagnostic::new(Code::Index, text.span, format!("`{}` is an array", name.value))
            .help(format!("write `{0}[i]` for the element of a slot, `{0}[*]` for all elements", name.value)),
        (Index::Slot | Index::All, None) => {
            let message = format!("`{}` is a scalar, which has no elements", name.value);
            Diagnostic::new(Code::Index, text.span, message).help(format!("write `{}`", name.value))
        }
        _ => return Some((found, index)),
    };
    diagnostics.push(problem.related(ty.span, "the field"));
    None
}

/// Says that an array has another length than the first array of the view.
pub(super) fn length_differs(text: &Text, found: Found<'_>, length: NonZeroU8, first: Span) -> Diagnostic {
    let own = found.field.ty.array.map_or(0, NonZeroU8::get);
    let message = format!("`{}` has {own} elements, and the view has {length} slots", found.syntax.name.value);
    let problem = Diagnostic::new(Code::WordLengths, text.span, message);
    let problem = problem.related(found.syntax.ty.span, "the field").related(first, format!("{length} elements"));
    problem.help("arrays that are read side by side have one length")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices() {
        for (text, expected) in [
            ("x", Ok(("x", Index::None))),
            ("x[i]", Ok(("x", Index::Slot))),
            ("x[*]", Ok(("x", Index::All))),
            ("x[0]", Err("[0]")),
            ("x[i", Err("[i")),
            ("x[]", Err("[]")),
            ("x[i][i]", Err("[i][i]")),
        ] {
            assert_eq!(split(text), expected, "{text}");
        }
    }
}
