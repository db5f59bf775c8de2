//! From several dialects to one tree: what is the same in them becomes one type.
//!
//! Enums of one name, width and kind are one type with the constants of all. Messages of one definition are one type, with
//! what the overlays of all dialects add to it. What two dialects define differently under one name is a type in each.

mod definition;
mod enums;
mod files;
mod homes;
mod messages;
#[cfg(test)]
mod tests;

use crate::diag::Diagnostics;
use crate::ir::{Dialect, EnumId, Root, Union};
use crate::names;
use crate::source::FileId;

use enums::Enums;
use files::Files;
use messages::Messages;

/// A resolved dialect, and the source behind each of its files.
pub(crate) struct Part {
    pub(crate) dialect: Dialect,
    pub(crate) sources: Vec<FileId>,
}

/// A type, and the dialects that have it, in their order.
struct Class<T> {
    item: T,
    roots: Vec<usize>,
}

/// Unites dialects into a tree of this name. The result is of no use if there was an error.
pub(crate) fn unite(tree: &str, parts: Vec<Part>, diagnostics: &mut Diagnostics) -> Union {
    let (mut files, mut enums, mut messages) = (Files::default(), Enums::default(), Messages::default());
    let mut roots = Vec::with_capacity(parts.len());
    for (index, Part { mut dialect, sources }) in parts.into_iter().enumerate() {
        let file = files.take(&mut dialect, &sources);
        let ids = enums.take(index, &dialect.name, std::mem::take(&mut dialect.enums), diagnostics);
        let messages = messages.take(index, std::mem::take(&mut dialect.messages), &ids, &enums);
        let Dialect { name, type_name, .. } = dialect;
        let mut enums: Vec<EnumId> = ids;
        enums.sort_unstable();
        let module = names::root_module_name(&name, tree);
        roots.push(Root { name, module, type_name, file, enums, messages });
    }
    let enum_homes = homes::of_enums(&enums.list);
    let message_homes = homes::of_messages(&messages.list);
    let all = Dialect {
        name: tree.to_owned(),
        type_name: names::dialect_type_name(tree),
        version: 0,
        files: files.list,
        enums: enums.list.into_iter().map(|class| class.item).collect(),
        messages: messages.list.into_iter().map(|class| class.item.message).collect(),
    };
    Union { all, enum_homes, message_homes, roots }
}
