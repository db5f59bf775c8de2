//! The Rust types of fields and enums.

use super::{Internal, Items};
use crate::ir::{EnumId, Field, FieldIndex, Message, Scalar, Values};
use crate::rust::{Element, EnumType, Literal, Shape};

impl<'d> Items<'d> {
    /// The enum behind an id.
    pub(super) fn enum_type(self, id: EnumId) -> Result<EnumType<'d>, Internal> {
        let one = self.dialect.enum_by_id(id).ok_or_else(|| Internal::new(format!("there is no enum {}", id.0)))?;
        Ok(EnumType {
            id,
            ident: self.enum_name(one),
            int: one.repr.into(),
            flags: one.bitmask,
            deprecated: self.is_deprecated(&one.origin),
        })
    }

    /// The field behind an index.
    pub(super) fn field(self, message: &'d Message, index: FieldIndex) -> Result<&'d Field, Internal> {
        let none = || Internal::new(format!("{} has no field {}", self.message_type(message), index.0));
        message.fields.get(index.0).ok_or_else(none)
    }

    /// The type of one element of a field.
    pub(super) fn element(self, field: &'d Field) -> Result<Element<'d>, Internal> {
        match field.values {
            Some(Values::Typed(id)) => self.enum_type(id).map(Element::Enum),
            Some(Values::Converted(_)) | None => Ok(Element::plain(field.ty.scalar)),
        }
    }

    /// A number as a value of a field: the constant of its enum, if there is one that can be named without a warning.
    pub(super) fn literal(self, field: &'d Field, number: i128) -> Result<Literal<'d>, Internal> {
        let element = self.element(field)?;
        let constant = match element {
            Element::Enum(one) => self.constant_of(one, number).map(|constant| Literal::Constant(one, constant)),
            Element::Int(_) | Element::F32 | Element::F64 => None,
        };
        Ok(constant.unwrap_or(Literal::Number(element.as_int(), number)))
    }

    fn constant_of(self, one: EnumType<'d>, number: i128) -> Option<&'d str> {
        let entries = &self.dialect.enum_by_id(one.id)?.entries;
        let entry = entries.iter().find(|entry| i128::from(entry.value) == number)?;
        (!self.is_deprecated(&entry.origin)).then(|| self.constant(entry))
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
