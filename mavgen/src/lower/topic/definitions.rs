//! The definitions of a topic, and their facts.

use std::collections::HashSet;

use super::names::DefinitionNames;
use super::{Named, Topics, docs};
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::lower::items::beside;
use crate::rust::{Definition, Element, Plain, SameDefinition, TopicType};
use crate::uorb::model::{self, MessageIndex, Package};
use crate::uorb::placed;
use crate::uorb::union::{Known, Message};
use crate::uorb::{self, Scalar};

/// A message in one of the definitions.
#[derive(Clone, Copy)]
pub(super) struct InDefinition<'d> {
    pub(super) definition: usize,
    pub(super) package: &'d Package,
    pub(super) message: &'d model::Message,
}

impl<'d> Topics<'d> {
    /// Those that differ, newest first.
    pub(super) fn definitions(self, message: Named<'d>) -> Result<Vec<Definition<'d>>, Internal> {
        let distinct = message.model.known.iter().filter(|known| known.same_as.is_none());
        distinct.map(|known| self.definition(message, known)).try_collect_vec()
    }

    fn definition(self, message: Named<'d>, known: &'d Known) -> Result<Definition<'d>, Internal> {
        let own = self.in_definition(known.definition, known.message)?;
        let (names, name) = self.definition_names(known.definition)?;
        let model::Message { cdr_len, struct_len, struct_padding, hash, ref type_hash, .. } = *own.message;
        let record_len = struct_len - struct_padding;
        Ok(Definition {
            constant: &names.constant,
            suffix: &names.suffix,
            docs: docs::of_definition(name, cdr_len, record_len),
            name,
            message_hash: hash,
            type_hash,
            cdr_len,
            record_len,
            formats: formats(message.model, own),
            cdr: self.part(message, own, &placed::in_cdr(own.package, own.message), 0)?,
        })
    }

    /// The names and the name of a definition.
    fn definition_names(self, at: usize) -> Result<(&'d DefinitionNames, &'d str), Internal> {
        let (one, names) = beside(&self.union.definitions, &self.names.definitions, at, "definition")?;
        Ok((names, &one.name))
    }

    pub(super) fn in_definition(self, definition: usize, message: MessageIndex) -> Result<InDefinition<'d>, Internal> {
        let package = self.union.definitions.get(definition).map(|one| &one.package);
        let found = package.and_then(|package| Some((package, package.messages.get(message.0)?)));
        let (package, message) = found.ok_or_else(|| Internal::new("a definition lacks what it is known for"))?;
        Ok(InDefinition { definition, package, message })
    }

    /// Other names of these.
    pub(super) fn same_definitions(self, message: Named<'d>) -> Result<Vec<SameDefinition<'d>>, Internal> {
        let same =
            message.model.known.iter().filter_map(|known| Some((known, message.model.known.get(known.same_as?)?)));
        let same = same.map(|(known, newer)| {
            let ((names, one), (of, newer)) =
                (self.definition_names(known.definition)?, self.definition_names(newer.definition)?);
            Ok(SameDefinition { constant: &names.constant, docs: docs::of_same(one, newer), of: &of.constant })
        });
        same.try_collect_vec()
    }
}

/// The formats of a log: its own, then those of what it nests.
fn formats(message: &Message, own: InDefinition<'_>) -> Vec<String> {
    let name = message.topics.first().map_or("", String::as_str);
    let mut formats = vec![format!("{name}:{}", uorb::record_format(own.message, own.package))];
    add_nested(own.message, own.package, &mut formats);
    formats
}

fn add_nested(message: &model::Message, package: &Package, formats: &mut Vec<String>) {
    for field in &message.fields {
        let model::Element::Message(message) = field.element else { continue };
        let Some(nested) = package.messages.get(message.0) else { continue };
        let format = format!("{}:{}", uorb::topic_name(&nested.name), uorb::log_format(nested, package));
        if !formats.contains(&format) {
            formats.push(format);
            add_nested(nested, package, formats);
        }
    }
}

/// Whether the length of a body tells which definition it is of, also if it is rounded up to four bytes.
pub(super) fn differ_in_length(definitions: &[Definition<'_>]) -> bool {
    differ(definitions.iter().map(|one| one.cdr_len))
}

fn differ(mut lengths: impl Iterator<Item = u32>) -> bool {
    let mut rounded = HashSet::new();
    lengths.all(|len| rounded.insert(len.next_multiple_of(4)))
}

/// The type of a scalar.
pub(super) fn plain(scalar: Scalar) -> Plain {
    match (scalar, scalar.repr()) {
        (_, Some(repr)) => Plain::Int(repr.into()),
        (Scalar::F32, None) => Plain::F32,
        (Scalar::F64, None) => Plain::F64,
        (Scalar::Char, None) => Plain::Char,
        (_, None) => Plain::Bool,
    }
}

/// A field's element as those of messages are, if they have such.
pub(super) fn element(ty: TopicType<'_>) -> Option<Element<'_>> {
    match ty {
        TopicType::Plain(Plain::Int(int)) => Some(Element::Int(int)),
        TopicType::Plain(Plain::F32) => Some(Element::F32),
        TopicType::Plain(Plain::F64) => Some(Element::F64),
        TopicType::Enum(one) => Some(Element::Enum(one)),
        TopicType::Plain(Plain::Bool | Plain::Char) | TopicType::Message(_) => None,
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn lengths_are_compared_as_they_are_rounded_up() {
        for (lengths, expected) in [
            (&[] as &[u32], true),
            (&[12], true),
            (&[12, 13, 20], true),
            (&[12, 12], false),
            (&[13, 16], false),
            (&[16, 13], false),
            (&[13, 14], false),
            (&[4, 20, 17], false),
        ] {
            assert_eq!(super::differ(lengths.iter().copied()), expected, "{lengths:?}");
        }
    }
}
