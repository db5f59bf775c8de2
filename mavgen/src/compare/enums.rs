//! Enums: which values there are, and what they are called.

use super::pairs::{EnumPair, Pairs};
use super::{Change, Kind};
use crate::ir::{Entry, Enum};

/// The changes of all enums.
pub(super) fn changes(pairs: &Pairs<'_>) -> Vec<Change> {
    let enums = &pairs.enums;
    let removed = enums
        .removed
        .iter()
        .map(|enum_| Change::new(Kind::EnumRemoved, true, &enum_.name.text).at(Some(enum_.origin.span), None));
    let added = enums
        .added
        .iter()
        .map(|enum_| Change::new(Kind::EnumAdded, false, &enum_.name.text).at(None, Some(enum_.origin.span)));
    removed.chain(enums.both.iter().flat_map(enum_)).chain(added).collect()
}

/// `MAV_STATE.MAV_STATE_BOOT`
pub(super) fn path(enum_: &Enum, entry: &Entry) -> String {
    format!("{}.{}", enum_.name.text, entry.name.text)
}

fn enum_(EnumPair { old, new, entries }: &EnumPair<'_>) -> Vec<Change> {
    let mut changes = Vec::new();
    if old.name.text != new.name.text {
        let change = Change::new(Kind::EnumName, false, &old.name.text).to(&new.name.text);
        changes.push(change.at(Some(old.origin.span), Some(new.origin.span)));
    }
    for entry in &entries.removed {
        let change = Change::new(Kind::EntryRemoved, true, path(old, entry)).from(entry.value.to_string());
        changes.push(change.at(Some(entry.origin.span), None));
    }
    for (before, after) in &entries.both {
        let places = (Some(before.origin.span), Some(after.origin.span));
        if before.name.text != after.name.text {
            let change = Change::new(Kind::EntryName, false, path(old, before)).to(&after.name.text);
            changes.push(change.at(places.0, places.1));
        }
        if before.value != after.value {
            let change = Change::new(Kind::EntryValue, true, path(old, before));
            changes.push(change.from(before.value.to_string()).to(after.value.to_string()).at(places.0, places.1));
        }
    }
    for entry in &entries.added {
        let change = Change::new(Kind::EntryAdded, false, path(new, entry)).to(entry.value.to_string());
        changes.push(change.at(None, Some(entry.origin.span)));
    }
    changes
}
