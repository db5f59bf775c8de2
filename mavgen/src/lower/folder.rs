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

use super::link::{Placement, Root, Union, ViewPlacement};
use super::names::COMMANDS;
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::ir::{Carrier, Dialect, EnumId};
use crate::order;

/// A module with the modules `messages`, `enums`, `views` and `commands`, as far as it has something for them.
pub(super) struct Folder<'d> {
    /// What is declared here.
    pub(super) placement: Placement,
    /// The dialect whose module it is; `None` for what several share.
    pub(super) dialect: Option<Titled<'d>>,
    /// `mod.rs`, or `acme.rs`.
    pub(super) file: String,
    /// What the paths of the files in it begin with: nothing, or `acme/`.
    pub(super) prefix: String,
    /// The files that it is from.
    pub(super) sources: String,
    /// The modules of dialects in it.
    pub(super) roots: Vec<&'d str>,
    /// The messages that it exports, by id.
    pub(super) messages: Vec<usize>,
    /// The enums that it exports.
    pub(super) enums: Vec<EnumId>,
    /// The views that it exports, as places of a message and in it.
    pub(super) views: Vec<(usize, usize)>,
    /// The typed commands that it exports, and where they are declared.
    pub(super) commands: Option<(CommandSet, Placement)>,
}

/// What typed commands are made of.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct CommandSet {
    pub(super) enum_: EnumId,
    pub(super) long: Option<usize>,
    pub(super) int: Option<usize>,
}

impl CommandSet {
    /// Those of these enums and messages: `None` if there is no enum of commands, or no message that carries them.
    fn of(dialect: &Dialect, enums: &[EnumId], messages: &[usize]) -> Option<Self> {
        let is_theirs = |id: &&EnumId| dialect.enum_by_id(**id).is_some_and(|one| one.name.text == COMMANDS);
        let enum_ = *enums.iter().find(is_theirs)?;
        let (mut long, mut int) = (None, None);
        for &at in messages {
            match dialect.messages.get(at).and_then(Carrier::of) {
                Some(Carrier::Long) => long = Some(at),
                Some(Carrier::Int) => int = Some(at),
                None => {}
            }
        }
        long.or(int).map(|_| Self { enum_, long, int })
    }

    fn of_root(union: &Union, root: &Root) -> Option<Self> {
        Self::of(&union.all, &root.enums, &root.messages)
    }
}

/// A dialect's name, and the type that holds any message of it.
#[derive(Clone, Copy)]
pub(super) struct Titled<'d> {
    pub(super) name: &'d str,
    pub(super) type_name: &'d str,
}

impl<'d> Folder<'d> {
    /// The whole tree of one dialect.
    pub(super) fn of_one(dialect: &'d Dialect, type_name: &'d str) -> Self {
        let views = dialect.messages.iter().enumerate();
        let views = views.flat_map(|(at, message)| (0..message.views.len()).map(move |view| (at, view)));
        let messages = (0..dialect.messages.len()).collect_vec();
        let enums = (0..dialect.enums.len()).map(EnumId).collect_vec();
        Self {
            dialect: Some(Titled { name: &dialect.name, type_name }),
            commands: CommandSet::of(dialect, &enums, &messages).map(|commands| (commands, Placement::Shared)),
            messages,
            enums,
            views: views.collect_vec(),
            ..Self::top(dialect.files.first().map_or_else(String::new, |file| file.name.clone()))
        }
    }

    /// What is declared at the top of a tree: nothing yet.
    fn top(sources: String) -> Self {
        Self {
            placement: Placement::Shared,
            dialect: None,
            file: "mod.rs".to_owned(),
            prefix: String::new(),
            sources,
            roots: Vec::new(),
            messages: Vec::new(),
            enums: Vec::new(),
            views: Vec::new(),
            commands: None,
        }
    }

    /// What several dialects share, then the folder of each.
    pub(super) fn of_several(union: &'d Union) -> Result<Vec<Self>, Internal> {
        let is_shared = |placement: Placement| placement == Placement::Shared;
        let tops = union.roots.iter().map(|root| top_file(union, root)).try_collect_vec()?;
        let enums = union.enum_placements.iter().enumerate().filter(|(_, placement)| is_shared(**placement));
        let messages = union.message_placements.iter().enumerate().filter(|(_, at)| is_shared(at.placement));
        let enums = enums.map(|(at, _)| EnumId(at)).collect_vec();
        let mut messages = messages.map(|(at, _)| at).collect_vec();
        order::sort_by_key(&mut messages, |at| union.all.messages.get(*at).map(|message| message.id));
        let commands = CommandSet::of(&union.all, &enums, &messages);
        let commands =
            commands.filter(|shared| union.roots.iter().any(|root| CommandSet::of_root(union, root) == Some(*shared)));
        let mut folders = vec![Self {
            roots: union.roots.iter().map(|root| root.module.as_str()).collect_vec(),
            messages,
            enums,
            views: views(union, |view| is_shared(view.placement)),
            commands: commands.map(|commands| (commands, Placement::Shared)),
            ..Self::top(tops.join(", "))
        }];
        for ((at, root), top) in union.roots.iter().enumerate().zip(tops) {
            let placement = Placement::Root(at);
            let declared = |own: &CommandSet| if commands == Some(*own) { Placement::Shared } else { placement };
            folders.push(Self {
                placement,
                dialect: Some(Titled { name: &root.name, type_name: &root.type_name }),
                file: format!("{}.rs", root.module),
                prefix: format!("{}/", root.module),
                messages: root.messages.clone(),
                enums: root.enums.clone(),
                views: views(union, |view| view.roots.contains(&at)),
                commands: CommandSet::of_root(union, root).map(|own| (own, declared(&own))),
                ..Self::top(top.to_owned())
            });
        }
        Ok(folders)
    }
}

/// The views that are wanted, of all.
fn views(union: &Union, wanted: impl Fn(&ViewPlacement) -> bool) -> Vec<(usize, usize)> {
    let mut views = Vec::new();
    for (message, placements) in union.message_placements.iter().enumerate() {
        let wanted = placements.views.iter().enumerate().filter(|(_, view)| wanted(view));
        views.extend(wanted.map(|(view, _)| (message, view)));
    }
    views
}

fn top_file<'d>(union: &'d Union, root: &Root) -> Result<&'d str, Internal> {
    let file = union.all.file(root.file).map(|file| file.name.as_str());
    file.ok_or_else(|| Internal::new(format!("{} is of no file", root.name)))
}
