//! A topic: the struct of a uORB message, and where its definitions have the fields, in CDR and in records of a log.

use super::{Docs, EnumType, Int, Method, Unknown};

#[derive(Clone, Debug)]
pub(crate) struct Topic<'d> {
    pub(crate) ident: &'d str,
    /// The name of the message where it is another.
    pub(crate) alias: Option<&'d str>,
    pub(crate) docs: Docs<'d>,
    /// The name of the message.
    pub(crate) name: &'d str,
    /// What carries it.
    pub(crate) topics: &'d [String],
    pub(crate) version: Option<u32>,
    pub(crate) queue: Option<u32>,
    pub(crate) constants: Vec<TopicConstant<'d>>,
    pub(crate) fields: Vec<TopicField<'d>>,
    pub(crate) methods: Vec<Method<'d>>,
    /// What it was at different times, newest first.
    pub(crate) definitions: Vec<Definition<'d>>,
    /// Other names of these: the constant, and that of the definition.
    pub(crate) also: Vec<SameDefinition<'d>>,
    /// Whether the length of a CDR body tells which definition it is of.
    pub(crate) by_length: bool,
    /// How the newest definition is written as a record.
    pub(crate) record: Part<'d>,
}

/// `pub const CONNECTED_ESC_MAX: u8 = 8;`
#[derive(Clone, Debug)]
pub(crate) struct TopicConstant<'d> {
    pub(crate) ident: &'d str,
    pub(crate) docs: Docs<'d>,
    pub(crate) int: Int,
    pub(crate) value: i128,
}

/// A public field.
#[derive(Clone, Debug)]
pub(crate) struct TopicField<'d> {
    pub(crate) slot: TopicSlot<'d>,
    pub(crate) docs: Docs<'d>,
    /// Its name in the definitions, where it is another.
    pub(crate) named: Option<&'d str>,
    /// The name in older definitions.
    pub(crate) was: Option<&'d str>,
}

/// A field by name and type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TopicSlot<'d> {
    pub(crate) ident: &'d str,
    /// Its name in the definitions.
    pub(crate) name: &'d str,
    pub(crate) ty: TopicType<'d>,
    /// The length of an array.
    pub(crate) len: Option<u16>,
    /// The value that means "not known", if zero does not.
    pub(crate) unknown: Option<Unknown<'d>>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TopicType<'d> {
    Plain(Plain),
    /// An enum, whose integer is that of the field.
    Enum(EnumType<'d>),
    Message(&'d str),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Plain {
    Int(Int),
    F32,
    F64,
    Bool,
    Char,
}

#[derive(Clone, Debug)]
pub(crate) struct Definition<'d> {
    /// `MAIN`
    pub(crate) constant: &'d str,
    /// What stands behind `read_` and `store_`: `main`.
    pub(crate) suffix: &'d str,
    pub(crate) docs: Docs<'d>,
    pub(crate) name: &'d str,
    pub(crate) message_hash: u32,
    pub(crate) type_hash: &'d str,
    /// Bytes of a CDR body.
    pub(crate) cdr_len: u32,
    /// Bytes of a record of a log.
    pub(crate) record_len: u32,
    /// The formats of a log, its own first.
    pub(crate) formats: Vec<String>,
    /// What a CDR body has.
    pub(crate) cdr: Part<'d>,
}

/// A definition that is a newer one by another name.
#[derive(Clone, Debug)]
pub(crate) struct SameDefinition<'d> {
    pub(crate) constant: &'d str,
    pub(crate) docs: Docs<'d>,
    /// The constant of the newer one.
    pub(crate) of: &'d str,
}

/// What a definition has of a message.
#[derive(Clone, Debug)]
pub(crate) struct Part<'d> {
    /// The topic.
    pub(crate) ident: &'d str,
    pub(crate) fields: Vec<Move<'d>>,
    /// Whether a literal of the fields that are not [`later`](Move::later) lacks some of the topic's.
    pub(crate) lacks: bool,
}

/// A field, and where a definition has it.
#[derive(Clone, Debug)]
pub(crate) struct Move<'d> {
    pub(crate) slot: TopicSlot<'d>,
    pub(crate) at: u32,
    pub(crate) held: Held<'d>,
    /// Whether it is read over what the field is where nothing is known, and not as a value of the literal.
    pub(crate) later: bool,
}

/// What a definition has of a field.
#[derive(Clone, Debug)]
pub(crate) enum Held<'d> {
    Scalars(Scalars),
    /// A message that is no array.
    Message(Part<'d>),
    /// As many messages as the field has, of one layout, none of which can be refused.
    Each(Row<'d>),
    /// Messages that lie in these ways, one after the other; how many there are if the field has more.
    Rows(Vec<Row<'d>>, Option<u16>),
}

/// Scalars as a definition has them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Scalars {
    pub(crate) stored: Plain,
    /// The length of an array.
    pub(crate) len: Option<u16>,
    /// Whether the field's type is a wider one.
    pub(crate) widens: bool,
    /// Whether the field has more of them.
    pub(crate) few: bool,
}

/// Nested messages of one layout.
#[derive(Clone, Debug)]
pub(crate) struct Row<'d> {
    /// How many of the field's elements stand before.
    pub(crate) skip: u16,
    /// How many there are, if more of the field's elements follow.
    pub(crate) take: Option<u16>,
    pub(crate) at: u32,
    pub(crate) stride: u32,
    /// Bytes of one.
    pub(crate) len: u32,
    pub(crate) part: Part<'d>,
}

impl TopicType<'_> {
    /// The scalar, if it is one, also behind an enum.
    pub(crate) fn plain(&self) -> Option<Plain> {
        match self {
            Self::Plain(plain) => Some(*plain),
            Self::Enum(one) => Some(Plain::Int(one.int)),
            Self::Message(_) => None,
        }
    }
}
