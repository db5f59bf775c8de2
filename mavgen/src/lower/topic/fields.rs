//! The fields of a topic, and the getters and setters of those that may be unknown.

use super::names::has_accessors;
use super::{Named, Topics, definitions};
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::ir::Sentinel;
use crate::lower::accessors::optional;
use crate::lower::items::beside;
use crate::rust::{self, Extent, Literal, Method, Plain, TopicField, TopicSlot, TopicType, Unknown};
use crate::uorb::model::Element;
use crate::uorb::union::Field;

impl<'d> Topics<'d> {
    pub(super) fn fields(self, message: Named<'d>) -> Result<Vec<TopicField<'d>>, Internal> {
        (0..message.model.fields.len()).map(|at| self.field(message, at)).try_collect_vec()
    }

    fn field(self, message: Named<'d>, at: usize) -> Result<TopicField<'d>, Internal> {
        let ((field, _), slot) = (self.field_at(message, at)?, self.slot(message, at)?);
        let named = (slot.ident != slot.name).then_some(slot.name);
        Ok(TopicField { slot, docs: self.field_docs(field)?, named, was: field.was.as_deref() })
    }

    fn field_at(self, message: Named<'d>, at: usize) -> Result<(&'d Field, &'d String), Internal> {
        beside(&message.model.fields, &message.names.fields, at, "field")
    }

    /// A field by name and type.
    pub(super) fn slot(self, message: Named<'d>, at: usize) -> Result<TopicSlot<'d>, Internal> {
        let (field, ident) = self.field_at(message, at)?;
        let ty = match (self.union.typed(field), field.element) {
            (Some(one), _) => TopicType::Enum(self.enum_type(one)?),
            (None, Element::Scalar(scalar)) => TopicType::Plain(definitions::plain(scalar)),
            (None, Element::Message(nested)) => TopicType::Message(&self.message(nested)?.names.ty),
        };
        let unknown = if has_accessors(field) { self.unknown(field, ty)? } else { None };
        Ok(TopicSlot { ident, name: &field.name, ty, len: field.array, unknown })
    }

    /// The value that means "not known", in the type that the field has.
    fn unknown(self, field: &'d Field, ty: TopicType<'d>) -> Result<Option<Unknown<'d>>, Internal> {
        let Some(invalid) = field.invalid else { return Ok(None) };
        Ok(match (ty, invalid.sentinel) {
            (TopicType::Plain(Plain::F64), Sentinel::NotANumber) => Some(Unknown::NanF64),
            (TopicType::Plain(Plain::F32), Sentinel::NotANumber) => Some(Unknown::NanF32),
            (TopicType::Plain(Plain::F32 | Plain::F64), Sentinel::Float(value)) => {
                Some(Unknown::Is(Literal::Float(value)))
            }
            // A definition has it as an integer, another one as a float.
            (TopicType::Plain(Plain::F32 | Plain::F64), Sentinel::Integer(value)) => {
                Some(Unknown::Is(Literal::Float(value as f64)))
            }
            (TopicType::Plain(Plain::Int(int)), Sentinel::Integer(value)) => {
                Some(Unknown::Is(Literal::Number(rust::Element::Int(int), value)))
            }
            (TopicType::Enum(one), Sentinel::Integer(value)) => Some(Unknown::Is(self.enum_literal(one, value)?)),
            _ => None,
        })
    }

    pub(super) fn accessors(self, message: Named<'d>) -> Result<Vec<Method<'d>>, Internal> {
        let mut methods = Vec::new();
        for &at in &message.names.accessors {
            let ((field, _), slot) = (self.field_at(message, at)?, self.slot(message, at)?);
            let element = definitions::element(slot.ty);
            if let (Some(unknown), Some(element), Some(invalid)) = (slot.unknown, element, field.invalid) {
                let extent = Extent::of(invalid.scope, slot.len);
                methods.extend(optional(element, rust::Sentinel { field: slot.ident, unknown, extent }));
            }
        }
        Ok(methods)
    }
}
