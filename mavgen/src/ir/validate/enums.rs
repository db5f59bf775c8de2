//! Enums, their entries and the params of commands.

use super::{Faults, Item};
use crate::ir::{Command, Entry, Enum, Param};

/// Commands carry so many params.
const PARAMS: u8 = 7;

pub(super) fn check(faults: &mut Faults<'_>) {
    let enums = &faults.dialect.enums;
    let item = Item { path: format!("dialect `{}`", faults.dialect.name), span: None };
    faults.check_once(&item, "enum", enums.iter().map(|one| one.name.text.as_str()));
    enums.iter().for_each(|one| check_enum(one, faults));
}

fn check_enum(one: &Enum, faults: &mut Faults<'_>) {
    let Enum { name, bitmask: _, repr, entries, named_in, defined_in, origin } = one;
    let item = Item::named("enum", name);
    faults.check_name(&item, name);
    faults.check_origin(&item, origin);
    faults.check_file(&item, *named_in);
    faults.check_file(&item, *defined_in);
    faults.unless(!entries.is_empty(), &item, "it has no entries");
    faults.unless(entries.is_sorted_by(|a, b| a.value < b.value), &item, "its values do not rise");
    faults.check_once(&item, "entry", entries.iter().map(|entry| entry.name.text.as_str()));
    for entry in entries {
        let Entry { name, value, auto: _, command, origin } = entry;
        let item = item.part("entry", name);
        faults.check_name(&item, name);
        faults.check_origin(&item, origin);
        faults.unless(*value <= repr.highest(), &item, "its value does not fit the enum");
        if let Some(command) = command {
            check_command(&item, command, faults);
        }
    }
}

fn check_command(item: &Item, command: &Command, faults: &mut Faults<'_>) {
    let Command { params, has_location: _, is_destination: _, mission_only: _ } = command;
    faults.unless(params.is_sorted_by(|a, b| a.index < b.index), item, "the indices of its params do not rise");
    for param in params {
        let Param { index, label: _, units: _, enum_, limits, default, reserved: _, origin } = param;
        let item = Item { path: format!("{}, param {index}", item.path), span: item.span };
        faults.unless((1..=PARAMS).contains(index), &item, "its index is not one from 1 to 7");
        faults.check_enum(&item, *enum_);
        faults.check_limits(&item, *limits);
        faults.unless(default.is_none_or(|value| !value.is_infinite()), &item, "its default is infinite");
        faults.check_origin(&item, origin);
    }
}
