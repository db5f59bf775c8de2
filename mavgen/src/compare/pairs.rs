//! Which message, field, enum and entry of the new state is which of the old.

use std::collections::HashMap;

use crate::ir::{Dialect, Entry, Enum, Field, Message};

/// What two states have in common, and what only one of them has.
pub(super) struct Pairs<'a> {
    pub(super) messages: Matched<'a, Message, MessagePair<'a>>,
    pub(super) enums: Matched<'a, Enum, EnumPair<'a>>,
}

/// Things of one kind.
pub(super) struct Matched<'a, T, P> {
    pub(super) both: Vec<P>,
    pub(super) removed: Vec<&'a T>,
    pub(super) added: Vec<&'a T>,
}

/// A message that is in both states.
pub(super) struct MessagePair<'a> {
    pub(super) old: &'a Message,
    pub(super) new: &'a Message,
    pub(super) fields: Matched<'a, Field, (&'a Field, &'a Field)>,
}

/// An enum that is in both states.
pub(super) struct EnumPair<'a> {
    pub(super) old: &'a Enum,
    pub(super) new: &'a Enum,
    pub(super) entries: Matched<'a, Entry, (&'a Entry, &'a Entry)>,
}

impl<'a> Pairs<'a> {
    pub(super) fn of(old: &'a Dialect, new: &'a Dialect) -> Self {
        let messages = matched(&old.messages, &new.messages, |message| &message.name.text, same_message);
        let enums = matched(&old.enums, &new.enums, |enum_| &enum_.name.text, same_enum);
        Self {
            messages: messages.map(|(old, new)| MessagePair { old, new, fields: fields(old, new) }),
            enums: enums.map(|(old, new)| EnumPair { old, new, entries: entries(old, new) }),
        }
    }
}

impl<'a, T> Matched<'a, T, (&'a T, &'a T)> {
    fn map<P>(self, pair: impl FnMut((&'a T, &'a T)) -> P) -> Matched<'a, T, P> {
        Matched { both: self.both.into_iter().map(pair).collect(), removed: self.removed, added: self.added }
    }
}

fn fields<'a>(old: &'a Message, new: &'a Message) -> Matched<'a, Field, (&'a Field, &'a Field)> {
    matched(&old.fields, &new.fields, |field| &field.name.text, same_field)
}

fn entries<'a>(old: &'a Enum, new: &'a Enum) -> Matched<'a, Entry, (&'a Entry, &'a Entry)> {
    matched(&old.entries, &new.entries, |entry| &entry.name.text, |old, new| old.value == new.value)
}

/// Whether messages of different names are one: on the wire there is nothing but the id.
fn same_message(old: &Message, new: &Message) -> bool {
    old.id == new.id
}

impl MessagePair<'_> {
    /// Whether both have the same types in the same places.
    pub(super) fn has_one_layout(&self) -> bool {
        let layout = |message: &Message| {
            let fields = message.wire_order().into_iter();
            fields.map(|field| (type_of(field), field.extension)).collect::<Vec<_>>()
        };
        layout(self.old) == layout(self.new)
    }

    /// Whether the new message is the old one, and not another that has taken its id: half of its fields are still there.
    pub(super) fn is_one_message(&self) -> bool {
        let kept = self.fields.both.iter().filter(|(old, new)| old.name.text == new.name.text).count();
        self.old.name.text == self.new.name.text || self.has_one_layout() || 2 * kept >= self.old.fields.len()
    }
}

/// Whether fields of different names are one.
fn same_field(old: &Field, new: &Field) -> bool {
    (type_of(old), old.extension, old.offset) == (type_of(new), new.extension, new.offset)
}

/// Whether enums of different names are one: they have the same entries.
fn same_enum(old: &Enum, new: &Enum) -> bool {
    let entries = |enum_: &Enum| {
        let entries = enum_.entries.iter();
        entries.map(|entry| (entry.name.text.clone(), entry.value)).collect::<Vec<_>>()
    };
    !old.entries.is_empty() && entries(old) == entries(new)
}

/// The type of a field as the checksum knows it: `uint16_t[4]`.
pub(super) fn type_of(field: &Field) -> String {
    let scalar = field.ty.scalar.wire_name();
    field.ty.array.map_or_else(|| scalar.to_owned(), |length| format!("{scalar}[{length}]"))
}

/// Joins what has the same name; of the rest, what is the `same`.
fn matched<'a, T>(
    old: &'a [T],
    new: &'a [T],
    name: impl Fn(&T) -> &str,
    same: impl Fn(&T, &T) -> bool,
) -> Matched<'a, T, (&'a T, &'a T)> {
    let mut by_name: HashMap<&str, &T> = new.iter().map(|item| (name(item), item)).collect();
    let (mut both, mut left) = (Vec::new(), Vec::new());
    for item in old {
        match by_name.remove(name(item)) {
            Some(other) => both.push((item, other)),
            None => left.push(item),
        }
    }
    let mut added: Vec<&T> = new.iter().filter(|item| by_name.contains_key(name(item))).collect();
    let mut removed = Vec::new();
    for item in left {
        match added.iter().position(|other| same(item, other)) {
            Some(at) => both.push((item, added.remove(at))),
            None => removed.push(item),
        }
    }
    Matched { both, removed, added }
}
