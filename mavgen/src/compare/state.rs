//! One of two states of a dialect, and what everything in it is called in Rust.

use crate::ir::{Dialect, Entry, Enum, Field, Message};
use crate::lower::names::{EnumNames, MessageNames, Names};
use crate::select::Selection;

/// A state, or what is compared of it.
pub(super) struct State {
    pub(super) dialect: Dialect,
    pub(super) names: Names,
}

impl State {
    /// Names hang on the whole dialect, so they are given before anything is left out.
    pub(super) fn of(dialect: &Dialect, selection: Option<&Selection>) -> Self {
        let mut state = Self { dialect: dialect.clone(), names: Names::of(dialect) };
        if let Some(kept) = selection.map(|selection| selection.kept(dialect)) {
            state.dialect.cut(&kept);
            state.names.cut(&kept);
        }
        state
    }

    /// The messages with their names.
    pub(super) fn messages(&self) -> impl Iterator<Item = (&Message, &MessageNames)> {
        self.dialect.messages.iter().zip(&self.names.messages)
    }

    /// The enums with their names.
    pub(super) fn enums(&self) -> impl Iterator<Item = (&Enum, &EnumNames)> {
        self.dialect.enums.iter().zip(&self.names.enums)
    }

    /// The names of a message of this state.
    pub(super) fn names_of_message(&self, message: &Message) -> Option<&MessageNames> {
        self.messages().find(|(other, _)| other.name == message.name).map(|(_, names)| names)
    }

    /// The names of an enum of this state.
    pub(super) fn names_of_enum(&self, enum_: &Enum) -> Option<&EnumNames> {
        self.enums().find(|(other, _)| other.name == enum_.name).map(|(_, names)| names)
    }
}

/// What a field of a message is called.
pub(super) fn field<'n>(message: &Message, names: &'n MessageNames, field: &Field) -> Option<&'n str> {
    let at = message.fields.iter().position(|other| other.name == field.name)?;
    names.fields.get(at).map(String::as_str)
}

/// What an entry of an enum is called.
pub(super) fn constant<'n>(enum_: &Enum, names: &'n EnumNames, entry: &Entry) -> Option<&'n str> {
    let at = enum_.entries.iter().position(|other| other.name == entry.name)?;
    names.constants.get(at).map(String::as_str)
}
