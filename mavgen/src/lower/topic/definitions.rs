//! The definitions of a topic: their facts, and where each has the fields.

use std::collections::BTreeSet;

use super::{Named, Topics, docs};
use crate::internal::Internal;
use crate::rust::{Definition, Element, Held, Int, Move, Plain, Row, SameDefinition, TopicType};
use crate::uorb::model::{self, MessageIndex, Package};
use crate::uorb::placed::{self, Placed};
use crate::uorb::union::{Known, Message};
use crate::uorb::{self, Scalar};

/// A message in one of the definitions.
#[derive(Clone, Copy)]
struct InDefinition<'d> {
    definition: usize,
    package: &'d Package,
    message: &'d model::Message,
}

impl<'d> Topics<'d> {
    /// Those that differ, newest first.
    pub(super) fn definitions(self, index: MessageIndex) -> Result<Vec<Definition<'d>>, Internal> {
        let Named { model, .. } = self.message(index)?;
        let distinct = model.known.iter().filter(|known| known.same_as.is_none());
        distinct.map(|known| self.definition(index, known)).collect()
    }

    fn definition(self, index: MessageIndex, known: &'d Known) -> Result<Definition<'d>, Internal> {
        let Named { model, .. } = self.message(index)?;
        let own = self.in_definition(known.definition, known.message)?;
        let (names, one) = self.definition_names(known.definition)?;
        let message = own.message;
        let record_len = message.struct_len - message.struct_padding;
        Ok(Definition {
            constant: &names.constant,
            suffix: &names.suffix,
            docs: docs::of_definition(one, message.cdr_len, record_len),
            name: one,
            message_hash: message.hash,
            type_hash: &message.type_hash,
            cdr_len: message.cdr_len,
            record_len,
            formats: formats(model, own),
            is_whole: is_whole(model, known),
            cdr: self.moves(index, own, &placed::in_cdr(own.package, message))?,
        })
    }

    /// The names and the name of a definition.
    fn definition_names(self, at: usize) -> Result<(&'d super::names::DefinitionNames, &'d str), Internal> {
        let found = self.names.definitions.get(at).zip(self.union.definitions.get(at));
        let (names, one) = found.ok_or_else(|| Internal::new(format!("there is no definition {at}")))?;
        Ok((names, &one.name))
    }

    fn in_definition(self, definition: usize, message: MessageIndex) -> Result<InDefinition<'d>, Internal> {
        let package = self.union.definitions.get(definition).map(|one| &one.package);
        let found = package.and_then(|package| Some((package, package.messages.get(message.0)?)));
        let (package, message) = found.ok_or_else(|| Internal::new("a definition lacks what it is known for"))?;
        Ok(InDefinition { definition, package, message })
    }

    /// Other names of these.
    pub(super) fn same_definitions(self, index: MessageIndex) -> Result<Vec<SameDefinition<'d>>, Internal> {
        let Named { model, .. } = self.message(index)?;
        let same = model.known.iter().filter_map(|known| Some((known, model.known.get(known.same_as?)?)));
        let same = same.map(|(known, newer)| {
            let ((names, one), (of, newer)) =
                (self.definition_names(known.definition)?, self.definition_names(newer.definition)?);
            Ok(SameDefinition { constant: &names.constant, docs: docs::of_same(one, newer), of: &of.constant })
        });
        same.collect()
    }

    /// How the newest definition is written as a record.
    pub(super) fn record(self, index: MessageIndex) -> Result<Vec<Move<'d>>, Internal> {
        let Named { model, .. } = self.message(index)?;
        let newest = model.known.first().ok_or_else(|| Internal::new("a topic without a definition"))?;
        let own = self.in_definition(newest.definition, newest.message)?;
        self.moves(index, own, &placed::in_record(own.package, own.message))
    }

    /// The fields of the union that a definition has, and where.
    fn moves(self, index: MessageIndex, own: InDefinition<'d>, placed: &[Placed]) -> Result<Vec<Move<'d>>, Internal> {
        let known = self.known(index, own.definition)?;
        let moves = placed.iter().map(|Placed { field, at, held }| {
            let union = known.fields.get(*field).ok_or_else(|| Internal::new("a field is none of the union's"))?;
            let held = match held {
                placed::Held::Scalars(scalar, len) => Held::Plain(plain(*scalar), *len),
                placed::Held::Messages(nested, runs) => {
                    let nested = self.in_definition(own.definition, *nested)?;
                    Held::Messages(runs.iter().map(|run| self.row(nested, run)).collect::<Result<_, _>>()?)
                }
            };
            Ok(Move { slot: self.slot(index, *union)?, at: *at, held })
        });
        moves.collect()
    }

    fn row(self, nested: InDefinition<'d>, run: &placed::Run) -> Result<Row<'d>, Internal> {
        let at = self.union.messages.iter().position(|message| message.name == nested.message.name);
        let index = MessageIndex(at.ok_or_else(|| Internal::new(format!("there is no {}", nested.message.name)))?);
        let (Named { model, names }, known) = (self.message(index)?, self.known(index, nested.definition)?);
        Ok(Row {
            first: run.first,
            count: run.count,
            at: run.at,
            stride: run.stride,
            len: run.len,
            ident: &names.ty,
            is_whole: is_whole(model, known),
            fields: self.moves(index, nested, &run.fields)?,
        })
    }

    /// What a definition has of a message.
    fn known(self, index: MessageIndex, definition: usize) -> Result<&'d Known, Internal> {
        let mut known = self.message(index)?.model.known.iter();
        let found = known.find(|known| known.definition == definition);
        found.ok_or_else(|| Internal::new(format!("definition {definition} lacks message {}", index.0)))
    }

    /// Whether some definition has fewer of a message than fit into the union, here or where that is asked in turn.
    pub(super) fn is_asked_if_blank(self, index: MessageIndex) -> bool {
        let nests = |field: &crate::uorb::union::Field| field.element == model::Element::Message(index);
        self.union.messages.iter().enumerate().any(|(at, message)| {
            let mut fields = message.fields.iter().enumerate().filter(|(_, field)| nests(field));
            fields.any(|(place, field)| {
                let is_cut = message.known.iter().any(|known| self.array(known, place) < field.array);
                is_cut || self.is_asked_if_blank(MessageIndex(at))
            })
        })
    }

    /// The length that a definition has of a field of the union; that of the union, if it has no such field.
    fn array(self, known: &Known, place: usize) -> Option<u16> {
        let at = known.fields.iter().position(|field| *field == place);
        let own = self.in_definition(known.definition, known.message).ok();
        match at.zip(own) {
            Some((at, own)) => own.message.fields.get(at).and_then(|field| field.array),
            None => Some(u16::MAX),
        }
    }
}

/// Whether a definition has all fields of the union.
fn is_whole(message: &Message, known: &Known) -> bool {
    (0..message.fields.len()).all(|at| known.fields.contains(&at))
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
        let model::Element::Message(index) = field.element else { continue };
        let Some(nested) = package.messages.get(index.0) else { continue };
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
    let mut rounded = BTreeSet::new();
    lengths.all(|len| rounded.insert(len.next_multiple_of(4)))
}

/// The type of a scalar.
pub(super) fn plain(scalar: Scalar) -> Plain {
    match scalar {
        Scalar::F32 => Plain::F32,
        Scalar::F64 => Plain::F64,
        Scalar::Char => Plain::Char,
        Scalar::Bool => Plain::Bool,
        Scalar::I8 => Plain::Int(Int::of_bits(8, true)),
        Scalar::U8 => Plain::Int(Int::of_bits(8, false)),
        Scalar::I16 => Plain::Int(Int::of_bits(16, true)),
        Scalar::U16 => Plain::Int(Int::of_bits(16, false)),
        Scalar::I32 => Plain::Int(Int::of_bits(32, true)),
        Scalar::U32 => Plain::Int(Int::of_bits(32, false)),
        Scalar::I64 => Plain::Int(Int::of_bits(64, true)),
        Scalar::U64 => Plain::Int(Int::of_bits(64, false)),
    }
}

/// The integer that a scalar is.
pub(super) fn int(scalar: Scalar) -> Option<Int> {
    match plain(scalar) {
        Plain::Int(int) => Some(int),
        _ => None,
    }
}

/// A field's element as those of messages are, if they have such.
pub(super) fn element(ty: TopicType<'_>) -> Option<Element<'_>> {
    match ty {
        TopicType::Plain(Plain::Int(int)) => Some(Element::Int(int)),
        TopicType::Plain(Plain::F32) => Some(Element::F32),
        TopicType::Plain(Plain::F64) => Some(Element::F64),
        TopicType::Enum(one) => Some(Element::Enum(one)),
        TopicType::Plain(Plain::Bool | Plain::Char) | TopicType::Message { .. } => None,
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
