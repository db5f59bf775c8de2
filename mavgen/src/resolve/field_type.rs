//! Field types: from `uint16_t[4]` to what stands on the wire.

use std::num::NonZeroU8;

use super::{number, suggest};
use crate::decimal::is_digits;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{FieldType, Scalar};
use crate::syntax::Text;

/// The type whose value is the version of the file that holds the message.
pub(super) const VERSION: &str = "uint8_t_mavlink_version";

/// Types of other languages beside the integers of Rust, and what they are on the wire.
const FOREIGN: [(&str, Scalar); 6] = [
    ("bool", Scalar::U8),
    ("byte", Scalar::U8),
    ("int", Scalar::I32),
    ("string", Scalar::Char),
    ("f32", Scalar::F32),
    ("f64", Scalar::F64),
];

/// Reads a `type` attribute; `version` is that of the file, as known at this place.
pub(super) fn resolve(text: &Text, version: u8, diagnostics: &mut Diagnostics) -> Option<FieldType> {
    let (element, brackets) = match text.value.split_once('[') {
        Some((element, rest)) => (element, Some(rest)),
        None => (&*text.value, None),
    };
    // pymavlink knows `array[N]` from the days of MAVLink 0.9.
    let plain = if element == "array" && brackets.is_some() { "int8_t" } else { element };
    let Some(scalar) = scalar(plain, version) else {
        unknown(text, element, diagnostics);
        return None;
    };
    if scalar.wire_name() != element && element != VERSION {
        let message = format!("type `{element}` is an old spelling of `{}`", scalar.wire_name());
        let problem = Diagnostic::new(Code::TypeSpelling, text.span, message);
        diagnostics.push(problem.label("pymavlink's schema refuses it"));
    }
    let array = brackets.map(|rest| length(text, scalar, rest, diagnostics).ok_or(())).transpose().ok()?;
    Some(FieldType { scalar, array })
}

/// The length of an array of `scalar`; `rest` is what follows the bracket.
fn length(text: &Text, scalar: Scalar, rest: &str, diagnostics: &mut Diagnostics) -> Option<NonZeroU8> {
    let number = rest.strip_suffix(']').and_then(number::count);
    let problem = if matches!(scalar, Scalar::Version(_)) {
        Diagnostic::new(Code::VersionField, text.span, "`uint8_t_mavlink_version` cannot be an array")
    } else {
        let message = format!("the length in `{}` is not a number from 1 to 255", text.value);
        let problem = Diagnostic::new(Code::ArrayLength, text.span, message);
        match number.map(|number| u8::try_from(number).map(NonZeroU8::new)) {
            Some(Ok(Some(length))) => return Some(length),
            Some(Ok(None)) => problem.label("an array of nothing").help("leave the brackets out for a scalar"),
            Some(Err(_)) => problem.label("more than 255"),
            None => problem.label("not a length"),
        }
    };
    diagnostics.refuse(problem)
}

/// The element type of that name; pymavlink takes the names without `_t` as well.
fn scalar(name: &str, version: u8) -> Option<Scalar> {
    let is_named = |scalar: &Scalar| name == scalar.wire_name() || short_name(*scalar) == Some(name);
    if name == VERSION { Some(Scalar::Version(version)) } else { Scalar::ALL.into_iter().find(is_named) }
}

/// The name of an integer without `_t`.
pub(super) fn short_name(scalar: Scalar) -> Option<&'static str> {
    scalar.wire_name().strip_suffix("_t")
}

fn unknown(text: &Text, element: &str, diagnostics: &mut Diagnostics) {
    let message = format!("type `{element}` does not exist");
    let problem = Diagnostic::new(Code::UnknownType, text.span, message).label("no such type");
    if let Some(meant) = meant(&text.value) {
        diagnostics.push(problem.help(format!("did you mean `{meant}`?")));
        return;
    }
    let help = "types are char, int8_t to int64_t, uint8_t to uint64_t, float and double; \
                an enum is named by `enum`, beside an integer type";
    let mut names = Scalar::ALL.iter().map(|scalar| scalar.wire_name()).chain([VERSION]);
    suggest::report(problem.help(help), element, &mut names, diagnostics);
}

/// What a type of another language is here, and an array whose brackets are not `[N]`.
fn meant(text: &str) -> Option<String> {
    let name_end = text.find(|c: char| c != '_' && !c.is_ascii_alphanumeric()).unwrap_or(text.len());
    let (name, length) = text.split_at_checked(name_end)?;
    let length = length.trim_matches(|c: char| " \t()<>{}[]".contains(c));
    let is_named =
        |scalar: &Scalar| scalar.wire_name() == name || scalar.repr().is_some_and(|repr| repr.name() == name);
    let foreign = || FOREIGN.iter().find(|(foreign, _)| *foreign == name).map(|&(_, scalar)| scalar);
    let meant = Scalar::ALL.into_iter().find(is_named).or_else(foreign)?.wire_name();
    match (meant, length) {
        ("char", "") => Some("char[N]".to_owned()),
        (meant, "") => Some(meant.to_owned()),
        (meant, digits) if is_digits(digits) => Some(format!("{meant}[{digits}]")),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::{Sources, Span, Spanned};

    fn read(text: &str) -> Result<FieldType, Diagnostic> {
        let span = Span::new(Sources::default().add("a.xml", ""), 0..0);
        let mut diagnostics = Diagnostics::default();
        let resolved = resolve(&Spanned::new(text.to_owned(), span), 3, &mut diagnostics);
        resolved.ok_or_else(|| diagnostics.iter().next().unwrap().clone())
    }

    #[test]
    fn spellings() {
        for (text, scalar, array) in [
            ("char", Scalar::Char, None),
            ("uint8_t", Scalar::U8, None),
            ("uint8", Scalar::U8, None),
            ("int64", Scalar::I64, None),
            ("float", Scalar::F32, None),
            ("double[16]", Scalar::F64, Some(16)),
            ("uint8_t[1]", Scalar::U8, Some(1)),
            ("uint16[0004]", Scalar::U16, Some(4)),
            ("char[255]", Scalar::Char, Some(255)),
            ("array[7]", Scalar::I8, Some(7)),
            ("uint8_t_mavlink_version", Scalar::Version(3), None),
        ] {
            let expected = FieldType { scalar, array: array.and_then(NonZeroU8::new) };
            assert_eq!(read(text).unwrap(), expected, "{text}");
        }
    }

    #[test]
    fn refused() {
        for (text, code, help) in [
            ("uint9_t", Code::UnknownType, Some("did you mean `uint8_t`?")),
            ("Float", Code::UnknownType, Some("did you mean `float`?")),
            ("flaot[3]", Code::UnknownType, Some("did you mean `float`?")),
            ("array", Code::UnknownType, None),
            ("uint8_t [4]", Code::UnknownType, Some("did you mean `uint8_t[4]`?")),
            ("uint32_t(8)", Code::UnknownType, Some("did you mean `uint32_t[8]`?")),
            ("uint32_t(eight)", Code::UnknownType, None),
            ("u16[3]", Code::UnknownType, Some("did you mean `uint16_t[3]`?")),
            ("bool", Code::UnknownType, Some("did you mean `uint8_t`?")),
            ("string", Code::UnknownType, Some("did you mean `char[N]`?")),
            ("", Code::UnknownType, None),
            ("uint8_t[0]", Code::ArrayLength, Some("leave the brackets out for a scalar")),
            ("uint8_t[256]", Code::ArrayLength, None),
            ("uint8_t[]", Code::ArrayLength, None),
            ("uint8_t[4", Code::ArrayLength, None),
            ("uint8_t[4]x", Code::ArrayLength, None),
            ("uint8_t[-4]", Code::ArrayLength, None),
            ("uint8_t[2][2]", Code::ArrayLength, None),
            ("uint8_t_mavlink_version[4]", Code::VersionField, None),
        ] {
            let problem = read(text).unwrap_err();
            assert_eq!(problem.code, code, "{text}");
            if let Some(help) = help {
                assert_eq!(problem.help.as_deref(), Some(help), "{text}");
            }
        }
    }
}
