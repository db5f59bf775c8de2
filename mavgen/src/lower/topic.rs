//! uORB messages: from the union of their definitions to the Rust model, names first.

mod definitions;
mod docs;
mod fields;
mod names;
mod parts;
mod tree;

pub(crate) use names::{CONSTANTS, UnionNames};
pub(crate) use tree::{about, tree};

use names::TopicNames;

use super::items::beside;
use super::names::EnumNames;
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::ir::EnumId;
use crate::order;
use crate::rust::{self, Constant, Element, EnumType, Literal, Topic, TopicConstant};
use crate::uorb::model::{Entry, EnumIndex, MessageIndex};
use crate::uorb::union::{Enum, Message, Union};

/// What the topics of a package are made of.
#[derive(Clone, Copy)]
struct Topics<'d> {
    union: &'d Union,
    names: &'d UnionNames,
}

#[derive(Clone, Copy)]
struct Named<'d> {
    model: &'d Message,
    names: &'d TopicNames,
}

impl<'d> Topics<'d> {
    fn message(self, index: MessageIndex) -> Result<Named<'d>, Internal> {
        let (model, names) = beside(&self.union.messages, &self.names.messages, index.0, "topic")?;
        Ok(Named { model, names })
    }

    fn enum_at(self, index: usize) -> Result<(&'d Enum, &'d EnumNames), Internal> {
        beside(&self.union.enums, &self.names.enums, index, "enum")
    }

    /// The enum behind an index, as others name it.
    fn enum_type(self, index: EnumIndex) -> Result<EnumType<'d>, Internal> {
        let (model, names) = self.enum_at(index.0)?;
        let (id, int) = (EnumId(index.0), model.repr.into());
        Ok(EnumType { id, ident: &names.ty, int, flags: model.flags, deprecated: false })
    }

    fn enum_item(self, index: EnumIndex) -> Result<rust::Enum<'d>, Internal> {
        let ((model, names), ty) = (self.enum_at(index.0)?, self.enum_type(index)?);
        // The bits of its integer, those of a negative one extended.
        let bits = |entry: &Entry| entry.value as u64;
        let constants = model.entries.iter().zip(&names.constants).map(|(entry, ident)| Constant {
            ident,
            docs: docs::of_constant(&entry.constant),
            deprecated: None,
            value: bits(entry),
        });
        let entries = model.entries.iter().map(|entry| (bits(entry), entry.constant.name.as_str()));
        let mut entries = entries.collect_vec();
        order::sort_by_key(&mut entries, |(value, _)| *value);
        Ok(rust::Enum {
            ident: ty.ident,
            alias: super::docs::alias(&model.name.text, ty.ident),
            docs: docs::of_enum(model),
            deprecated: None,
            int: ty.int,
            flags: ty.flags,
            constants: constants.collect_vec(),
            methods: Vec::new(),
            params: Vec::new(),
            name: ty.ident,
            entries,
        })
    }

    /// A number as the constant of an enum, if it is one.
    fn enum_literal(self, one: EnumType<'d>, number: i128) -> Result<Literal<'d>, Internal> {
        let (model, names) = self.enum_at(one.id.0)?;
        let mut entries = model.entries.iter().zip(&names.constants);
        Ok(match entries.find(|(entry, _)| entry.value == number) {
            Some((_, constant)) => Literal::Constant(one, constant),
            None => Literal::Number(Element::Enum(one), number),
        })
    }

    fn topic(self, message: Named<'d>) -> Result<Topic<'d>, Internal> {
        let definitions = self.definitions(message)?;
        let by_length = definitions::differ_in_length(&definitions);
        Ok(Topic {
            ident: &message.names.ty,
            alias: super::docs::alias(&message.model.name, &message.names.ty),
            docs: self.topic_docs(message, &definitions)?,
            name: &message.model.name,
            topics: &message.model.topics,
            version: message.model.version,
            queue: message.model.queue,
            constants: self.constants(message)?,
            fields: self.fields(message)?,
            methods: self.accessors(message)?,
            also: self.same_definitions(message)?,
            by_length,
            record: self.record(message)?,
            definitions,
        })
    }

    fn constants(self, message: Named<'d>) -> Result<Vec<TopicConstant<'d>>, Internal> {
        let constants = message.model.constants.iter().zip(&message.names.constants).map(|(constant, ident)| {
            let int = constant.scalar.repr();
            let int = int.ok_or_else(|| Internal::new(format!("`{}` is no integer", constant.name)))?.into();
            Ok(TopicConstant { ident, docs: docs::of_constant(constant), int, value: constant.value })
        });
        constants.try_collect_vec()
    }
}
