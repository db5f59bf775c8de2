//! `invalid`: which value of a field means "not known" (MAVLink guide, "`invalid`").

use std::collections::HashMap;

use super::enums::Enums;
use super::field::DraftField;
use super::message::Lost;
use super::number;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{FieldType, Invalid, Scalar, Scope, Sentinel};
use crate::syntax::{self, Text};

/// The limits that the attribute may name as C does.
const LIMITS: [(&str, i128); 16] = [
    ("UINT8_MAX", u8::MAX as i128),
    ("UINT16_MAX", u16::MAX as i128),
    ("UINT32_MAX", u32::MAX as i128),
    ("UINT64_MAX", u64::MAX as i128),
    ("UINT8_MIN", 0),
    ("UINT16_MIN", 0),
    ("UINT32_MIN", 0),
    ("UINT64_MIN", 0),
    ("INT8_MAX", i8::MAX as i128),
    ("INT16_MAX", i16::MAX as i128),
    ("INT32_MAX", i32::MAX as i128),
    ("INT64_MAX", i64::MAX as i128),
    ("INT8_MIN", i8::MIN as i128),
    ("INT16_MIN", i16::MIN as i128),
    ("INT32_MIN", i32::MIN as i128),
    ("INT64_MIN", i64::MIN as i128),
];

/// The entries of all enums, by name: a sentinel may be one of them.
pub(super) struct Entries<'a> {
    values: HashMap<&'a str, u64>,
    /// Whether none was lost before: only then is an unknown name worth a word.
    pub(super) complete: bool,
}

impl<'a> Entries<'a> {
    pub(super) fn of(enums: &Enums<'a>) -> Self {
        let entries = enums.list.iter().flat_map(|merged| &merged.entries);
        let valued =
            entries.filter_map(|entry| Some((entry.syntax.name.value.as_str(), u64::try_from(entry.value).ok()?)));
        Self { values: valued.collect(), complete: enums.is_exact() }
    }
}

/// The `invalid` value of a field; what is wrong with it is reported.
pub(super) fn of_field(
    field: &DraftField<'_>,
    entries: &Entries<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Invalid> {
    attribute(field.syntax).and_then(|text| resolve(text, field.ty, entries, diagnostics))
}

/// Checks the sentinels of fields whose messages cannot be read.
pub(super) fn check(lost: &[Lost<'_>], entries: &Entries<'_>, diagnostics: &mut Diagnostics) {
    for Lost { ty, syntax } in lost {
        attribute(syntax).and_then(|text| resolve(text, *ty, entries, diagnostics));
    }
}

/// What a text says of a field of that type, where no enum is known.
#[cfg(feature = "uorb")]
pub(crate) fn sentinel_of(text: &str, ty: FieldType) -> Result<Invalid, Refusal> {
    let (scope, value) = scope(text.trim(), ty)?;
    let entries = Entries { values: HashMap::new(), complete: true };
    Ok(Invalid { scope, sentinel: sentinel(value.trim(), ty.scalar, &entries)? })
}

/// The `invalid` attribute; an empty one says nothing.
fn attribute(field: &syntax::Field) -> Option<&Text> {
    field.invalid.as_ref().filter(|text| !text.value.is_empty())
}

fn resolve(text: &Text, ty: FieldType, entries: &Entries<'_>, diagnostics: &mut Diagnostics) -> Option<Invalid> {
    let refusal = match scope(text.value.trim(), ty) {
        Err(refusal) => refusal,
        Ok((scope, value)) => match sentinel(value.trim(), ty.scalar, entries) {
            Ok(sentinel) => return Some(Invalid { scope, sentinel }),
            Err(Refusal::Unknown) if !entries.complete => return None,
            Err(refusal) => refusal,
        },
    };
    let (message, label) = match refusal {
        Refusal::Unknown => {
            (format!("`invalid` value `{}` is not understood", text.value), "neither a number nor an entry")
        }
        Refusal::Range => {
            let message = format!("`invalid` value `{}` does not fit a `{}`", text.value, ty.scalar.wire_name());
            (message, "no element can have this value")
        }
        Refusal::NotAnArray => {
            (format!("`invalid` value `{}` is meant for an array", text.value), "the field is a scalar")
        }
        Refusal::List => (format!("`invalid` value `{}` lists several elements", text.value), "not supported"),
    };
    let problem = Diagnostic::new(Code::Invalid, text.span, message).label(label);
    diagnostics.push(problem.help("the field is read as if it were always known"));
    None
}

/// Why an attribute means nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Refusal {
    /// The value is no number and no name of one.
    Unknown,
    /// The field cannot have the value.
    Range,
    /// Brackets on a scalar.
    NotAnArray,
    /// `[V1,,V3]`: the guide allows it, no definition uses it.
    List,
}

/// Takes `V`, `[V]`, `[V:]` or `[V,]` apart.
///
/// A plain value on a string is its first character: a string has no unknown letters.
fn scope(text: &str, ty: FieldType) -> Result<(Scope, &str), Refusal> {
    let Some(inner) = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) else {
        let string = ty.scalar == Scalar::Char && ty.array.is_some();
        return Ok((if string { Scope::Whole } else { Scope::Each }, text));
    };
    if ty.array.is_none() {
        return Err(Refusal::NotAnArray);
    }
    if let Some(value) = inner.strip_suffix(':') {
        return Ok((Scope::Whole, value));
    }
    match inner.split_once(',') {
        None => Ok((Scope::Each, inner)),
        Some((value, rest)) if rest.trim_matches([',', ' ']).is_empty() => Ok((Scope::First, value)),
        Some(_) => Err(Refusal::List),
    }
}

/// An integer: a number, a limit as C names it, or the name of an entry.
pub(super) fn integer(text: &str, entries: &Entries<'_>) -> Option<i128> {
    number::signed(text)
        .or_else(|| LIMITS.iter().find(|(name, _)| *name == text).map(|(_, value)| *value))
        .or_else(|| entries.values.get(text).copied().map(i128::from))
}

/// The value, if an element of that type can have it.
pub(super) fn sentinel(text: &str, scalar: Scalar, entries: &Entries<'_>) -> Result<Sentinel, Refusal> {
    let integer = integer(text, entries);
    let float = number::float(text);
    match (scalar.range(), integer, float) {
        (None, Some(integer), _) => Ok(Sentinel::Float(integer as f64)),
        (None, None, Some(float)) if float.is_nan() => Ok(Sentinel::NotANumber),
        (None, None, Some(float)) if scalar.holds_float(float) => Ok(Sentinel::Float(float)),
        (Some(range), Some(integer), _) if range.contains(&integer) => Ok(Sentinel::Integer(integer)),
        (_, None, None) => Err(Refusal::Unknown),
        _ => Err(Refusal::Range),
    }
}

#[cfg(test)]
mod tests {
    use std::num::NonZeroU8;

    use super::*;

    fn read(text: &str, scalar: Scalar, array: u8) -> Result<(Scope, Sentinel), Refusal> {
        let entries = Entries { values: HashMap::from([("LANDED_UNDEFINED", 7), ("BIG", 300)]), complete: true };
        let (scope, value) = scope(text, FieldType { scalar, array: NonZeroU8::new(array) })?;
        Ok((scope, sentinel(value, scalar, &entries)?))
    }

    #[test]
    fn understood() {
        use Scope::{Each, First, Whole};
        for (text, scalar, array, expected) in [
            ("0", Scalar::U8, 0, (Each, Sentinel::Integer(0))),
            ("0", Scalar::F32, 0, (Each, Sentinel::Float(0.0))),
            ("NaN", Scalar::F32, 0, (Each, Sentinel::NotANumber)),
            ("NAN", Scalar::F64, 0, (Each, Sentinel::NotANumber)),
            ("-1.0", Scalar::F32, 0, (Each, Sentinel::Float(-1.0))),
            ("-1000", Scalar::I16, 0, (Each, Sentinel::Integer(-1000))),
            ("0xFFFF", Scalar::U16, 0, (Each, Sentinel::Integer(65535))),
            ("UINT64_MAX", Scalar::U64, 0, (Each, Sentinel::Integer(u64::MAX.into()))),
            ("INT8_MIN", Scalar::I8, 0, (Each, Sentinel::Integer(-128))),
            ("UINT16_MAX", Scalar::F32, 0, (Each, Sentinel::Float(65535.0))),
            ("LANDED_UNDEFINED", Scalar::U8, 0, (Each, Sentinel::Integer(7))),
            ("[UINT8_MAX]", Scalar::U8, 4, (Each, Sentinel::Integer(255))),
            ("UINT8_MAX", Scalar::U8, 4, (Each, Sentinel::Integer(255))),
            ("[NaN:]", Scalar::F32, 4, (Whole, Sentinel::NotANumber)),
            ("[UINT16_MAX,]", Scalar::U16, 4, (First, Sentinel::Integer(65535))),
            ("[0,,]", Scalar::U16, 4, (First, Sentinel::Integer(0))),
            ("0", Scalar::Char, 9, (Whole, Sentinel::Integer(0))),
            ("[0]", Scalar::Char, 9, (Each, Sentinel::Integer(0))),
        ] {
            assert_eq!(read(text, scalar, array), Ok(expected), "{text}");
        }
    }

    #[test]
    fn refused() {
        for (text, scalar, array, expected) in [
            ("256", Scalar::U8, 0, Refusal::Range),
            ("-1", Scalar::U8, 0, Refusal::Range),
            ("128", Scalar::I8, 0, Refusal::Range),
            ("NaN", Scalar::U32, 0, Refusal::Range),
            ("0.5", Scalar::U32, 0, Refusal::Range),
            ("1e39", Scalar::F32, 0, Refusal::Range),
            ("inf", Scalar::F64, 0, Refusal::Range),
            ("BIG", Scalar::U8, 0, Refusal::Range),
            ("UINT7_MAX", Scalar::U8, 0, Refusal::Unknown),
            ("[0]", Scalar::U8, 0, Refusal::NotAnArray),
            ("[1,,3,]", Scalar::U8, 4, Refusal::List),
            ("[]", Scalar::U8, 4, Refusal::Unknown),
            ("[0", Scalar::U8, 4, Refusal::Unknown),
        ] {
            assert_eq!(read(text, scalar, array), Err(expected), "{text}");
        }
    }
}
