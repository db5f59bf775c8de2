//! The *lower* stage: from the wire model to the Rust model.
//!
//! Its first half is names. [`names`] gives every item one and reports what collides; it sees the whole dialect, also one with
//! errors, and runs before a selection is made, so that no name hangs on what else is selected. [`link`] makes one tree of
//! several dialects.
//!
//! The second half decides every item, and nothing can be wrong with what a user wrote any more: the model says only legal things.
//! What it names and cannot find is a mistake of ours ([`Internal`]).

mod accessors;
mod binding;
mod collision;
pub(crate) mod docs;
mod idents;
pub(crate) mod link;
mod message;
mod methods;
pub(crate) mod names;
mod namespace;
pub(crate) mod spelling;
mod types;
mod view;

use std::fmt;

use crate::ir::{Dialect, FileIndex, Lifecycle, Origin};

/// What the items of a dialect are made of.
#[derive(Clone, Copy)]
pub(crate) struct Items<'d> {
    pub(crate) dialect: &'d Dialect,
    pub(crate) names: &'d names::Names,
    /// Whether `<deprecated>` becomes `#[deprecated]`.
    pub(crate) deprecated: bool,
}

impl<'d> Items<'d> {
    /// The name of a file.
    pub(crate) fn file_name(self, index: FileIndex) -> Result<&'d str, Internal> {
        let file = self.dialect.file(index).map(|file| file.name.as_str());
        file.ok_or_else(|| Internal::new(format!("there is no file {}", index.0)))
    }

    /// Whether naming the item makes the compiler warn.
    pub(crate) fn is_deprecated(&self, origin: &Origin) -> bool {
        self.deprecated && matches!(origin.lifecycle, Some(Lifecycle::Deprecated(_)))
    }
}

/// A mistake of mavgen's own: a model that says something impossible, or items that are no Rust.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Internal(String);

impl Internal {
    /// Says what is wrong; at once, where mavgen is tested.
    pub(crate) fn new(what: impl Into<String>) -> Self {
        let what = what.into();
        debug_assert!(false, "{what}");
        Self(what)
    }
}

impl fmt::Display for Internal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
