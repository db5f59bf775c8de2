//! How a file names what stands in another, wherever that is.
//!
//! With one dialect there is one folder, and everything is beside everything. With several, there are the folder that they
//! share and in it one for each.

use super::items::Items;
use super::link::{Placement, Union};
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::ir::EnumId;
use crate::order;
use crate::rust::{Mentions, Use};

/// How deep the file of an item lies below its folder.
pub(super) const ITEM: usize = 2;

/// How deep `messages.rs` and the like lie below their folder.
pub(super) const MODULE: usize = 1;

impl<'d> Items<'d> {
    /// The way from a file that stands `depth` modules below its folder to the folder `to`: `super::super::acme::`.
    pub(super) fn way(self, depth: usize, to: Placement) -> Result<String, Internal> {
        let out = depth + usize::from(self.placement != to && self.placement != Placement::Shared);
        let into = match to {
            Placement::Root(root) if self.placement != to => format!("{}::", self.root_module(root)?),
            Placement::Root(_) | Placement::Shared => String::new(),
        };
        Ok("super::".repeat(out) + &into)
    }

    pub(super) fn root_module(self, root: usize) -> Result<&'d str, Internal> {
        let root = self.union.and_then(|union| union.roots.get(root));
        root.map(|root| root.module.as_str()).ok_or_else(|| Internal::new("there is no such dialect"))
    }

    /// Where an enum is declared.
    pub(super) fn enum_home(self, EnumId(at): EnumId) -> Result<Placement, Internal> {
        self.home(|union| union.enum_placements.get(at).copied())
    }

    /// Where a message is declared.
    pub(super) fn message_home(self, at: usize) -> Result<Placement, Internal> {
        self.home(|union| Some(union.message_placements.get(at)?.placement))
    }

    /// Where a view is declared, by the place of its message and its place in that.
    pub(super) fn view_home(self, (at, view): (usize, usize)) -> Result<Placement, Internal> {
        self.home(|union| Some(union.message_placements.get(at)?.views.get(view)?.placement))
    }

    fn home(self, of: impl FnOnce(&Union) -> Option<Placement>) -> Result<Placement, Internal> {
        let Some(union) = self.union else { return Ok(Placement::Shared) };
        of(union).ok_or_else(|| Internal::new("what is named is declared nowhere"))
    }

    /// The way from the file of an item to the folder of an enum.
    pub(super) fn way_to_enum(self, id: EnumId) -> Result<String, Internal> {
        self.way(ITEM, self.enum_home(id)?)
    }

    /// `use super::super::enums::{MavState, MavType};`, for the file of an item.
    pub(super) fn use_enums(self, named: &Mentions<'d>) -> Result<Vec<Use>, Internal> {
        let mut modules: Vec<(String, Vec<String>)> = Vec::new();
        for one in &named.0 {
            let (way, name) = (self.way_to_enum(one.id)? + "enums", one.ident.to_owned());
            match modules.iter_mut().find(|(known, _)| *known == way) {
                Some((_, names)) => names.push(name),
                None => modules.push((way, vec![name])),
            }
        }
        modules.iter_mut().for_each(|(_, names)| order::sort_and_dedup(names));
        order::sort_by_key(&mut modules, |(way, _)| way.clone());
        Ok(modules.into_iter().map(|(way, names)| Use::Names(way, names)).collect_vec())
    }

    /// `use super::super::messages::Heartbeat;`, for the file of a view.
    pub(super) fn use_message(self, at: usize) -> Result<Use, Internal> {
        let way = self.way(ITEM, self.message_home(at)?)? + "messages";
        Ok(Use::Names(way, vec![self.message_at(at)?.ty().to_owned()]))
    }
}
