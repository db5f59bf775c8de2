//! From several dialects to one tree: what is the same in them becomes one type.
//!
//! Enums of one name, width and kind are one type with the constants of all, unless an entry has another value in one of them.
//! Messages of one definition are one type, with what the overlays of all dialects add to it. What two dialects define
//! differently under one name is a type in each.

mod enums;
mod files;
mod messages;
mod placement;
#[cfg(test)]
mod tests;

use std::path::Path;

use super::names::Names;
use super::namespace::{Claim, Namespace, Scope, What};
use super::{collision, spelling};
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::internal::Internal;
use crate::ir::{Dialect, EnumId, FileIndex, Valid};
use crate::order;
use crate::source::{FileId, Span};

use enums::Enums;
use files::Files;
use messages::Messages;

pub(crate) use placement::{MessagePlacement, Placement, ViewPlacement};

/// Several dialects, linked.
#[derive(Clone, Debug)]
pub(crate) struct Union {
    /// Every type once, of whatever dialect. Names and ids are not unique here: [`Placement`] says which types stand apart.
    pub(crate) all: Dialect,
    /// What everything in [`Union::all`] is called.
    pub(crate) names: Names,
    /// Where the enums of [`Union::all`] are declared, in their order.
    pub(crate) enum_placements: Vec<Placement>,
    /// Where the messages of [`Union::all`] are declared, in their order.
    pub(crate) message_placements: Vec<MessagePlacement>,
    /// The dialects, in the order in which they were named.
    pub(crate) roots: Vec<Root>,
}

/// One of several dialects.
#[derive(Clone, Debug)]
pub(crate) struct Root {
    /// What it is called: `autoquad`.
    pub(crate) name: String,
    /// The Rust module that it is: `autoquad`.
    pub(crate) module: String,
    /// The Rust type that holds any message of it: `Autoquad`.
    pub(crate) type_name: String,
    /// Its top file, in the files of [`Union::all`].
    pub(crate) file: FileIndex,
    /// Its enums, in the order of [`Union::all`].
    pub(crate) enums: Vec<EnumId>,
    /// Its messages by id, as places in the messages of [`Union::all`].
    pub(crate) messages: Vec<usize>,
}

/// A resolved dialect, what it is called, and the source behind each of its files.
pub(crate) struct Part<'d> {
    pub(crate) dialect: Valid<'d>,
    pub(crate) names: Names,
    pub(crate) sources: Vec<FileId>,
}

/// A type, what it is called, and the dialects that have it, in their order.
struct Class<T, N> {
    item: T,
    names: N,
    roots: Vec<usize>,
}

/// Checks that no two dialects of a tree would be one module. They come by their names and top files.
pub(crate) fn check_modules<'a>(
    tree: &str,
    dialects: impl Iterator<Item = (&'a str, (FileId, &'a Path))>,
    diagnostics: &mut Diagnostics,
) {
    let dialects = dialects.map(|(name, (file, path))| (name, Span::new(file, 0..0), path.display().to_string()));
    let dialects = dialects.collect_vec();
    let mut modules = Namespace::of(Scope::Modules);
    for (name, span, path) in &dialects {
        let by = Claim::at(What::Root, path, *span);
        collision::report(modules.claim(spelling::root_module_name(name, tree), by), diagnostics);
    }
}

/// Links dialects into a tree of this name.
pub(crate) fn link(tree: &str, parts: Vec<Part<'_>>, diagnostics: &mut Diagnostics) -> Result<Union, Internal> {
    let (mut files, mut enums, mut messages) = (Files::default(), Enums::default(), Messages::default());
    let mut roots = Vec::with_capacity(parts.len());
    for (index, Part { dialect, names, sources }) in parts.into_iter().enumerate() {
        let mut dialect = dialect.dialect().clone();
        let file = files.take(&mut dialect, &sources)?;
        let ids = enums.take(
            (index, &dialect.name),
            dialect.enums.into_iter().zip(names.enums).collect_vec(),
            diagnostics,
        )?;
        let messages = messages.take(index, dialect.messages.into_iter().zip(names.messages), &ids, &enums)?;
        let mut enums: Vec<EnumId> = ids;
        order::sort_by_key(&mut enums, |id| *id);
        let module = spelling::root_module_name(&dialect.name, tree);
        roots.push(Root { name: dialect.name, module, type_name: names.dialect, file, enums, messages });
    }
    let enum_placements = placement::of_enums(&enums.list);
    let message_placements = placement::of_messages(&messages.list);
    let (all_enums, enum_names) = enums.list.into_iter().map(|class| (class.item, class.names)).unzip();
    let (all_messages, message_names) =
        messages.list.into_iter().map(|class| (class.item.message, class.names)).unzip();
    let dialect = spelling::type_name(tree);
    let all =
        Dialect { name: tree.to_owned(), version: 0, files: files.list, enums: all_enums, messages: all_messages };
    let names = Names { dialect, messages: message_names, enums: enum_names };
    Ok(Union { all, names, enum_placements, message_placements, roots })
}
