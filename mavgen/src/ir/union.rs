//! Several dialects in one tree of Rust: what is the same in them is one type.

use super::{Dialect, EnumId, FileIndex, Message, View};

/// Several dialects, united.
#[derive(Clone, Debug)]
pub struct Union {
    /// Every type once, of whatever dialect. Names and ids are not unique here: [`Home`] says which types stand apart.
    pub all: Dialect,
    /// Where the enums of [`Union::all`] are declared, in their order.
    pub enum_homes: Vec<Home>,
    /// Where the messages of [`Union::all`] are declared, in their order.
    pub message_homes: Vec<MessageHome>,
    /// The dialects, in the order in which they were named.
    pub roots: Vec<Root>,
}

/// One of several dialects.
#[derive(Clone, Debug)]
pub struct Root {
    /// What it is called: `autoquad`.
    pub name: String,
    /// The Rust module that it is: `autoquad`.
    pub module: String,
    /// The Rust type that holds any message of it: `Autoquad`.
    pub type_name: String,
    /// Its top file, in the files of [`Union::all`].
    pub file: FileIndex,
    /// Its enums, in the order of [`Union::all`].
    pub enums: Vec<EnumId>,
    /// Its messages by id, as places in the messages of [`Union::all`].
    pub messages: Vec<usize>,
}

/// Where a type is declared. Every dialect that has it exports it, wherever that is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Home {
    /// Beside the dialects: no dialect has anything else under its name.
    Shared,
    /// In the module of this dialect, by its place in [`Union::roots`]: the first of those that have the type.
    Root(usize),
}

/// Where a message and its views are declared.
#[derive(Clone, Debug)]
pub struct MessageHome {
    /// Of the message.
    pub home: Home,
    /// Of its views, in their order.
    pub views: Vec<ViewHome>,
}

/// Where a view is declared, and who knows it.
#[derive(Clone, Debug)]
pub struct ViewHome {
    /// Of the view.
    pub home: Home,
    /// The dialects whose overlays have it, by their places in [`Union::roots`].
    pub roots: Vec<usize>,
}

impl Union {
    /// The messages of a dialect by id.
    pub fn messages_of<'u>(&'u self, root: &'u Root) -> impl Iterator<Item = &'u Message> {
        root.messages.iter().filter_map(|&at| self.all.messages.get(at))
    }

    /// All views, with their messages.
    pub fn views(&self) -> impl Iterator<Item = (&Message, &View, &ViewHome)> {
        let messages = self.all.messages.iter().zip(&self.message_homes);
        messages
            .flat_map(|(message, at)| message.views.iter().zip(&at.views).map(move |(view, at)| (message, view, at)))
    }
}
