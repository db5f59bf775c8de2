//! The tree: the files of all folders, in a fixed order.

use std::cmp::Reverse;

use super::files::Maker;
use super::folder::{Folder, Titled};
use super::items::Items;
use super::link::Union;
use super::modules;
use super::names::Names;
use super::options::Options;
use crate::internal::Internal;
use crate::ir::Valid;
use crate::order;
use crate::rust::{Content, File, Use};

/// The files of a dialect, in a fixed order.
pub(crate) fn tree<'d>(valid: Valid<'d>, names: &'d Names, options: &'d Options) -> Result<Vec<File<'d>>, Internal> {
    let items = Items::of(valid, names, options.deprecated);
    files(&Maker { items, options, folder: &Folder::of_one(valid.dialect(), &names.dialect) })
}

/// The files of several dialects, in a fixed order.
pub(crate) fn tree_of_several<'d>(union: &'d Union, options: &'d Options) -> Result<Vec<File<'d>>, Internal> {
    let items = Items::of_several(union, options.deprecated);
    let mut files = Vec::new();
    for folder in Folder::of_several(union)? {
        let items = Items { placement: folder.placement, ..items };
        files.extend(self::files(&Maker { items, options, folder: &folder })?);
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
    if let Some((commands, _)) = maker.commands().filter(|(_, placement)| *placement == maker.folder.placement) {
        files.push(modules::commands(maker, commands, &mut items)?);
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
    let item = maker.items.dialect_enum(dialect.type_name, dialect.name, &maker.folder.messages)?;
    let uses = vec![Use::All("super::messages".to_owned()), maker.runtime()];
    maker.file("dialect.rs", &[], uses, Content::Dialect(item))
}
