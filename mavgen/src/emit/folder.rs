//! The folders of a tree, and what each exports.
//!
//! A tree of one dialect is one folder. A tree of several has one for what they share, and in it one for each:
//!
//! ```text
//! mod.rs     messages.rs  messages/heartbeat.rs       enums.rs  enums/mav_state.rs     views.rs …
//! acme.rs    acme/dialect.rs    acme/messages.rs      acme/enums.rs                    acme/views.rs
//! ```
//!
//! The modules of a dialect export all that it has. What is declared there is what another dialect has something else for.

use crate::emit::views;
use crate::ir::{Dialect, Enum, Message, View};
use crate::lower::link::{Home, Root, Union};
use crate::lower::names::Names;

/// A module with the modules `messages`, `enums` and `views`, as far as it has something for them.
pub(crate) struct Folder<'a> {
    /// What is declared here.
    pub(crate) home: Home,
    /// The dialect whose module it is; `None` for what several share.
    pub(crate) dialect: Option<Titled<'a>>,
    /// `mod.rs`, or `acme.rs`.
    pub(crate) file: String,
    /// What the paths of the files in it begin with: nothing, or `acme/`.
    pub(crate) prefix: String,
    /// The files that it is from.
    pub(crate) sources: String,
    /// The modules of dialects in it.
    pub(crate) roots: Vec<String>,
    /// The messages that it exports, by id.
    pub(crate) messages: Vec<Listed<&'a Message>>,
    /// The enums that it exports.
    pub(crate) enums: Vec<Listed<&'a Enum>>,
    /// The views that it exports, with their messages.
    pub(crate) views: Vec<Listed<(&'a Message, &'a View)>>,
}

/// A dialect's name, and the type that holds any message of it.
#[derive(Clone, Copy)]
pub(crate) struct Titled<'a> {
    pub(crate) name: &'a str,
    pub(crate) type_name: &'a str,
}

/// What a folder exports, and where that is declared.
pub(crate) struct Listed<T> {
    pub(crate) item: T,
    pub(crate) home: Home,
}

impl<T> Listed<T> {
    fn shared(item: T) -> Self {
        Self { item, home: Home::Shared }
    }
}

impl<'a> Folder<'a> {
    /// The whole tree of one dialect.
    pub(crate) fn of_one(dialect: &'a Dialect, names: &'a Names) -> Self {
        Self {
            home: Home::Shared,
            dialect: Some(Titled { name: &dialect.name, type_name: &names.dialect }),
            file: "mod.rs".to_owned(),
            prefix: String::new(),
            sources: dialect.files.first().map_or_else(String::new, |file| file.name.clone()),
            roots: Vec::new(),
            messages: dialect.messages.iter().map(Listed::shared).collect(),
            enums: dialect.enums.iter().map(Listed::shared).collect(),
            views: views(dialect).map(Listed::shared).collect(),
        }
    }

    /// What several dialects share, then the folder of each.
    pub(crate) fn of_several(union: &'a Union) -> Vec<Self> {
        let (enums, messages) = (union.all.enums.iter(), union.all.messages.iter());
        let enums = enums.zip(&union.enum_homes).map(|(item, &home)| Listed { item, home });
        let messages = messages.zip(&union.message_homes).map(|(item, at)| Listed { item, home: at.home });
        let views = union.views().map(|(message, view, at)| Listed { item: (message, view), home: at.home });
        let tops: Vec<&str> = union.roots.iter().map(|root| file_name(union, root)).collect();
        let mut folders = vec![Self {
            home: Home::Shared,
            dialect: None,
            file: "mod.rs".to_owned(),
            prefix: String::new(),
            sources: tops.join(", "),
            roots: union.roots.iter().map(|root| root.module.clone()).collect(),
            messages: messages.filter(|listed| listed.home == Home::Shared).collect(),
            enums: enums.filter(|listed| listed.home == Home::Shared).collect(),
            views: views.filter(|listed| listed.home == Home::Shared).collect(),
        }];
        folders.extend(union.roots.iter().enumerate().map(|(at, root)| Self::of_root(union, at, root)));
        if let Some(shared) = folders.first_mut() {
            shared.messages.sort_by_key(|listed| listed.item.id);
        }
        folders
    }

    fn of_root(union: &'a Union, at: usize, root: &'a Root) -> Self {
        let module = &root.module;
        let enums = root.enums.iter().filter_map(|&id| {
            Some(Listed { item: union.all.enum_by_id(id)?, home: union.enum_homes.get(id.0).copied()? })
        });
        let messages = root.messages.iter().filter_map(|&at| {
            Some(Listed { item: union.all.messages.get(at)?, home: union.message_homes.get(at)?.home })
        });
        let views = union.views().filter(|(_, _, view)| view.roots.contains(&at));
        Self {
            home: Home::Root(at),
            dialect: Some(Titled { name: &root.name, type_name: &root.type_name }),
            file: format!("{module}.rs"),
            prefix: format!("{module}/"),
            sources: file_name(union, root).to_owned(),
            roots: Vec::new(),
            messages: messages.collect(),
            enums: enums.collect(),
            views: views.map(|(message, view, at)| Listed { item: (message, view), home: at.home }).collect(),
        }
    }
}

fn file_name<'u>(union: &'u Union, root: &Root) -> &'u str {
    union.all.file(root.file).map_or("", |file| file.name.as_str())
}
