//! `invalid`: which value of a field means "not known" (MAVLink guide, "`invalid`").

use std::collections::HashMap;

use super::enums::Enums;
use super::message::DraftField;
use super::{field_type, number};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{FieldType, Invalid, Scalar, Scope, Sentinel};

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

/// The `invalid` value of a field; what is wrong with it is reported. An empty one says nothing.
pub(super) fn of_field(
    field: &DraftField<'_>,
    entries: &Entries<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Invalid> {
    let text = field.syntax.invalid.as_ref().filter(|text| !text.value.is_empty())?;
    match read(&text.value, field.ty, entries) {
        Ok(invalid) => return Some(invalid),
        Err(Refusal::Unknown) if !entries.complete => {}
        Err(refusal) => {
            let (message, why) = refusal.told(&text.value, field.ty.scalar.wire_name());
            let problem = Diagnostic::new(Code::Invalid, text.span, message).label(why);
            diagnostics.push(problem.help("the field is read as if it were always known"));
        }
    }
    None
}

/// What a text says of a field of that type, where no enum is known.
#[cfg(feature = "uorb")]
pub(crate) fn sentinel_of(text: &str, ty: FieldType) -> Result<Invalid, Refusal> {
    read(text, ty, &Entries { values: HashMap::new(), complete: true })
}

fn read(text: &str, ty: FieldType, entries: &Entries<'_>) -> Result<Invalid, Refusal> {
    let (scope, value) = scope(text.trim(), ty)?;
    Ok(Invalid { scope, sentinel: sentinel(value.trim(), ty.scalar, entries)? })
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

impl Refusal {
    /// What is wrong with a text on a field whose elements are called `element`, and why.
    pub(crate) fn told(self, text: &str, element: &str) -> (String, &'static str) {
        let (what, why) = match self {
            Self::Unknown => ("is not understood", "neither a number nor an entry"),
            Self::Range => (&*format!("does not fit a `{element}`"), "no element can have this value"),
            Self::NotAnArray => ("is meant for an array", "the field is a scalar"),
            Self::List => ("lists several elements", "not supported"),
        };
        (format!("`invalid` value `{text}` {what}"), why)
    }
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
    let entry = || entries.values.get(text).copied().map(i128::from);
    number::signed(text).or_else(|| limit(text)).or_else(entry)
}

/// A limit of an integer as C names it: `UINT16_MAX`.
fn limit(text: &str) -> Option<i128> {
    let (name, end) = text.rsplit_once('_')?;
    let is_named =
        |scalar: &Scalar| field_type::short_name(*scalar).is_some_and(|short| short.to_ascii_uppercase() == name);
    let range = Scalar::ALL.into_iter().find(is_named)?.range()?;
    match end {
        "MAX" => Some(*range.end()),
        "MIN" => Some(*range.start()),
        _ => None,
    }
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
