//! Enums: which values there are, and what they are called.

use super::pairs::{EnumPair, Pairs, differs, renamed};
use super::{Change, Kind};
use crate::ir::Entry;

/// The changes of all enums.
pub(super) fn changes(Pairs { enums, .. }: &Pairs<'_>) -> Vec<Change> {
    let removed = enums.removed(Kind::EnumRemoved, "", |_| None);
    removed.chain(enums.both.iter().flat_map(enum_)).chain(enums.added(Kind::EnumAdded, "", |_| None)).collect()
}

fn enum_(EnumPair { old, new, entries }: &EnumPair<'_>) -> Vec<Change> {
    let [before, after] = [old, new].map(|enum_| format!("{}.", enum_.name.text));
    let mut changes = Vec::from_iter(renamed((Kind::EnumName, false), &old.name.text, (*old, *new)));
    let value = |entry: &Entry| Some(entry.value.to_string());
    changes.extend(entries.removed(Kind::EntryRemoved, &before, value));
    for both in &entries.both {
        let item = format!("{before}{}", both.0.name.text);
        changes.extend(renamed((Kind::EntryName, false), &item, *both));
        changes.extend(differs((Kind::EntryValue, true), &item, *both, |entry| entry.value));
    }
    changes.extend(entries.added(Kind::EntryAdded, &after, value));
    changes
}
