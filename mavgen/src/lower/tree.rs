//! The tree: the files of all folders, in a fixed order.

use std::cmp::Reverse;

use super::files::{Maker, Options};
use super::folder::{Folder, Titled};
use super::items::Items;
use super::link::Union;
use super::modules;
use super::names::Names;
use crate::internal::Internal;
use crate::ir::Valid;
use crate::order;
use crate::rust::{Content, Docs, File, Use};

/// The files of a dialect, in a fixed order.
pub(crate) fn tree<'d>(valid: Valid<'d>, names: &'d Names, options: &'d Options) -> Result<Vec<File<'d>>, Internal> {
    let items = Items::of(valid, names, options.deprecated);
    let folder = Folder::of_one(valid.dialect(), &names.dialect).with_commands(options.commands);
    files(&Maker { items, options, folder: &folder })
}

/// The files of several dialects, in a fixed order.
pub(crate) fn tree_of_several<'d>(union: &'d Union, options: &'d Options) -> Result<Vec<File<'d>>, Internal> {
    let items = Items::of_several(union, options.deprecated);
    let mut files = Vec::new();
    for folder in Folder::of_several(union)? {
        let (placement, folder) = (folder.placement, &folder.with_commands(options.commands));
        files.extend(self::files(&Maker { items: Items { placement, ..items }, options, folder })?);
    }
    Ok(files)
}

/// The files of a folder: the modules, then the items, the large ones first, so that no thread is left with one at the end.
fn files<'d>(maker: &Maker<'_, 'd>) -> Result<Vec<File<'d>>, Internal> {
    let Folder { messages, enums, views, .. } = maker.folder;
    let mut files = vec![modules::root(maker)?];
    let (mut items, mut large) = (Vec::new(), Vec::new());
    if !messages.is_empty() {
        files.extend(maker.folder.dialect.map(|dialect| self::dialect(maker, dialect)).transpose()?);
        files.push(modules::messages(maker, &mut items)?);
    }
    if !enums.is_empty() {
        files.push(modules::enums(maker, &mut large)?);
    }
    if !views.is_empty() {
        files.push(modules::views(maker, &mut items)?);
    }
    if let Some(commands) = maker.folder.commands.filter(|listed| listed.placement == maker.folder.placement) {
        files.push(modules::commands(maker, commands.item, &mut items)?);
    }
    order::sort_by_key(&mut large, |file: &File<'d>| match &file.content {
        Content::Enum(one) => Reverse(one.constants.len()),
        _ => Reverse(0),
    });
    files.extend(large.into_iter().chain(items));
    Ok(files)
}

/// `dialect.rs`.
fn dialect<'d>(maker: &Maker<'_, 'd>, dialect: Titled<'d>) -> Result<File<'d>, Internal> {
    let messages = maker.folder.messages.iter().map(|listed| listed.item);
    let item = maker.items.dialect_enum(dialect.type_name, dialect.name, messages)?;
    Ok(File {
        path: maker.path("dialect.rs"),
        header: maker.header(&[])?,
        docs: Docs::default(),
        uses: vec![Use::All("super::messages".to_owned()), maker.runtime()],
        content: Content::Dialect(item),
    })
}
