//! `[@invalid V]` and `invalid="V"`: which value of a field means "not known".

use std::num::NonZeroU8;

use super::model::{Constant, Element, Field};
use super::scalar::Scalar;
use crate::ir::{FieldType, Invalid, Scope, Sentinel};
use crate::resolve::sentinel_of;

/// What an overlay says: the grammar of `invalid` in MAVLink XML, or the name of a constant of the file.
///
/// # Errors
///
/// What is wrong with it, as a sentence about it.
pub(super) fn of_overlay(text: &str, field: &Field, constants: &[Constant]) -> Result<Invalid, String> {
    let Some(ty) = field_type(field) else {
        return Err(format!("`{}` cannot say by a value that it is not known", field.name));
    };
    let named = constants.iter().find(|constant| constant.name == text.trim());
    let value = named.map_or_else(|| text.to_owned(), |constant| constant.value.to_string());
    sentinel_of(&value, ty).map_err(|refusal| refusal.told(text, field.element.name(&[])).0)
}

/// What a comment says: a value, and prose behind it. `None` if the prose says of an array what no sentinel is.
///
/// # Errors
///
/// As of [`of_overlay`].
pub(super) fn of_comment(text: &str, field: &Field, constants: &[Constant]) -> Result<Option<Invalid>, String> {
    let (value, prose) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let begins = |word: &str| prose.trim().get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word));
    if field.element == Element::Scalar(Scalar::Char) && field.array.is_some() && value == "empty" {
        return Ok(Some(Invalid { scope: Scope::Whole, sentinel: Sentinel::Integer(0) }));
    }
    if field.array.is_some() && begins("all") {
        return Ok(None);
    }
    let mut invalid = of_overlay(value, field, constants)?;
    if field.array.is_some() && begins("first") {
        invalid.scope = Scope::Whole;
    }
    Ok(Some(invalid))
}

/// The type of a field as a MAVLink message would have it; `None` for what cannot be in one. How long an array is does not
/// matter to its sentinel.
fn field_type(field: &Field) -> Option<FieldType> {
    let scalar = field.element.scalar()?.of_mavlink()?;
    Some(FieldType { scalar, array: field.array.map(|_| NonZeroU8::MIN) })
}
