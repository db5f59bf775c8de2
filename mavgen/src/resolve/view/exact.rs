//! `exact`: an integer getter in a smaller unit.

use super::scaling::{Fraction, Line, stays_small};
use super::units::power_between;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Exact, unit_words};
use crate::syntax::Text;
use crate::syntax::overlay::Bits;

/// Resolves `exact`; an error unless the value is whole for every raw number.
pub(super) fn resolve(
    bits: &Bits,
    text: &Text,
    line: Line,
    raw: (u8, bool),
    diagnostics: &mut Diagnostics,
) -> Option<Exact> {
    let Some(units) = &bits.units else {
        let message = format!("`{}` has an exact getter in `{}` and no `units`", bits.name.value, text.value);
        let problem = Diagnostic::new(Code::ExactUnits, text.span, message);
        diagnostics.push(problem.help("`units` is the unit of the value, like `V`"));
        return None;
    };
    let power = power_between(&units.value, &text.value).and_then(Fraction::power_of_ten);
    let Some(power) = power.filter(|_| !unit_words(&text.value).is_empty()) else {
        let message = format!("`{}` is no decimal fraction of `{}`", text.value, units.value);
        let problem =
            Diagnostic::new(Code::ExactUnits, text.span, message).related(units.span, "the unit of the value");
        diagnostics.push(problem.help("use the same unit with another prefix: `mV` for `V`"));
        return None;
    };
    let problem = match line.whole(power) {
        Some((factor, bias)) if stays_small((factor, bias), raw) => {
            return Some(Exact { units: text.value.clone(), factor, bias });
        }
        Some(_) => {
            let message = format!("`{}` in {} is beyond 64 bits for some raw values", bits.name.value, text.value);
            let problem = Diagnostic::new(Code::Scale, text.span, message).related(bits.width.span, "the width");
            problem.help("take a larger unit, or leave `exact` out")
        }
        None => not_whole(bits, text, line, power),
    };
    diagnostics.push(problem);
    None
}

fn not_whole(bits: &Bits, text: &Text, line: Line, power: Fraction) -> Diagnostic {
    let Line { factor, bias, divisor } = line;
    let name = &bits.name.value;
    let bias = match bias {
        0 => String::new(),
        bias if bias < 0 => format!(" - {}", bias.unsigned_abs()),
        bias => format!(" + {bias}"),
    };
    let message = format!("`{name}` in {} is not whole for every raw value", text.value);
    let problem = Diagnostic::new(Code::NotExact, text.span, message);
    let label = format!("(raw · {factor}{bias}) / {divisor} · {power} {}", text.value);
    let place = bits.scale.as_ref().or(bits.bias.as_ref()).map_or(bits.name.span, |text| text.span);
    problem.label(label).related(place, "the scale").help("take a smaller unit, or leave `exact` out")
}
