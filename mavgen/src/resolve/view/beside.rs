//! Fields that a view reads beside its words: keys, sentinels, what a switch looks at.

use super::place::{Index, found, length_differs};
use super::words::Words;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::Place;
use crate::resolve::message_scope::{Found, MessageScope};
use crate::syntax::Text;

/// A scalar, or the element of a slot, for what is read beside the words.
pub(super) fn beside<'s>(
    scope: &MessageScope<'s, '_>,
    text: &Text,
    words: &Words,
    diagnostics: &mut Diagnostics,
) -> Option<(Place, Found<'s>)> {
    let (found, index) = found(scope, text, diagnostics)?;
    let problem = match (index, found.field.ty.array, words.shape) {
        (Index::None, ..) => return Some((Place { field: found.index, element: false }, found)),
        (Index::Slot, Some(length), Some(shape)) if length == shape.length => {
            return Some((Place { field: found.index, element: true }, found));
        }
        (Index::Slot, _, Some(shape)) => length_differs(text, found, shape.length, shape.span),
        (Index::Slot, _, None) => {
            let message = format!("`{}` is the element of a slot, and the view has no slots", text.value);
            let problem =
                Diagnostic::new(Code::Index, text.span, message).related(words.span, "none of these has slots");
            problem.help("name a scalar")
        }
        (Index::All, ..) => {
            let message = format!("`{}` is not one value", text.value);
            let problem = Diagnostic::new(Code::Index, text.span, message).related(found.syntax.ty.span, "the field");
            problem.help("only words can be joined")
        }
    };
    diagnostics.push(problem);
    None
}
