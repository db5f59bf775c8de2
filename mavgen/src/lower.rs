//! The *lower* stage: from the wire model to the Rust model.
//!
//! Its first half is names. [`names`] gives every item one and reports what collides; it sees the whole dialect, also one with
//! errors, and runs before a selection is made, so that no name hangs on what else is selected. [`link`] makes one tree of
//! several dialects.
//!
//! The second half decides every item, and nothing can be wrong with what a user wrote any more: the model says only legal things.
//! What it names and cannot find is a mistake of ours ([`Internal`](crate::internal::Internal)).

mod accessors;
mod collision;
mod command;
mod conflicts;
mod docs;
mod enums;
mod files;
mod folder;
mod imports;
mod items;
pub(crate) mod link;
mod message;
mod modules;
pub(crate) mod names;
mod namespace;
mod options;
pub(crate) mod spelling;
#[cfg(feature = "uorb")]
pub(crate) mod topic;
mod tree;
mod view;

pub(crate) use files::{MARK, ROOT_MARK};
pub use options::Commands;
pub(crate) use options::{Options, is_feature};
pub(crate) use tree::{tree, tree_of_several};
