//! A part of a dialect: which messages and enums stay, and what the enums are called then.

use super::visit::{enums_of_enum, enums_of_enum_mut, enums_of_message, enums_of_message_mut};
use super::{Dialect, Enum, EnumId, Message};
use crate::collect::CollectVec as _;

/// What stays of a dialect, by the places in its vectors; in their order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Kept {
    messages: Vec<bool>,
    enums: Vec<bool>,
}

impl Kept {
    /// The wanted messages, the wanted enums, and the enums that those need: of fields, bindings, views and the params of
    /// commands.
    pub(crate) fn of(
        dialect: &Dialect,
        wants_message: impl Fn(&Message) -> bool,
        wants_enum: impl Fn(&Enum) -> bool,
    ) -> Self {
        let messages = dialect.messages.iter().map(wants_message).collect_vec();
        let wanted = dialect.enums.iter().enumerate().filter(|(_, enum_)| wants_enum(enum_));
        let mut open = wanted.map(|(index, _)| EnumId(index)).collect_vec();
        for (message, _) in dialect.messages.iter().zip(&messages).filter(|(_, stays)| **stays) {
            enums_of_message(message, &mut |id| open.push(*id));
        }
        let mut enums = vec![false; dialect.enums.len()];
        while let Some(id) = open.pop() {
            let (Some(seen), Some(enum_)) = (enums.get_mut(id.0), dialect.enum_by_id(id)) else { continue };
            if !std::mem::replace(seen, true) {
                enums_of_enum(enum_, &mut |id| open.push(*id));
            }
        }
        Self { messages, enums }
    }

    /// What stays of a vector that is parallel to [`Dialect::messages`].
    pub(crate) fn cut_messages<T>(&self, items: &mut Vec<T>) {
        retain(items, &self.messages);
    }

    /// What stays of a vector that is parallel to [`Dialect::enums`].
    pub(crate) fn cut_enums<T>(&self, items: &mut Vec<T>) {
        retain(items, &self.enums);
    }
}

fn retain<T>(items: &mut Vec<T>, stays: &[bool]) {
    debug_assert_eq!(items.len(), stays.len(), "what is cut is parallel to the model");
    let mut stays = stays.iter();
    items.retain(|_| stays.next() == Some(&true));
}

impl Dialect {
    /// Drops what does not stay, and numbers the enums anew. Files stay, also those that nothing is kept of: they were read.
    pub(crate) fn cut(&mut self, kept: &Kept) {
        kept.cut_messages(&mut self.messages);
        kept.cut_enums(&mut self.enums);
        // For each enum, how many of those before it stay: what stays gets that number.
        let before = |count: &mut usize, stays: &bool| Some(std::mem::replace(count, *count + usize::from(*stays)));
        let numbers = kept.enums.iter().scan(0, before).collect_vec();
        // Whatever names an enum had it among its needs, so that it has a new number; what names none goes on naming none.
        let mut renumber = |id: &mut EnumId| *id = numbers.get(id.0).copied().map_or(*id, EnumId);
        self.messages.iter_mut().for_each(|message| enums_of_message_mut(message, &mut renumber));
        self.enums.iter_mut().for_each(|enum_| enums_of_enum_mut(enum_, &mut renumber));
    }
}
