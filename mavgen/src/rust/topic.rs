//! A topic: the struct of a uORB message, and where its definitions have the fields, in CDR and in records of a log.

use super::{Docs, EnumType, Int, Method, Unknown};

/// A topic.
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
    pub(crate) record: Vec<Move<'d>>,
    /// Whether another topic asks if it says anything.
    pub(crate) asked_if_blank: bool,
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
    /// Its name in the definitions.
    pub(crate) name: &'d str,
    /// The name in older definitions.
    pub(crate) was: Option<&'d str>,
}

/// A field by name and type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TopicSlot<'d> {
    pub(crate) ident: &'d str,
    pub(crate) ty: TopicType<'d>,
    /// The length of an array.
    pub(crate) len: Option<u16>,
    /// The value that means "not known", if zero does not.
    pub(crate) unknown: Option<Unknown<'d>>,
}

/// The type of a field's elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TopicType<'d> {
    /// A scalar.
    Plain(Plain),
    /// An enum, whose integer is that of the field.
    Enum(EnumType<'d>),
    /// Another topic, the name of its message, and how many places it takes.
    Message { ident: &'d str, name: &'d str, places: usize },
}

/// A scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Plain {
    Int(Int),
    F32,
    F64,
    Bool,
    Char,
}

/// One definition of a topic.
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
    /// Whether it has all fields.
    pub(crate) is_whole: bool,
    /// Where a CDR body has its fields.
    pub(crate) cdr: Vec<Move<'d>>,
}

/// A definition that is a newer one by another name.
#[derive(Clone, Debug)]
pub(crate) struct SameDefinition<'d> {
    pub(crate) constant: &'d str,
    pub(crate) docs: Docs<'d>,
    /// The constant of the newer one.
    pub(crate) of: &'d str,
}

/// A field, and where a definition has it.
#[derive(Clone, Debug)]
pub(crate) struct Move<'d> {
    pub(crate) slot: TopicSlot<'d>,
    pub(crate) at: u32,
    pub(crate) held: Held<'d>,
}

/// What a definition has of a field.
#[derive(Clone, Debug)]
pub(crate) enum Held<'d> {
    /// Scalars, which may be narrower and fewer than the field's.
    Plain(Plain, Option<u16>),
    /// Messages that lie in these ways, one after the other.
    Messages(Vec<Row<'d>>),
}

/// Nested messages of one layout.
#[derive(Clone, Debug)]
pub(crate) struct Row<'d> {
    /// Which is the first.
    pub(crate) first: u16,
    pub(crate) count: u16,
    pub(crate) at: u32,
    pub(crate) stride: u32,
    /// Bytes of one.
    pub(crate) len: u32,
    /// The topic that is nested.
    pub(crate) ident: &'d str,
    /// Whether its definition has all fields.
    pub(crate) is_whole: bool,
    pub(crate) fields: Vec<Move<'d>>,
}

impl Topic<'_> {
    /// How many places its fields take, and those of what it nests.
    pub(crate) fn places(&self) -> usize {
        self.fields.iter().map(|field| field.slot.places()).sum()
    }
}

impl TopicSlot<'_> {
    /// How many places it takes: its own, and those of what it nests.
    pub(crate) fn places(&self) -> usize {
        match self.ty {
            TopicType::Message { places, .. } => 1 + places,
            TopicType::Plain(_) | TopicType::Enum(_) => 1,
        }
    }
}

impl TopicType<'_> {
    /// The scalar, if it is one, also behind an enum.
    pub(crate) fn plain(&self) -> Option<Plain> {
        match self {
            Self::Plain(plain) => Some(*plain),
            Self::Enum(one) => Some(Plain::Int(one.int)),
            Self::Message { .. } => None,
        }
    }
}
