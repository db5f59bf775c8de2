//! Enums of topics.

use super::{Topics, docs};
use crate::internal::Internal;
use crate::rust::{Constant, Enum, EnumType, Literal};
use crate::uorb::model::EnumIndex;

impl<'d> Topics<'d> {
    /// The items of an enum.
    pub(super) fn enum_item(self, index: EnumIndex) -> Result<Enum<'d>, Internal> {
        let (ty, names) = (self.enum_type(index)?, self.names.enums.get(index.0));
        let found = self.union.enums.get(index.0).zip(names);
        let (model, names) = found.ok_or_else(|| Internal::new(format!("there is no enum {}", index.0)))?;
        let constants = model.entries.iter().zip(&names.constants).map(|(entry, ident)| Constant {
            ident,
            docs: docs::of_constant(&entry.constant),
            deprecated: None,
            value: bits(entry.value),
        });
        let mut entries: Vec<_> =
            model.entries.iter().map(|entry| (bits(entry.value), entry.constant.name.as_str())).collect();
        entries.sort_by_key(|(value, _)| *value);
        Ok(Enum {
            ident: ty.ident,
            alias: super::super::docs::alias(&model.name.text, ty.ident),
            docs: docs::of_enum(model),
            deprecated: None,
            int: ty.int,
            flags: ty.flags,
            constants: constants.collect(),
            methods: Vec::new(),
            params: Vec::new(),
            name: ty.ident,
            entries,
        })
    }

    /// A number as the constant of an enum, if it is one.
    pub(super) fn enum_literal(self, one: EnumType<'d>, number: i128) -> Result<Literal<'d>, Internal> {
        let found = self.union.enums.get(one.id.0).zip(self.names.enums.get(one.id.0));
        let (model, names) = found.ok_or_else(|| Internal::new(format!("there is no enum {}", one.id.0)))?;
        let mut entries = model.entries.iter().zip(&names.constants);
        let constant = entries.find(|(entry, _)| entry.value == number).map(|(_, constant)| constant.as_str());
        Ok(match constant {
            Some(constant) => Literal::Constant(one, constant),
            None => Literal::Number(one.as_int(), number),
        })
    }
}

/// A value as the bits of its integer, those of a negative one extended.
fn bits(value: i128) -> u64 {
    value as u64
}
