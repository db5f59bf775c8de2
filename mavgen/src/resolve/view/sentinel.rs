//! `invalid`: the values that say that a view or a key means nothing.

use super::words::{Words, beside};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic};
use crate::ir::{Condition, Place, Scalar, Sentinel, ViewSentinel, mask};
use crate::resolve::invalid::{self, Refusal};
use crate::resolve::message_scope::{Found, MessageScope};
use crate::source::Span;
use crate::syntax::Text;
use crate::syntax::overlay::{Invalid, View};

/// Resolves all `<invalid>` of a view. Each says something new, and none that the view is never there.
pub(super) fn sentinels(
    scope: &mut MessageScope<'_, '_>,
    element: &View,
    words: &Words,
    condition: Option<Condition>,
) -> Vec<ViewSentinel> {
    let mut found: Vec<(ViewSentinel, Span)> = Vec::new();
    let demanded = condition.zip(element.condition.value.as_ref()).map(|(condition, text)| {
        let place = Place { field: condition.field, element: false };
        (ViewSentinel::Field(place, condition.value.into()), text.span)
    });
    for invalid in &element.invalids {
        let Some(sentinel) = sentinel(scope, invalid, words) else { continue };
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
        scope.report(problem.help("leave it out, or correct it"));
    }
    found.into_iter().map(|(sentinel, _)| sentinel).collect_vec()
}

fn sentinel(scope: &mut MessageScope<'_, '_>, element: &Invalid, words: &Words) -> Option<ViewSentinel> {
    match &element.field {
        Some(field) => {
            let (place, found) = beside(scope, field, words)?;
            of_field(scope, &element.value, found).map(|value| ViewSentinel::Field(place, value))
        }
        None => of_words(scope, &element.value, words),
    }
}

fn of_words(scope: &mut MessageScope<'_, '_>, text: &Text, words: &Words) -> Option<ViewSentinel> {
    let number = invalid::integer(text.value.trim(), scope.entries);
    let problem = match number.map(u128::try_from) {
        Some(Ok(number)) if number <= mask(0, words.width, None) => return Some(ViewSentinel::Words(number)),
        Some(_) => {
            let message = format!("`{}` does not fit the {} bits of the words", text.value, words.width);
            Diagnostic::new(Code::Sentinel, text.span, message).help("leave it out, or correct it")
        }
        None => not_understood(text),
    };
    scope.refuse(problem.related(words.span, "the words"))
}

pub(super) fn of_field(scope: &mut MessageScope<'_, '_>, text: &Text, found: Found<'_>) -> Option<i128> {
    let scalar = found.field.ty.scalar;
    if scalar.repr().is_none() && !matches!(scalar, Scalar::Version(_)) {
        let why = ("is compared with no number", "`invalid` compares integers");
        return scope.refuse_type(Code::UnsuitableField, text.span, found, why);
    }
    let ty = &found.syntax.ty;
    let problem = match invalid::sentinel(text.value.trim(), scalar, scope.entries) {
        Ok(Sentinel::Integer(value)) => return Some(value),
        Err(Refusal::Unknown) if !scope.entries.complete => return None,
        Err(Refusal::Range) => {
            let field = &found.syntax.name.value;
            let message = format!("`{}.{field}` is never `{}`: it is `{}`", scope.name(), text.value, ty.value);
            Diagnostic::new(Code::Sentinel, text.span, message).help("leave it out, or correct it")
        }
        Ok(_) | Err(_) => not_understood(text),
    };
    scope.refuse(problem.related(ty.span, "the field"))
}

fn not_understood(text: &Text) -> Diagnostic {
    let message = format!("`{}` is not a number", text.value);
    let problem = Diagnostic::new(Code::Sentinel, text.span, message);
    problem.help("write a number, a limit like `UINT16_MAX`, or the name of an enum entry")
}
