//! Small tokens: identifiers and literals, printed as a person would write them.

use std::fmt::Debug;

use crate::lower::spelling::{is_keyword, is_path_keyword};
use crate::tokens::{TokenStream, quote};

/// An identifier; a keyword becomes a raw one.
pub(crate) fn ident(name: &str) -> TokenStream {
    TokenStream::of(format_args!("{}{name}", if is_keyword(name) { "r#" } else { "" }))
}

/// Whether this is an identifier that needs no `r#`.
pub fn is_identifier(name: &str) -> bool {
    !is_keyword(name) && is_word(name)
}

/// Whether this is a path, like `::mavlink_wire`, `crate::wire` or `r#gen::wire`.
pub(crate) fn is_path(text: &str) -> bool {
    let is_segment = |name: &str| is_word(name) && (name != "_" && is_path_keyword(name) || !is_keyword(name));
    text.strip_prefix("::").unwrap_or(text).split("::").all(is_segment)
}

/// Whether this is one word for the compiler, be it a keyword or a raw identifier.
fn is_word(text: &str) -> bool {
    let plain = text.strip_prefix("r#").filter(|raw| !is_path_keyword(raw)).unwrap_or(text);
    let is_letter = |letter: char| letter == '_' || letter.is_alphabetic();
    plain.starts_with(is_letter) && plain.chars().all(|letter| is_letter(letter) || letter.is_numeric())
}

/// A number of which the bits matter: `1 << 31`, `0x8001`, `0`.
pub(crate) fn bits(value: u64) -> TokenStream {
    if value.is_power_of_two() { quote!(1 << #{value.trailing_zeros()}) } else { mask(value.into()) }
}

/// A number as a hexadecimal mask: `0x8000_0000`.
pub(crate) fn mask(value: u128) -> TokenStream {
    if value < 10 {
        return quote!(#value);
    }
    let digits = format!("{value:x}");
    let mut grouped = String::from("0x");
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at) % 4 == 0 {
            grouped.push('_');
        }
        grouped.push(digit);
    }
    TokenStream::of(grouped)
}

/// An integer that may be negative.
pub(crate) fn integer(value: i128) -> TokenStream {
    quote!(#(if value < 0 => -) #{value.unsigned_abs()})
}

/// A `f32`, or a `f64` that is a number; without a type suffix.
pub(crate) fn float(value: f64) -> TokenStream {
    if value.is_nan() { quote!(f32::NAN) } else { finite(value, &value.abs()) }
}

/// A `f64` without a type suffix.
pub(crate) fn double(value: f64) -> TokenStream {
    if value.is_nan() { quote!(f64::NAN) } else { finite(value, &value.abs()) }
}

/// A `f32` without a type suffix, and no more digits than it has.
pub(crate) fn single(value: f32) -> TokenStream {
    if value.is_nan() { quote!(f32::NAN) } else { finite(value.into(), &value.abs()) }
}

/// A number by its magnitude, in debug formatting: that writes `1e30` and keeps the point of `2.0`.
fn finite(value: f64, magnitude: &dyn Debug) -> TokenStream {
    let magnitude = TokenStream::of(format_args!("{magnitude:?}"));
    quote!(#(if value.is_sign_negative() => -) #magnitude)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers() {
        assert_eq!(mask(8).to_string(), "8");
        assert_eq!(mask(0x8000_0000).to_string(), "0x8000_0000");
        assert_eq!(mask(0x10000).to_string(), "0x1_0000");
        assert_eq!(bits(0).to_string(), "0");
        assert_eq!(bits(1).to_string(), "1 << 0");
        assert_eq!(bits(1 << 63).to_string(), "1 << 63");
        assert_eq!(bits(0x18001).to_string(), "0x1_8001");
        assert_eq!(integer(-32768).to_string(), "- 32768");
        assert_eq!(float(-1.5).to_string(), "- 1.5");
        assert_eq!(float(-0.0).to_string(), "- 0.0");
        assert_eq!(float(1e300).to_string(), "1e300");
        assert_eq!(ident("type").to_string(), "r#type");
    }

    #[test]
    fn paths() {
        for path in [
            "wire",
            "::mavlink_wire",
            "crate::wire",
            "super::super::wire",
            "self::wire",
            "r#gen::wire",
            "_wire",
            "Ünter",
        ] {
            assert!(is_path(path), "{path}");
        }
        for other in [
            "", "::", "a::", "a:b", "a b", "a b::c", "1a", "type", "a::type", "_", "a<b>", "r#self", "a-b", "// a",
            "\"a\"",
        ] {
            assert!(!is_path(other), "{other}");
        }
        assert!(is_identifier("dialects") && is_identifier("r#type"));
        assert!(!["", "self", "_", "type", "a::b", "9", "a b"].into_iter().any(is_identifier));
    }
}
