//! Documented ranges and steps of fields and params.

use super::number;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::Limits;
use crate::syntax::Text;

/// Reads `minValue`, `maxValue` and `increment`, in this order: numbers of which `fits` is true.
pub(super) fn resolve(attributes: [&Option<Text>; 3], fits: fn(f64) -> bool, diagnostics: &mut Diagnostics) -> Limits {
    let [min, max, increment] = attributes.map(|text| text.as_ref().and_then(|text| finite(text, fits, diagnostics)));
    if let ([Some(min_text), Some(max_text), _], Some(low), Some(high)) = (attributes, min, max)
        && low > high
    {
        let message = format!("the range is empty: its minimum {low} is above its maximum {high}");
        let problem = Diagnostic::new(Code::Range, min_text.span, message);
        diagnostics.push(problem.related(max_text.span, "the maximum"));
    }
    Limits { min, max, increment }
}

/// A number that is one: a range has no use for NaN, nor for an infinity, which Rust has no literal for.
fn finite(text: &Text, fits: fn(f64) -> bool, diagnostics: &mut Diagnostics) -> Option<f64> {
    let value = number::float(&text.value).filter(|value| fits(*value));
    if value.is_none() {
        let message = format!("`{}` {}", text.value, why_not(text, "is not a finite number"));
        diagnostics.push(Diagnostic::new(Code::DocumentedNumber, text.span, message).label("left out"));
    }
    value
}

/// What keeps a text from being a number that fits: it is more than what a param is sent as, or `otherwise`.
pub(super) fn why_not<'w>(text: &Text, otherwise: &'w str) -> &'w str {
    match number::float(&text.value) {
        Some(value) if value.is_finite() => "is more than a `float` holds",
        Some(_) | None => otherwise,
    }
}
