//! How a file names what stands in another, wherever that is.
//!
//! With one dialect there is one folder, and everything is beside everything. With several, there are the folder that they
//! share and in it one for each.

use std::collections::{BTreeMap, BTreeSet};
use std::ptr;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::emit::Context;
use crate::emit::token::ident;
use crate::ir::{EnumId, Message};
use crate::lower::link::Home;

impl Context<'_> {
    /// The way from a file that stands `depth` modules below its folder to the folder `to`: `super::super::acme::`.
    pub(crate) fn way(&self, depth: usize, to: Home) -> String {
        let out = depth + usize::from(self.home != to && self.home != Home::Shared);
        let into = match to {
            Home::Root(root) if self.home != to => self.root_module(root).map(|module| module + "::"),
            _ => None,
        };
        "super::".repeat(out) + &into.unwrap_or_default()
    }

    /// The module of one of several dialects.
    pub(crate) fn root_module(&self, root: usize) -> Option<String> {
        Some(self.union?.roots.get(root)?.module.clone())
    }

    /// Where an enum is declared.
    pub(crate) fn enum_home(&self, id: EnumId) -> Home {
        self.union.and_then(|union| union.enum_homes.get(id.0)).copied().unwrap_or(Home::Shared)
    }

    /// Where a message is declared.
    pub(crate) fn message_home(&self, message: &Message) -> Home {
        let home = self.union.and_then(|union| {
            let at = union.all.messages.iter().position(|other| ptr::eq(other, message))?;
            union.message_homes.get(at)
        });
        home.map_or(Home::Shared, |at| at.home)
    }

    /// `use super::super::enums::{MavState, MavType};`, for the file of an item.
    pub(crate) fn use_enums(&self, ids: impl IntoIterator<Item = EnumId>) -> TokenStream {
        let mut modules: BTreeMap<String, BTreeSet<Ident>> = BTreeMap::new();
        for (id, values) in ids.into_iter().filter_map(|id| Some((id, self.dialect.enum_by_id(id)?))) {
            modules.entry(self.way(2, self.enum_home(id))).or_default().insert(ident(&values.name.rust));
        }
        let uses = modules.into_iter().map(|(way, names)| {
            let (way, names) = (path(&way), names.iter());
            quote!(use #way enums::{#(#names),*};)
        });
        uses.collect()
    }

    /// `use super::super::messages::Heartbeat;`, for the file of a view.
    pub(crate) fn use_message(&self, message: &Message) -> TokenStream {
        let (way, name) = (path(&self.way(2, self.message_home(message))), ident(&message.name.rust));
        quote!(use #way messages::#name;)
    }
}

/// A path as tokens; it is made of module names, and cannot be anything else.
pub(crate) fn path(text: &str) -> TokenStream {
    text.parse().unwrap_or_default()
}
