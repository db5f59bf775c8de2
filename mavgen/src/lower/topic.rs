//! uORB messages: from the union of their definitions to the Rust model, names first.

mod definitions;
mod docs;
mod enums;
mod fields;
mod names;
mod parts;
mod tree;

pub(crate) use names::{CONSTANTS, UnionNames};
pub(crate) use tree::{about, tree};

use names::TopicNames;

use super::spelling;
use crate::internal::Internal;
use crate::rust::{EnumType, Topic, TopicConstant};
use crate::uorb::model::{EnumIndex, MessageIndex};
use crate::uorb::union::{Message, Union};

/// What the topics of a package are made of.
#[derive(Clone, Copy)]
struct Topics<'d> {
    union: &'d Union,
    names: &'d UnionNames,
}

/// A message beside its names.
#[derive(Clone, Copy)]
struct Named<'d> {
    model: &'d Message,
    names: &'d TopicNames,
}

impl<'d> Topics<'d> {
    fn message(self, index: MessageIndex) -> Result<Named<'d>, Internal> {
        let found = self.union.messages.get(index.0).zip(self.names.messages.get(index.0));
        let (model, names) = found.ok_or_else(|| Internal::new(format!("there is no topic {}", index.0)))?;
        Ok(Named { model, names })
    }

    /// The enum behind an index, as others name it.
    fn enum_type(self, index: EnumIndex) -> Result<EnumType<'d>, Internal> {
        let found = self.union.enums.get(index.0).zip(self.names.enums.get(index.0));
        let (model, names) = found.ok_or_else(|| Internal::new(format!("there is no enum {}", index.0)))?;
        let id = crate::ir::EnumId(index.0);
        Ok(EnumType { id, ident: &names.ty, int: model.repr.into(), flags: model.flags, deprecated: false })
    }

    /// The items of a message.
    fn topic(self, index: MessageIndex) -> Result<Topic<'d>, Internal> {
        let Named { model, names } = self.message(index)?;
        let definitions = self.definitions(index)?;
        let by_length = definitions::differ_in_length(&definitions);
        Ok(Topic {
            ident: &names.ty,
            alias: super::docs::alias(&model.name, &names.ty),
            docs: self.topic_docs(index, &definitions)?,
            name: &model.name,
            topics: &model.topics,
            version: model.version,
            queue: model.queue,
            constants: self.constants(index)?,
            fields: self.fields(index)?,
            methods: self.accessors(index)?,
            also: self.same_definitions(index)?,
            by_length,
            record: self.record(index)?,
            definitions,
        })
    }

    fn constants(self, index: MessageIndex) -> Result<Vec<TopicConstant<'d>>, Internal> {
        let Named { model, names } = self.message(index)?;
        let constants = model.constants.iter().zip(&names.constants).map(|(constant, ident)| {
            let int = definitions::int(constant.scalar);
            let int = int.ok_or_else(|| Internal::new(format!("`{}` is no integer", constant.name)))?;
            let docs = docs::of_constant(constant);
            Ok(TopicConstant { ident, docs, int, value: constant.value })
        });
        constants.collect()
    }
}
