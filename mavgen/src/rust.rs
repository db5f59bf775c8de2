//! The Rust model: every item that will exist, with its names, types, methods and documentation.
//!
//! *lower* makes it, *emit* prints it. Whatever was to be decided is decided here: a method is one of a few kinds with all that its
//! body needs, and says its signature by itself. What a field of a message is as an integer is a fact of its type ([`Element::int`]).

mod accessor;
mod command;
mod docs;
mod enums;
mod mentions;
mod message;
mod method;
#[cfg(feature = "uorb")]
mod topic;
mod tree;
mod ty;
mod view;

pub(crate) use accessor::{Convert, Extent, Sentinel, Unknown};
pub(crate) use command::{CARRIERS, Carriers, Command, CommandField, ParamTy};
pub(crate) use docs::{Cell, Docs, ListItem, Paragraph};
pub(crate) use enums::{Constant, DialectEnum, Enum, ParamInfo, Variant};
pub(crate) use mentions::Mentions;
pub(crate) use message::{Field, Frame, Gives, Struct};
pub(crate) use method::{Kind, Method, Param, Receiver, Sig};
#[cfg(feature = "uorb")]
pub(crate) use topic::{
    Definition, Held, Move, Part, Plain, Row, SameDefinition, Scalars, Topic, TopicConstant, TopicField, TopicSlot,
    TopicType,
};
pub(crate) use tree::{Alias, Child, ChildAccess, Content, Export, File, Use};
pub(crate) use ty::{Element, EnumType, Error, Int, Literal, Shape, Ty};
pub(crate) use view::{
    Bind, BitField, Count, Debugged, Holds, Key, Packed, Place, Present, Record, RecordField, RecordType, Scale,
    Selector, Slot, SlotElement, Source, Switch, Test, View, Word,
};
