//! The Rust types of fields and enums.

use super::items::Items;
use super::named::{NamedEnum, NamedField, NamedMessage};
use crate::internal::Internal;
use crate::ir::{EnumId, Field, Scalar, Values};
use crate::rust::{Element, EnumType, Literal, Shape};

impl<'d> Items<'d> {
    /// The message behind a place.
    pub(super) fn message_at(self, at: usize) -> Result<NamedMessage<'d>, Internal> {
        let found = self.dialect.messages.get(at).zip(self.names.messages.get(at));
        let (model, names) = found.ok_or_else(|| Internal::new(format!("there is no message {at}")))?;
        Ok(NamedMessage { model, names })
    }

    /// The enum behind an id.
    pub(super) fn enum_at(self, id: EnumId) -> Result<NamedEnum<'d>, Internal> {
        let found = self.dialect.enums.get(id.0).zip(self.names.enums.get(id.0));
        let (model, names) = found.ok_or_else(|| Internal::new(format!("there is no enum {}", id.0)))?;
        Ok(NamedEnum { model, names })
    }

    /// The enum behind an id, as others name it.
    pub(super) fn enum_type(self, id: EnumId) -> Result<EnumType<'d>, Internal> {
        let NamedEnum { model, names } = self.enum_at(id)?;
        let deprecated = self.is_deprecated(&model.origin);
        Ok(EnumType { id, ident: &names.ty, int: model.repr.into(), flags: model.bitmask, deprecated })
    }

    /// The type of one element of a field.
    pub(super) fn element(self, field: NamedField<'d>) -> Result<Element<'d>, Internal> {
        match field.model.values {
            Some(Values::Typed(id)) => self.enum_type(id).map(Element::Enum),
            Some(Values::Converted(_)) | None => Ok(Element::plain(field.model.ty.scalar)),
        }
    }

    /// A number as a value of a field: the constant of its enum, if there is one that can be named without a warning.
    pub(super) fn literal(self, field: NamedField<'d>, number: i128) -> Result<Literal<'d>, Internal> {
        let element = self.element(field)?;
        if let Element::Enum(one) = element {
            let mut entries = self.enum_at(one.id)?.entries().filter(|(entry, _)| i128::from(entry.value) == number);
            if let Some((entry, constant)) = entries.next()
                && !self.is_deprecated(&entry.origin)
            {
                return Ok(Literal::Constant(one, constant));
            }
        }
        Ok(Literal::Number(element.as_int(), number))
    }
}

/// How many elements a field has, and in what.
pub(super) fn shape(field: &Field) -> Shape {
    match (field.ty.array, field.ty.scalar) {
        (None, _) => Shape::One,
        (Some(n), Scalar::Char) => Shape::Chars(n.get()),
        (Some(n), _) => Shape::Array(n.get()),
    }
}
