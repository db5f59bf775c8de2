//! `invalid`: the values that say that a view or a key means nothing.

use super::beside::beside;
use super::words::Words;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Condition, Place, Scalar, Sentinel, ViewSentinel};
use crate::resolve::invalid::{self, Refusal};
use crate::resolve::message_scope::{Found, MessageScope};
use crate::source::Span;
use crate::syntax::Text;
use crate::syntax::overlay::{Invalid, View};

/// Resolves all `<invalid>` of a view. Each says something new, and none that the view is never there.
pub(super) fn sentinels(
    scope: &MessageScope<'_, '_>,
    element: &View,
    words: &Words,
    condition: Option<Condition>,
    diagnostics: &mut Diagnostics,
) -> Vec<ViewSentinel> {
    let mut found: Vec<(ViewSentinel, Span)> = Vec::new();
    let demanded = condition.zip(element.condition.value.as_ref()).map(|(condition, text)| {
        let place = Place { field: condition.field, element: false };
        (ViewSentinel::Field(place, condition.value.into()), text.span)
    });
    for invalid in &element.invalids {
        let Some(sentinel) = sentinel(scope, invalid, words, diagnostics) else { continue };
        let span = invalid.value.span;
        let (first, message, label) = match (found.iter().find(|first| first.0 == sentinel), demanded) {
            (Some(first), _) => (first.1, "the view is unknown by this value already", "the first time"),
            (None, Some(demanded)) if demanded.0 == sentinel => {
                (demanded.1, "the view is unknown by the value on which it is there", "the condition")
            }
            (None, _) => {
                found.push((sentinel, span));
                continue;
            }
        };
        let problem = Diagnostic::new(Code::Sentinel, span, message).related(first, label);
        diagnostics.push(problem.help("leave it out, or correct it"));
    }
    found.into_iter().map(|(sentinel, _)| sentinel).collect_vec()
}

fn sentinel(
    scope: &MessageScope<'_, '_>,
    element: &Invalid,
    words: &Words,
    diagnostics: &mut Diagnostics,
) -> Option<ViewSentinel> {
    let Some(field) = &element.field else {
        return of_words(scope, &element.value, words, diagnostics);
    };
    let (place, found) = beside(scope, field, words, diagnostics)?;
    of_field(scope, &element.value, found, diagnostics).map(|value| ViewSentinel::Field(place, value))
}

/// A value of the joined words.
fn of_words(
    scope: &MessageScope<'_, '_>,
    text: &Text,
    words: &Words,
    diagnostics: &mut Diagnostics,
) -> Option<ViewSentinel> {
    let largest = u128::MAX >> (128 - u32::from(words.width));
    let number = invalid::integer(text.value.trim(), scope.entries);
    let problem = match number.map(u128::try_from) {
        Some(Ok(number)) if number <= largest => return Some(ViewSentinel::Words(number)),
        Some(_) => {
            let message = format!("`{}` does not fit the {} bits of the words", text.value, words.width);
            Diagnostic::new(Code::Sentinel, text.span, message).help("leave it out, or correct it")
        }
        None => not_understood(text),
    };
    diagnostics.push(problem.related(words.span, "the words"));
    None
}

/// A value of an integer field.
pub(super) fn of_field(
    scope: &MessageScope<'_, '_>,
    text: &Text,
    found: Found<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<i128> {
    let (ty, name) = (&found.syntax.ty, &found.syntax.name.value);
    let scalar = found.field.ty.scalar;
    if scalar.repr().is_none() && !matches!(scalar, Scalar::Version(_)) {
        let message = format!("`{}.{name}` is `{}`, which is compared with no number", scope.name(), ty.value);
        let problem = Diagnostic::new(Code::UnsuitableField, text.span, message).related(ty.span, "the field");
        diagnostics.push(problem.help("`invalid` compares integers"));
        return None;
    }
    let problem = match invalid::sentinel(text.value.trim(), scalar, scope.entries) {
        Ok(Sentinel::Integer(value)) => return Some(value),
        Err(Refusal::Unknown) if !scope.entries.complete => return None,
        Err(Refusal::Range) => {
            let message = format!("`{}.{name}` is never `{}`: it is `{}`", scope.name(), text.value, ty.value);
            Diagnostic::new(Code::Sentinel, text.span, message).help("leave it out, or correct it")
        }
        Ok(_) | Err(_) => not_understood(text),
    };
    diagnostics.push(problem.related(ty.span, "the field"));
    None
}

fn not_understood(text: &Text) -> Diagnostic {
    let message = format!("`{}` is not a number", text.value);
    let problem = Diagnostic::new(Code::Sentinel, text.span, message);
    problem.help("write a number, a limit like `UINT16_MAX`, or the name of an enum entry")
}
