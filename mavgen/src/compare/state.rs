//! One of two states of a dialect, and what everything in it is called in Rust.

use super::pairs::Named;
use crate::ir::{Dialect, Enum, Message};
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
}

/// What `theirs` has at the place where `things` has this one, which is found by its name: no two have the same.
pub(super) fn of_same<'n, T: Named, N>(things: &[T], theirs: &'n [N], thing: &T) -> Option<&'n N> {
    things.iter().zip(theirs).find(|(other, _)| other.name() == thing.name()).map(|(_, names)| names)
}
