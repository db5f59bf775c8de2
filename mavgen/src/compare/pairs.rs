//! Which message, field, enum and entry of the new state is which of the old.

use std::collections::HashMap;

use super::{Change, Kind};
use crate::ir::{Dialect, Entry, Enum, Field, Message};
use crate::source::Span;

/// What definitions give a name.
pub(super) trait Named {
    fn name(&self) -> &str;
    fn span(&self) -> Span;
}

macro_rules! named {
    ($($item:ty)*) => {$(
        impl Named for $item {
            fn name(&self) -> &str {
                &self.name.text
            }

            fn span(&self) -> Span {
                self.origin.span
            }
        }
    )*};
}
named!(Message Field Enum Entry);

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
        // On the wire there is nothing but the id.
        let messages = matched(&old.messages, &new.messages, |old, new| old.id == new.id);
        let enums = matched(&old.enums, &new.enums, same_enum);
        let entries =
            |old: &'a Enum, new: &'a Enum| matched(&old.entries, &new.entries, |old, new| old.value == new.value);
        Self {
            messages: messages.map(|(old, new)| MessagePair {
                old,
                new,
                fields: matched(&old.fields, &new.fields, same_field),
            }),
            enums: enums.map(|(old, new)| EnumPair { old, new, entries: entries(old, new) }),
        }
    }
}

impl<'a, T> Matched<'a, T, (&'a T, &'a T)> {
    fn map<P>(self, pair: impl FnMut((&'a T, &'a T)) -> P) -> Matched<'a, T, P> {
        Matched { both: self.both.into_iter().map(pair).collect(), removed: self.removed, added: self.added }
    }
}

impl<T: Named, P> Matched<'_, T, P> {
    /// What is gone; before its name stands that of what it was in.
    pub(super) fn removed(
        &self,
        kind: Kind,
        of: &str,
        shown: fn(&T) -> Option<String>,
    ) -> impl Iterator<Item = Change> {
        self.removed.iter().map(move |one| {
            let change = Change::new(kind, true, format!("{of}{}", one.name())).with(shown(one), None::<&str>);
            change.at(Some(one.span()), None)
        })
    }

    /// What is new; before its name stands that of what it is in.
    pub(super) fn added(&self, kind: Kind, of: &str, shown: fn(&T) -> Option<String>) -> impl Iterator<Item = Change> {
        self.added.iter().map(move |one| {
            let change = Change::new(kind, false, format!("{of}{}", one.name())).with(None::<&str>, shown(one));
            change.at(None, Some(one.span()))
        })
    }
}

/// A change of something that is in both states, if something differs.
pub(super) fn differs<T: Named, S: ToString + PartialEq>(
    (kind, breaking): (Kind, bool),
    item: &str,
    (old, new): (&T, &T),
    what: impl Fn(&T) -> S,
) -> Option<Change> {
    let (from, to) = (what(old), what(new));
    let change = || Change::new(kind, breaking, item).at(Some(old.span()), Some(new.span()));
    (from != to).then(|| change().with(Some(from), Some(to)))
}

/// A change of a name. Only the new one is kept: `item` has the old one.
pub(super) fn renamed<T: Named>(kind: (Kind, bool), item: &str, both: (&T, &T)) -> Option<Change> {
    Some(Change { from: None, ..differs(kind, item, both, |one| one.name().to_owned())? })
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
fn matched<'a, T: Named>(old: &'a [T], new: &'a [T], same: impl Fn(&T, &T) -> bool) -> Matched<'a, T, (&'a T, &'a T)> {
    let mut by_name: HashMap<&str, &T> = new.iter().map(|item| (item.name(), item)).collect();
    let (mut both, mut left) = (Vec::new(), Vec::new());
    for item in old {
        match by_name.remove(item.name()) {
            Some(other) => both.push((item, other)),
            None => left.push(item),
        }
    }
    let mut added: Vec<&T> = new.iter().filter(|item| by_name.contains_key(item.name())).collect();
    let mut removed = Vec::new();
    for item in left {
        match added.iter().position(|other| same(item, other)) {
            Some(at) => both.push((item, added.remove(at))),
            None => removed.push(item),
        }
    }
    Matched { both, removed, added }
}
