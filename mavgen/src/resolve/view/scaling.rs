//! Scale and bias in exact arithmetic: value = raw · scale + bias, and nothing is rounded before the last division.

use std::fmt;

use crate::decimal::is_digits;
use crate::diag::{Code, Diagnostic};
use crate::resolve::message_scope::MessageScope;
use crate::syntax::Text;
use crate::syntax::overlay::Bits;

/// More decimal places, or a larger exponent, than any number of 64 bits has.
const MOST_PLACES: u32 = 18;

/// A fraction in lowest terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Fraction {
    numerator: i128,
    /// At least 1.
    denominator: i128,
}

impl Fraction {
    pub(super) const ONE: Self = Self { numerator: 1, denominator: 1 };
    const ZERO: Self = Self { numerator: 0, denominator: 1 };

    fn new(numerator: i128, denominator: i128) -> Option<Self> {
        let divisor = i128::try_from(gcd(numerator.unsigned_abs(), denominator.unsigned_abs())).ok()?;
        let sign = denominator.signum();
        Some(Self {
            numerator: numerator.checked_div(divisor)?.checked_mul(sign)?,
            denominator: denominator.checked_div(divisor)?.checked_mul(sign)?,
        })
        .filter(|fraction| fraction.denominator > 0)
    }

    /// 10 to that power.
    pub(super) fn power_of_ten(exponent: i32) -> Option<Self> {
        let power = power_of_ten(exponent.unsigned_abs())?;
        if exponent < 0 { Self::new(1, power) } else { Self::new(power, 1) }
    }

    fn divided_by(self, other: Self) -> Option<Self> {
        let numerator = self.numerator.checked_mul(other.denominator)?;
        Self::new(numerator, self.denominator.checked_mul(other.numerator)?)
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.denominator {
            1 => self.numerator.fmt(f),
            denominator => write!(f, "{}/{denominator}", self.numerator),
        }
    }
}

/// value = (raw · `factor` + `bias`) / `divisor`, in lowest terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Line {
    pub(super) factor: i64,
    pub(super) bias: i64,
    /// At least 1.
    pub(super) divisor: i64,
}

impl Line {
    /// `None` if a number does not fit 64 bits.
    fn new(scale: Fraction, bias: Fraction) -> Option<Self> {
        let common = i128::try_from(gcd(scale.denominator.unsigned_abs(), bias.denominator.unsigned_abs())).ok()?;
        let divisor = scale.denominator.checked_div(common)?.checked_mul(bias.denominator)?;
        let factor = scale.numerator.checked_mul(divisor.checked_div(scale.denominator)?)?;
        let bias = bias.numerator.checked_mul(divisor.checked_div(bias.denominator)?)?;
        Some(Self { factor: factor.try_into().ok()?, bias: bias.try_into().ok()?, divisor: divisor.try_into().ok()? })
    }

    /// The values times `unit`, if all of them are whole: factor and bias of raw · factor + bias.
    pub(super) fn whole(self, unit: Fraction) -> Option<(i64, i64)> {
        let divisor = i128::from(self.divisor).checked_mul(unit.denominator)?;
        let whole = |term: i64| {
            let term = i128::from(term).checked_mul(unit.numerator)?;
            if term.checked_rem(divisor)? == 0 { i64::try_from(term.checked_div(divisor)?).ok() } else { None }
        };
        Some((whole(self.factor)?, whole(self.bias)?))
    }
}

/// Whether raw · `factor` + `bias` fits 64 bits for every raw number of `width` bits, 1 to 64.
pub(super) fn stays_small((factor, bias): (i64, i64), (width, signed): (u8, bool)) -> bool {
    let bits = u32::from(width);
    let (least, most) =
        if signed { (-(1_i128 << (bits - 1)), (1_i128 << (bits - 1)) - 1) } else { (0, (1_i128 << bits) - 1) };
    // At most 2^64 times 2^63, plus 2^63.
    let value = |raw: i128| raw * i128::from(factor) + i128::from(bias);
    [least, most].into_iter().all(|raw| i64::try_from(value(raw)).is_ok())
}

/// Reads `scale` and `bias` of bits of a width and sign.
pub(super) fn line(scope: &mut MessageScope<'_, '_>, bits: &Bits, raw: (u8, bool)) -> Option<Line> {
    let scale = attribute(scope, &bits.scale, Fraction::ONE);
    let bias = attribute(scope, &bits.bias, Fraction::ZERO);
    let (scale, bias) = (scale?, bias?);
    let place = bits.scale.as_ref().or(bits.bias.as_ref()).map_or(bits.span, |text| text.span);
    if scale.numerator == 0 {
        let message = format!("the scale of `{}` is zero: every value would be the same", bits.name.value);
        return scope.refuse(Diagnostic::new(Code::Scale, place, message).help("leave `scale` out for 1"));
    }
    let line = Line::new(scale, bias).filter(|line| stays_small((line.factor, line.bias), raw));
    if line.is_none() {
        let (name, width) = (&bits.name.value, &bits.width);
        let bias = if bias == Fraction::ZERO { String::new() } else { format!(" + {bias}") };
        let message = format!("`{name}` = raw · {scale}{bias} is beyond 64 bits for some raw values");
        let problem = Diagnostic::new(Code::Scale, place, message);
        let problem = problem.related(width.span, format!("{} bits", width.value));
        scope.report(problem.help("everything is computed in 64 bits: make the bits fewer, or the numbers smaller"));
    }
    line
}

fn attribute(scope: &mut MessageScope<'_, '_>, text: &Option<Text>, default: Fraction) -> Option<Fraction> {
    let Some(text) = text else { return Some(default) };
    match fraction(&text.value) {
        Ok(fraction) => Some(fraction),
        Err(why) => {
            let message = format!("`{}` is not a fraction", text.value);
            let problem = Diagnostic::new(Code::Scale, text.span, message).label(why);
            scope.report(problem.help("write it like `1/100`, `0.25` or `-32`"));
            None
        }
    }
}

/// `1/100`, `0.25`, `-32`, `1E-7`.
fn fraction(text: &str) -> Result<Fraction, &'static str> {
    let Some((numerator, denominator)) = text.trim().split_once('/') else { return decimal(text.trim()) };
    let (numerator, denominator) = (decimal(numerator.trim())?, decimal(denominator.trim())?);
    if denominator.numerator == 0 {
        return Err("divided by zero");
    }
    numerator.divided_by(denominator).ok_or(TOO_LARGE)
}

const NOT_A_NUMBER: &str = "not a number";
const TOO_LARGE: &str = "too many digits";

fn decimal(text: &str) -> Result<Fraction, &'static str> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().map_err(|_| NOT_A_NUMBER)?),
        None => (text, 0),
    };
    let (negative, magnitude) = mantissa.strip_prefix('-').map_or((false, mantissa), |magnitude| (true, magnitude));
    let (whole, places) = magnitude.split_once('.').unwrap_or((magnitude, ""));
    let is_whole = magnitude.len() == whole.len();
    if !is_digits(whole) || !is_whole && !is_digits(places) {
        return Err(NOT_A_NUMBER);
    }
    let digits: i128 = [whole, places].concat().parse::<i64>().map_err(|_| TOO_LARGE)?.into();
    let scale = u32::try_from(places.len()).ok().and_then(power_of_ten).ok_or(TOO_LARGE)?;
    let mantissa = Fraction::new(if negative { -digits } else { digits }, scale).ok_or(TOO_LARGE)?;
    let inverse = exponent.checked_neg().and_then(Fraction::power_of_ten).ok_or(TOO_LARGE)?;
    mantissa.divided_by(inverse).ok_or(TOO_LARGE)
}

fn power_of_ten(exponent: u32) -> Option<i128> {
    if exponent > MOST_PLACES { None } else { 10_i128.checked_pow(exponent) }
}

/// The greatest common divisor; of two zeros, one.
fn gcd(a: u128, b: u128) -> u128 {
    let (mut a, mut b) = (a, b);
    while b != 0 {
        (a, b) = (b, a.checked_rem(b).unwrap_or_default());
    }
    a.max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions() {
        for (text, expected) in [
            ("1/100", "1/100"),
            ("100/255", "20/51"),
            ("0.25", "1/4"),
            ("-32", "-32"),
            ("1E-7", "1/10000000"),
            ("2.5e3", "2500"),
            (" 3 / -6 ", "-1/2"),
            ("0.5/0.25", "2"),
            ("007", "7"),
            ("0", "0"),
            ("9223372036854775807", "9223372036854775807"),
        ] {
            assert_eq!(fraction(text).unwrap().to_string(), expected, "{text}");
        }
        for (text, why) in [
            ("1/0", "divided by zero"),
            ("1/0.0", "divided by zero"),
            ("", NOT_A_NUMBER),
            ("-", NOT_A_NUMBER),
            (".5", NOT_A_NUMBER),
            ("1.", NOT_A_NUMBER),
            ("+1", NOT_A_NUMBER),
            ("--1", NOT_A_NUMBER),
            ("1/2/3", NOT_A_NUMBER),
            ("0x10", NOT_A_NUMBER),
            ("1e", NOT_A_NUMBER),
            ("9223372036854775808", TOO_LARGE),
            ("0.0000000000000000001", TOO_LARGE),
            ("1e19", TOO_LARGE),
            ("1e-2147483648", TOO_LARGE),
        ] {
            assert_eq!(fraction(text), Err(why), "{text}");
        }
    }

    #[test]
    fn lines_are_in_lowest_terms() {
        let line = |scale: &str, bias: &str| Line::new(fraction(scale).unwrap(), fraction(bias).unwrap());
        let of = |factor, bias, divisor| Some(Line { factor, bias, divisor });
        assert_eq!(line("1/4", "-32"), of(1, -128, 4));
        assert_eq!(line("1/6", "1/4"), of(2, 3, 12));
        assert_eq!(line("100/255", "0"), of(20, 0, 51));
        assert_eq!(line("9223372036854775807", "1/2"), None);
        let temperature = line("0.25", "-32").unwrap();
        assert_eq!(temperature.whole(Fraction::power_of_ten(2).unwrap()), Some((25, -3200)));
        assert_eq!(temperature.whole(Fraction::ONE), None);
        assert_eq!(line("100", "0").unwrap().whole(Fraction::power_of_ten(-2).unwrap()), Some((1, 0)));
    }

    #[test]
    fn overflow_is_foreseen() {
        assert!(stays_small((1, 0), (63, false)));
        assert!(!stays_small((1, 0), (64, false)));
        assert!(!stays_small((1, 1), (63, false)));
        assert!(stays_small((1, 0), (64, true)));
        assert!(!stays_small((-1, 0), (64, true)));
        assert!(stays_small((i64::MAX, 0), (1, false)));
        assert!(!stays_small((i64::MAX, i64::MAX), (64, false)));
    }
}
