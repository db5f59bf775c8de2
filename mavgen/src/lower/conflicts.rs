//! What other dialects of the tree have under the id or the name of a message, or the name of an enum: who bridges two
//! dialects has to know.

use super::imports::ITEM;
use super::items::Items;
use super::link::Placement;
use crate::internal::Internal;
use crate::ir::EnumId;

impl Items<'_> {
    /// The lines about a message; none if no other dialect has anything else in its place.
    pub(super) fn conflicts_of_message(self, at: usize) -> Result<Vec<String>, Internal> {
        let Some(union) = self.union else { return Ok(Vec::new()) };
        let message = self.message_at(at)?.model;
        let mut lines = Vec::new();
        for (index, root) in union.roots.iter().enumerate() {
            for &other in root.messages.iter().filter(|&&other| other != at) {
                let other = self.message_at(other)?;
                let link = || self.link(index, "messages", other.ty());
                if other.model.name.text == message.name.text {
                    lines.push(format!("`{}` defines it differently: {}.", root.name, link()?));
                } else if other.model.id == message.id {
                    lines.push(format!("In `{}` the id {} is that of {}.", root.name, message.id, link()?));
                }
            }
        }
        Ok(lines)
    }

    /// The lines about an enum; none if no other dialect has another of its name.
    pub(super) fn conflicts_of_enum(self, id: EnumId) -> Result<Vec<String>, Internal> {
        let Some(union) = self.union else { return Ok(Vec::new()) };
        let own = self.enum_at(id)?.model;
        let mut lines = Vec::new();
        for (index, root) in union.roots.iter().enumerate() {
            for &other in root.enums.iter().filter(|&&other| other != id) {
                let (ident, other) = (self.enum_type(other)?.ident, self.enum_at(other)?.model);
                if other.name.text == own.name.text {
                    let link = self.link(index, "enums", ident)?;
                    let kind = if other.bitmask { "flags in a" } else { "numbers of type" };
                    lines.push(match (other.bitmask, other.repr) == (own.bitmask, own.repr) {
                        true => format!("In `{}` an entry has another value: {link}.", root.name),
                        false => format!("In `{}` it is {kind} `{}`: {link}.", root.name, other.repr.name()),
                    });
                }
            }
        }
        Ok(lines)
    }

    /// ``[`acme::Sprayer`](super::super::acme::messages::Sprayer)``
    fn link(self, root: usize, module: &str, ident: &str) -> Result<String, Internal> {
        let (shown, way) = (self.root_module(root)?, self.way(ITEM, Placement::Root(root))?);
        Ok(format!("[`{shown}::{ident}`]({way}{module}::{ident})"))
    }
}
