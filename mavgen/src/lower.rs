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
mod conflicts;
mod docs;
mod enums;
mod folder;
mod imports;
pub(crate) mod link;
mod message;
mod methods;
mod modules;
mod named;
pub(crate) mod names;
mod namespace;
pub(crate) mod spelling;
mod tree;
mod types;
mod view;

use std::fmt;

use link::{Home, Union};
use names::Names;
pub(crate) use tree::{MARK, Options, ROOT_MARK, tree, tree_of_several};

use crate::ir::{Dialect, FileIndex, Lifecycle, Origin};

/// What the items of a dialect are made of.
#[derive(Clone, Copy)]
pub(crate) struct Items<'d> {
    /// All that is generated, of however many dialects.
    dialect: &'d Dialect,
    /// What everything in it is called.
    names: &'d Names,
    /// The dialects, if there are several.
    union: Option<&'d Union>,
    /// The folder of the file that is being made.
    home: Home,
    /// Whether `<deprecated>` becomes `#[deprecated]`.
    deprecated: bool,
}

impl<'d> Items<'d> {
    /// Those of one dialect.
    pub(crate) fn of(dialect: &'d Dialect, names: &'d Names, deprecated: bool) -> Self {
        Self { dialect, names, union: None, home: Home::Shared, deprecated }
    }

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
