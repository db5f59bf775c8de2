//! Conditions: `if="autopilot" is="MAV_AUTOPILOT_AUTOQUAD"`.

use super::super::number;
use super::{Found, MessageScope};
use crate::diag::{Code, Diagnostic};
use crate::ir;
use crate::syntax::Text;
use crate::syntax::overlay::Condition;

/// Resolves a condition: nothing if there is none. What is wrong with one is reported.
pub(in crate::resolve) fn resolve(scope: &mut MessageScope<'_, '_>, condition: &Condition) -> Option<ir::Condition> {
    let (name, text) = (condition.field.as_ref()?, condition.value.as_ref()?);
    let found = scope.field(name)?;
    let Some(repr) = found.scalar_repr() else {
        let why = ("no condition can ask", "a condition asks a scalar integer");
        scope.report_type(Code::Condition, name.span, found, why);
        return None;
    };
    let enum_ = scope.enum_of(found.syntax);
    let entry = || enum_.and_then(|enum_| scope.entry(enum_, &text.value));
    match number::unsigned(&text.value).ok().or_else(entry) {
        Some(value) if value <= repr.highest() => return Some(ir::Condition { field: found.index, value, enum_ }),
        Some(value) => {
            let (ty, field) = (&found.syntax.ty, &found.syntax.name.value);
            let message = format!("`{}.{field}` is never {value}: it is `{}`", scope.name(), ty.value);
            let problem = Diagnostic::new(Code::Condition, text.span, message).related(ty.span, "the field");
            scope.report(problem.help("the condition would never hold"));
        }
        None if !scope.entries.complete => {}
        None => scope.report_value(not_a_value(scope.name(), text, found), &text.value, enum_),
    }
    None
}

fn not_a_value(message: &str, text: &Text, found: Found<'_>) -> Diagnostic {
    let field = &found.syntax.name;
    let (problem, place, label) = match &found.syntax.enum_ {
        Some(enum_) => {
            let problem = format!("`{}` is neither a number nor an entry of `{}`", text.value, enum_.value);
            (problem, enum_.span, "the enum of the field".to_owned())
        }
        None => {
            let label = format!("`{message}.{}` carries no enum", field.value);
            (format!("`{}` is not a number from 0", text.value), field.span, label)
        }
    };
    let problem = Diagnostic::new(Code::Condition, text.span, problem).related(place, label);
    problem.help("write a number, or an entry of the enum that the field carries")
}
