//! `exact`: an integer getter in a smaller unit.

use super::scaling::{Fraction, Line, stays_small};
use crate::diag::{Code, Diagnostic};
use crate::ir::{Exact, unit_words};
use crate::resolve::message_scope::MessageScope;
use crate::syntax::Text;
use crate::syntax::overlay::Bits;

/// Resolves `exact`; an error unless the value is whole for every raw number.
pub(super) fn resolve(
    scope: &mut MessageScope<'_, '_>,
    bits: &Bits,
    text: &Text,
    line: Line,
    raw: (u8, bool),
) -> Option<Exact> {
    let Some(units) = &bits.units else {
        let message = format!("`{}` has an exact getter in `{}` and no `units`", bits.name.value, text.value);
        let problem = Diagnostic::new(Code::ExactUnits, text.span, message);
        return scope.refuse(problem.help("`units` is the unit of the value, like `V`"));
    };
    let power = power_between(&units.value, &text.value).and_then(Fraction::power_of_ten);
    let Some(power) = power.filter(|_| !unit_words(&text.value).is_empty()) else {
        let message = format!("`{}` is no decimal fraction of `{}`", text.value, units.value);
        let problem =
            Diagnostic::new(Code::ExactUnits, text.span, message).related(units.span, "the unit of the value");
        return scope.refuse(problem.help("use the same unit with another prefix: `mV` for `V`"));
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
    scope.refuse(problem)
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

/// Powers of ten that SI has prefixes for.
#[rustfmt::skip]
const PREFIXES: [(&str, i32); 14] = [
    ("G", 9), ("M", 6), ("k", 3), ("h", 2), ("da", 1), ("d", -1), ("c", -2), ("m", -3), ("u", -6), ("µ", -6), ("n", -9), ("p", -12),
    ("", 0),
    // MAVLink's own: `degE7` is a ten-millionth of a degree.
    ("E", 0),
];

/// The power of ten by which `unit` is larger than `other`: 3 for `V` and `mV`, 7 for `deg` and `degE7`.
///
/// `None` if they do not measure the same, or it cannot be told: a prefix of a squared unit is squared as well.
fn power_between(unit: &str, other: &str) -> Option<i32> {
    let (unit, other) = (unit.trim(), other.trim());
    let (unit, own) = without_exponent(unit);
    let (other, theirs) = without_exponent(other);
    for (prefix, power) in PREFIXES {
        for (other_prefix, other_power) in PREFIXES {
            let bases = (unit.strip_prefix(prefix), other.strip_prefix(other_prefix));
            let (Some(base), Some(other_base)) = bases else { continue };
            if base == other_base && is_plain(base) {
                return Some((power + own) - (other_power + theirs));
            }
        }
    }
    None
}

/// Takes `E7` off `degE7`, and says that it is 10^-7 of it.
fn without_exponent(unit: &str) -> (&str, i32) {
    let split = unit.rsplit_once('E').and_then(|(base, digits)| Some((base, digits.parse::<u8>().ok()?)));
    split.map_or((unit, 0), |(base, digits)| (base, -i32::from(digits)))
}

/// Whether a prefix before this unit is a plain factor.
fn is_plain(base: &str) -> bool {
    let first = base.split(['/', '*']).next().unwrap_or_default();
    !first.is_empty() && !first.contains('^')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers() {
        for (unit, other, power) in [
            ("V", "mV", Some(3)),
            ("A", "mA", Some(3)),
            ("degC", "cdegC", Some(2)),
            ("m", "mm", Some(3)),
            ("mm", "m", Some(-3)),
            ("m/s", "cm/s", Some(2)),
            ("km/h", "m/h", Some(3)),
            ("m/s^2", "mm/s^2", Some(3)),
            ("%", "d%", Some(1)),
            ("%", "c%", Some(2)),
            ("deg", "degE7", Some(7)),
            ("degE5", "degE7", Some(2)),
            ("s", "us", Some(6)),
            ("ms", "us", Some(3)),
            ("hPa", "Pa", Some(2)),
            ("rpm", "rpm", Some(0)),
            ("V", "mA", None),
            ("m^2", "mm^2", None),
            ("m/s", "mm", None),
            ("V", "", None),
            ("", "mV", None),
        ] {
            assert_eq!(power_between(unit, other), power, "{unit} {other}");
        }
    }
}
