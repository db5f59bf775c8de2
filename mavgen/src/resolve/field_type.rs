//! Field types: from `uint16_t[4]` to what stands on the wire.

use std::num::NonZeroU8;

use super::number;
use super::suggest::suggest;
use crate::decimal::is_digits;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{FieldType, Scalar};
use crate::syntax::Text;

/// The type whose value is the version of the file that holds the message.
pub(super) const VERSION: &str = "uint8_t_mavlink_version";

/// The types as the schema spells them.
const SPELLINGS: [(&str, Scalar); 11] = [
    ("char", Scalar::Char),
    ("uint8_t", Scalar::U8),
    ("int8_t", Scalar::I8),
    ("uint16_t", Scalar::U16),
    ("int16_t", Scalar::I16),
    ("uint32_t", Scalar::U32),
    ("int32_t", Scalar::I32),
    ("uint64_t", Scalar::U64),
    ("int64_t", Scalar::I64),
    ("float", Scalar::F32),
    ("double", Scalar::F64),
];

/// Types of other languages, and what they are on the wire.
const FOREIGN: [(&str, &str); 14] = [
    ("bool", "uint8_t"),
    ("byte", "uint8_t"),
    ("int", "int32_t"),
    ("string", "char"),
    ("u8", "uint8_t"),
    ("i8", "int8_t"),
    ("u16", "uint16_t"),
    ("i16", "int16_t"),
    ("u32", "uint32_t"),
    ("i32", "int32_t"),
    ("u64", "uint64_t"),
    ("i64", "int64_t"),
    ("f32", "float"),
    ("f64", "double"),
];

/// Reads a `type` attribute; `version` is that of the file, as known at this place.
pub(super) fn resolve(text: &Text, version: u8, diagnostics: &mut Diagnostics) -> Option<FieldType> {
    let (element, brackets, scalar) = parts(&text.value, version);
    let Some(scalar) = scalar else {
        let problem = unknown(text, element, diagnostics);
        diagnostics.push(problem);
        return None;
    };
    if !SPELLINGS.iter().any(|(spelling, _)| *spelling == element) && element != VERSION {
        let message = format!("type `{element}` is an old spelling of `{}`", scalar.wire_name());
        let problem = Diagnostic::new(Code::TypeSpelling, text.span, message);
        diagnostics.push(problem.label("pymavlink's schema refuses it"));
    }
    let array = brackets.map(|rest| length(text, scalar, rest)).transpose();
    array.map(|array| FieldType { scalar, array }).map_err(|problem| diagnostics.push(*problem)).ok()
}

/// The type that a `type` attribute names, if it names one; for what only looks at the type, and reports nothing of it.
pub(super) fn named(text: &Text) -> Option<FieldType> {
    let (_, brackets, scalar) = parts(&text.value, 0);
    let scalar = scalar?;
    let array = brackets.map(|rest| length(text, scalar, rest)).transpose().ok()?;
    Some(FieldType { scalar, array })
}

/// What stands before the bracket, what follows it, and the type of an element.
fn parts(text: &str, version: u8) -> (&str, Option<&str>, Option<Scalar>) {
    let (element, brackets) = match text.split_once('[') {
        Some((element, rest)) => (element, Some(rest)),
        None => (text, None),
    };
    // pymavlink knows `array[N]` from the days of MAVLink 0.9.
    let plain = if element == "array" && brackets.is_some() { "int8_t" } else { element };
    (element, brackets, scalar(plain, version))
}

/// The length of an array of `scalar`; `rest` is what follows the bracket.
fn length(text: &Text, scalar: Scalar, rest: &str) -> Result<NonZeroU8, Box<Diagnostic>> {
    if matches!(scalar, Scalar::Version(_)) {
        let message = "`uint8_t_mavlink_version` cannot be an array";
        return Err(Box::new(Diagnostic::new(Code::VersionField, text.span, message)));
    }
    let length = rest.strip_suffix(']').and_then(number::count).ok_or_else(|| bad_length(text, "not a length"))?;
    let length = u8::try_from(length).map_err(|_| bad_length(text, "more than 255"))?;
    NonZeroU8::new(length).ok_or_else(|| {
        let problem = bad_length(text, "an array of nothing");
        Box::new(problem.help("leave the brackets out for a scalar"))
    })
}

/// The element type of that name; pymavlink takes the names without `_t` as well.
fn scalar(name: &str, version: u8) -> Option<Scalar> {
    if name == VERSION {
        return Some(Scalar::Version(version));
    }
    let known = |spelling: &str| name == spelling || spelling.strip_suffix("_t") == Some(name);
    SPELLINGS.into_iter().find(|(spelling, _)| known(spelling)).map(|(_, scalar)| scalar)
}

fn unknown(text: &Text, element: &str, diagnostics: &Diagnostics) -> Diagnostic {
    let message = format!("type `{element}` does not exist");
    let problem = Diagnostic::new(Code::UnknownType, text.span, message).label("no such type");
    if let Some(meant) = meant(&text.value) {
        return problem.help(format!("did you mean `{meant}`?"));
    }
    let help = "types are char, int8_t to int64_t, uint8_t to uint64_t, float and double; \
                an enum is named by `enum`, beside an integer type";
    suggest(problem.help(help), element, SPELLINGS.iter().map(|(name, _)| *name).chain([VERSION]), diagnostics)
}

/// What a type of another language is here, and an array whose brackets are not `[N]`.
fn meant(text: &str) -> Option<String> {
    let name_end = text.find(|c: char| c != '_' && !c.is_ascii_alphanumeric()).unwrap_or(text.len());
    let (name, length) = text.split_at_checked(name_end)?;
    let is_bracket = |c: char| " \t()<>{}[]".contains(c);
    let length = length.trim_matches(is_bracket);
    let known = SPELLINGS.iter().find(|(spelling, _)| *spelling == name).map(|&(spelling, _)| spelling);
    let foreign = || FOREIGN.iter().find(|(foreign, _)| *foreign == name).map(|&(_, spelling)| spelling);
    match (known.or_else(foreign)?, length) {
        ("char", "") => Some("char[N]".to_owned()),
        (meant, "") => Some(meant.to_owned()),
        (meant, digits) if is_digits(digits) => Some(format!("{meant}[{digits}]")),
        _ => None,
    }
}

fn bad_length(text: &Text, label: &str) -> Box<Diagnostic> {
    let message = format!("the length in `{}` is not a number from 1 to 255", text.value);
    Box::new(Diagnostic::new(Code::ArrayLength, text.span, message).label(label))
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
