//! The types of pymavlink's schema, `mavschema.xsd`, and what is said where it refuses a text or an order that we take.

use crate::decimal::{is_digits, is_year_and_month};
use crate::diag::{Code, Diagnostic};
use crate::source::Span;
use crate::syntax::Type;

impl Type {
    /// Whether pymavlink takes this text.
    fn allows(self, text: &str) -> bool {
        let collapsed = text.trim();
        match self {
            Self::Text => true,
            Self::Boolean => matches!(collapsed, "true" | "false" | "1" | "0"),
            Self::Byte => collapsed.parse::<u8>().is_ok(),
            Self::Float => is_float(collapsed),
            Self::Number => is_number(text),
            Self::Default => text == "NaN" || is_number(text),
            Self::Multiplier => matches!(text, "1E-2" | "2E-3" | "360/255"),
            Self::Date => text.starts_with("20") && is_year_and_month(text),
            Self::OfField => text.split_once('[').is_none_or(|(_, rest)| rest.strip_suffix(']').is_some_and(is_digits)),
            Self::Path => text == collapsed,
        }
    }

    /// What it takes instead.
    fn wanted(self) -> &'static str {
        match self {
            Self::Text => "any text",
            Self::Boolean => "`true` or `false`",
            Self::Byte => "a number from 0 to 255",
            Self::Float => "a decimal number, as `-1.5` or `1e3`",
            Self::Number => "digits, `0x…`, `0b…` or `2**…`, without blanks",
            Self::Default => "digits, `0x…`, `0b…`, `2**…` or `NaN`: no sign and no fraction",
            Self::Multiplier => "`1E-2`, `2E-3` or `360/255`",
            Self::Date => "year and month of this century, as `2018-04`",
            Self::OfField => "digits alone between the brackets, as in `uint8_t[4]`",
            Self::Path => "the path alone, without blanks or line ends around it",
        }
    }
}

/// The four spellings of the schema, each with its most digits.
fn is_number(text: &str) -> bool {
    let of = |rest: &str, most: usize, is_digit: fn(&u8) -> bool| {
        (1..=most).contains(&rest.len()) && rest.as_bytes().iter().all(is_digit)
    };
    if let Some(exponent) = text.strip_prefix("2**") {
        return of(exponent, 2, u8::is_ascii_digit);
    }
    match text.as_bytes() {
        [b'0', b'x' | b'X', ..] => of(text.get(2..).unwrap_or_default(), 16, u8::is_ascii_hexdigit),
        [b'0', b'b' | b'B', ..] => of(text.get(2..).unwrap_or_default(), 64, |digit| matches!(digit, b'0' | b'1')),
        _ => of(text, 20, u8::is_ascii_digit),
    }
}

/// `xs:float`, which spells infinities otherwise than Rust.
fn is_float(text: &str) -> bool {
    let words = text
        .trim_start_matches(['+', '-'])
        .chars()
        .any(|letter| letter.is_alphabetic() && letter != 'e' && letter != 'E');
    if words { matches!(text, "INF" | "-INF" | "NaN") } else { text.parse::<f64>().is_ok() }
}

/// Says that pymavlink's schema refuses a text, if it does.
pub(super) fn refused(what: &str, ty: Type, text: &str, span: Span) -> Option<Diagnostic> {
    if ty.allows(text) {
        return None;
    }
    let shown = if text.len() > 40 { "…" } else { text };
    let message = format!("pymavlink refuses this: {what} `{}`", shown.escape_debug());
    Some(Diagnostic::new(Code::PymavlinkRefuses, span, message).help(format!("it takes {}", ty.wanted())))
}

/// Says that pymavlink's schema refuses an order, or that something is missing or stands twice.
pub(super) fn misplaced(message: &str, span: Span, help: String) -> Diagnostic {
    Diagnostic::new(Code::PymavlinkRefuses, span, format!("pymavlink refuses this: {message}")).help(help)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As `lxml` judges with the schema of pymavlink 2.4.50.
    #[test]
    fn types() {
        for (ty, taken, refused) in [
            (Type::Boolean, &["true", " 1 "][..], &["True", "yes", ""][..]),
            (Type::Byte, &["0", " 255", "+7", "007"], &["256", "-1", "x", "", "1.0"]),
            (Type::Float, &["-1.5", "1e3", " 7", "INF", "NaN", "+.5"], &["inf", "nan", "0x10", "2**3", "", "infinity"]),
            (
                Type::Number,
                &["7", "0x1F", "0b101", "2**7"],
                &["-1", " 7", "1<<7", "2**007", "", "0x", "000000000000000000001"],
            ),
            (Type::Default, &["7", "NaN", "2**31"], &["-1", "0.5", "nan", ""]),
            (Type::Multiplier, &["1E-2"], &["1e-2", "0.01", ""]),
            (Type::Date, &["2018-04"], &["1999-04", "2018-13", "2018-4", ""]),
            (Type::OfField, &["uint8_t", "uint8_t[4]"], &["uint8_t[ 4 ]", "uint8_t[]"]),
            (Type::Path, &["a b.xml"], &[" a.xml", "a.xml\n"]),
        ] {
            for text in taken {
                assert!(ty.allows(text), "{ty:?} {text}");
            }
            for text in refused {
                assert!(!ty.allows(text), "{ty:?} {text}");
            }
        }
    }
}
