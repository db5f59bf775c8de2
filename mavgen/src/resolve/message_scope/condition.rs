//! Conditions: `if="autopilot" is="MAV_AUTOPILOT_AUTOQUAD"`.

use super::super::number;
use super::super::suggest::suggest;
use super::{Found, MessageScope};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{self, Repr};
use crate::syntax::Text;
use crate::syntax::overlay::Condition;

/// Resolves a condition: nothing if there is none. What is wrong with one is reported.
pub(in crate::resolve) fn resolve(
    scope: &MessageScope<'_, '_>,
    condition: &Condition,
    diagnostics: &mut Diagnostics,
) -> Option<ir::Condition> {
    let (name, value) = (condition.field.as_ref()?, condition.value.as_ref()?);
    let found = scope.field(name, diagnostics)?;
    let repr = found.field.ty.scalar.repr().filter(|_| found.field.ty.array.is_none());
    let Some(repr) = repr else {
        diagnostics.push(unsuitable(scope, name, found));
        return None;
    };
    let number = number_of(scope, value, found, repr, diagnostics)?;
    Some(ir::Condition { field: found.index, value: number, enum_: scope.enum_of(found.syntax) })
}

/// The value: a number, or an entry of the enum that the field carries.
fn number_of(
    scope: &MessageScope<'_, '_>,
    text: &Text,
    found: Found<'_>,
    repr: Repr,
    diagnostics: &mut Diagnostics,
) -> Option<u64> {
    let enum_ = scope.enum_of(found.syntax);
    let number = number::unsigned(&text.value).ok();
    let number = number.or_else(|| enum_.and_then(|enum_| scope.entry(enum_, &text.value)));
    match number {
        Some(number) if number <= repr.highest() => return number.into(),
        Some(number) => diagnostics.push(too_large(scope, text, number, found)),
        None if !scope.entries.complete => {}
        None => {
            let problem = not_a_value(scope, text, found);
            let problem = suggest(problem, &text.value, scope.entry_names(enum_), diagnostics);
            diagnostics.push(problem);
        }
    }
    None
}

fn unsuitable(scope: &MessageScope<'_, '_>, name: &Text, found: Found<'_>) -> Diagnostic {
    let (ty, message) = (&found.syntax.ty, scope.name());
    let text = format!("`{message}.{}` is `{}`, which no condition can ask", name.value, ty.value);
    let problem = Diagnostic::new(Code::Condition, name.span, text).related(ty.span, "the field");
    problem.help("a condition asks a scalar integer")
}

fn too_large(scope: &MessageScope<'_, '_>, text: &Text, number: u64, found: Found<'_>) -> Diagnostic {
    let (ty, name) = (&found.syntax.ty, &found.syntax.name.value);
    let message = format!("`{}.{name}` is never {number}: it is `{}`", scope.name(), ty.value);
    let problem = Diagnostic::new(Code::Condition, text.span, message).related(ty.span, "the field");
    problem.help("the condition would never hold")
}

fn not_a_value(scope: &MessageScope<'_, '_>, text: &Text, found: Found<'_>) -> Diagnostic {
    let name = &found.syntax.name.value;
    let (message, place, label) = match &found.syntax.enum_ {
        Some(values) => {
            let message = format!("`{}` is neither a number nor an entry of `{}`", text.value, values.value);
            (message, values.span, "the enum of the field".to_owned())
        }
        None => {
            let message = format!("`{}` is not a number from 0", text.value);
            (message, found.syntax.name.span, format!("`{}.{name}` carries no enum", scope.name()))
        }
    };
    let problem = Diagnostic::new(Code::Condition, text.span, message).related(place, label);
    problem.help("write a number, or an entry of the enum that the field carries")
}
