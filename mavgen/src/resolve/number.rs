//! Numbers and booleans, as attributes spell them, and documented ranges.

use crate::decimal::is_digits;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::Limits;
use crate::syntax::Text;

/// Why a text is no number, worded as the label under it.
type Refusal = &'static str;

const NOT_A_NUMBER: Refusal = "not a number";
const NEGATIVE: Refusal = "negative";
const TOO_LARGE: Refusal = "larger than 2^64 - 1";
const LEADING_ZERO: Refusal = "starts with a zero, which reads as octal elsewhere";

/// An unsigned number: decimal, `0x…`, `0b…` or `2**n`.
///
/// That is what both the schema and pymavlink's `eval` accept (a leading zero passes only the former), up to 64 bits.
pub(super) fn unsigned(text: &str) -> Result<u64, Refusal> {
    let text = text.trim();
    if text.starts_with('-') {
        return Err(NEGATIVE);
    }
    if let Some(hexadecimal) = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        return digits(hexadecimal, 16);
    }
    if let Some(binary) = text.strip_prefix("0b").or_else(|| text.strip_prefix("0B")) {
        return digits(binary, 2);
    }
    if let Some(exponent) = text.strip_prefix("2**") {
        let exponent = u32::try_from(decimal(exponent)?).map_err(|_| TOO_LARGE)?;
        return 1_u64.checked_shl(exponent).ok_or(TOO_LARGE);
    }
    decimal(text)
}

/// A number of plain decimal digits, where leading zeros are harmless: ids, lengths, versions, indices.
pub(super) fn count(text: &str) -> Option<u64> {
    Some(text.trim()).filter(|text| is_digits(text))?.parse().ok()
}

/// A decimal number. Zeros alone are zero, as in Python.
fn decimal(text: &str) -> Result<u64, Refusal> {
    let value = digits(text, 10)?;
    if text.starts_with('0') && value != 0 { Err(LEADING_ZERO) } else { Ok(value) }
}

/// Digits and nothing else: the standard parser would take a sign as well.
fn digits(text: &str, radix: u32) -> Result<u64, Refusal> {
    if text.is_empty() || !text.chars().all(|digit| digit.is_digit(radix)) {
        return Err(NOT_A_NUMBER);
    }
    u64::from_str_radix(text, radix).map_err(|_| TOO_LARGE)
}

/// An integer of any sign, in the spelling of [`unsigned`] after the sign.
pub(super) fn signed(text: &str) -> Option<i128> {
    match text.trim().strip_prefix('-') {
        Some(magnitude) => unsigned(magnitude).ok().map(|magnitude| -i128::from(magnitude)),
        None => unsigned(text).ok().map(i128::from),
    }
}

/// A floating-point number (`xs:float`), NaN included, or any spelling of [`unsigned`].
pub(super) fn float(text: &str) -> Option<f64> {
    let text = text.trim();
    // The largest integers round, as they do when a `float` carries them.
    text.parse().ok().or_else(|| unsigned(text).ok().map(|value| value as f64))
}

/// A truth value (`xs:boolean`).
pub(super) fn boolean(text: &str) -> Option<bool> {
    match text.trim() {
        "true" | "1" => Some(true),
        "false" | "0" => Some(false),
        _ => None,
    }
}

/// Reads `minValue`, `maxValue` and `increment`, in this order: numbers of which `fits` is true.
pub(super) fn limits(attributes: [&Option<Text>; 3], fits: fn(f64) -> bool, diagnostics: &mut Diagnostics) -> Limits {
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
    let value = float(&text.value).filter(|value| fits(*value));
    if value.is_none() {
        let message = format!("`{}` {}", text.value, why_not(text, "is not a finite number"));
        diagnostics.push(Diagnostic::new(Code::DocumentedNumber, text.span, message).label("left out"));
    }
    value
}

/// What keeps a text from being a number that fits: it is more than what a param is sent as, or `otherwise`.
pub(super) fn why_not<'w>(text: &Text, otherwise: &'w str) -> &'w str {
    match float(&text.value) {
        Some(value) if value.is_finite() => "is more than a `float` holds",
        Some(_) | None => otherwise,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unsigned_spellings() {
        for (text, value) in [
            ("5", 5),
            (" 7 ", 7),
            ("0", 0),
            ("00", 0),
            ("0x1F", 31),
            ("0X1f", 31),
            ("0b101", 5),
            ("0B1", 1),
            ("2**0", 1),
            ("2**31", 1 << 31),
            ("2**63", 1 << 63),
            ("18446744073709551615", u64::MAX),
            ("0xFFFFFFFFFFFFFFFF", u64::MAX),
        ] {
            assert_eq!(unsigned(text), Ok(value), "{text}");
        }
    }

    #[test]
    fn refused_spellings() {
        for (text, why) in [
            ("007", LEADING_ZERO),
            ("2**07", LEADING_ZERO),
            ("2**64", TOO_LARGE),
            ("2**99", TOO_LARGE),
            ("2**99999999999", TOO_LARGE),
            ("18446744073709551616", TOO_LARGE),
            ("0x10000000000000000", TOO_LARGE),
            ("", NOT_A_NUMBER),
            ("-1", NEGATIVE),
            ("+1", NOT_A_NUMBER),
            ("0x", NOT_A_NUMBER),
            ("0x+1", NOT_A_NUMBER),
            ("0b2", NOT_A_NUMBER),
            ("1|2", NOT_A_NUMBER),
            ("0o17", NOT_A_NUMBER),
            ("1_000", NOT_A_NUMBER),
            ("1.0", NOT_A_NUMBER),
            ("1e3", NOT_A_NUMBER),
            ("2 ** 3", NOT_A_NUMBER),
            ("3**2", NOT_A_NUMBER),
            ("True", NOT_A_NUMBER),
            ("٣", NOT_A_NUMBER),
        ] {
            assert_eq!(unsigned(text), Err(why), "{text}");
        }
    }

    #[test]
    fn counts_signs_and_floats() {
        assert_eq!(count("0004"), Some(4));
        assert_eq!(count("0x4"), None);
        assert_eq!(count("-4"), None);
        assert_eq!(signed("-1000"), Some(-1000));
        assert_eq!(signed("0xFFFF"), Some(65535));
        assert_eq!(signed("--1"), None);
        assert_eq!(float("-1.5e-2"), Some(-0.015));
        assert_eq!(float("0x10"), Some(16.0));
        assert_eq!(float("nan").map(f64::is_nan), Some(true));
        assert_eq!(float("one"), None);
    }
}
