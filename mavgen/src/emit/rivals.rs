//! What other dialects of the tree have under the id or the name of a message, or the name of an enum: who bridges two
//! dialects has to know.

use std::ptr;

use crate::emit::Context;
use crate::ir::{Enum, Message};
use crate::lower::link::Home;

/// The lines about a message; none if no other dialect has anything else in its place.
pub(crate) fn of_message(context: &Context<'_>, message: &Message) -> Vec<String> {
    let Some(union) = context.union else { return Vec::new() };
    let mut lines = Vec::new();
    for (at, root) in union.roots.iter().enumerate() {
        let others = union.messages_of(root).filter(|other| !ptr::eq(*other, message));
        for other in others.filter(|other| other.id == message.id || other.name == message.name) {
            let link = link(context, at, "messages", &other.name.rust);
            lines.push(match other.name == message.name {
                true => format!("`{}` defines it differently: {link}.", root.name),
                false => format!("In `{}` the id {} is that of {link}.", root.name, other.id),
            });
        }
    }
    lines
}

/// The lines about an enum; none if no other dialect has another of its name.
pub(crate) fn of_enum(context: &Context<'_>, values: &Enum) -> Vec<String> {
    let Some(union) = context.union else { return Vec::new() };
    let mut lines = Vec::new();
    for (at, root) in union.roots.iter().enumerate() {
        let others = root.enums.iter().filter_map(|id| union.all.enum_by_id(*id));
        for other in others.filter(|other| other.name.text == values.name.text && !ptr::eq(*other, values)) {
            let link = link(context, at, "enums", &other.name.rust);
            let kind = if other.bitmask { "flags in a" } else { "numbers of type" };
            lines.push(format!("In `{}` it is {kind} `{}`: {link}.", root.name, other.repr.rust_name()));
        }
    }
    lines
}

/// ``[`acme::Sprayer`](super::super::acme::messages::Sprayer)``
fn link(context: &Context<'_>, at: usize, module: &str, rust: &str) -> String {
    let (shown, way) = (context.root_module(at).unwrap_or_default(), context.way(2, Home::Root(at)));
    format!("[`{shown}::{rust}`]({way}{module}::{rust})")
}
