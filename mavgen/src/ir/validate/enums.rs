//! Enums, their entries and the params of commands.

use super::Item;
use crate::ir::{Command, Entry, Enum, PARAMS, Param};

pub(super) fn check(item: &mut Item<'_>) {
    let enums = &item.dialect.enums;
    item.check_once("enum", &mut enums.iter().map(|one| &one.name));
    enums.iter().for_each(|one| check_enum(item, one));
}

fn check_enum(item: &mut Item<'_>, one: &Enum) {
    let Enum { name, bitmask: _, repr, entries, named_in, defined_in, origin } = one;
    let mut item = item.named("enum", name);
    item.check_origin(origin);
    item.check_file(*named_in);
    item.check_file(*defined_in);
    item.unless(!entries.is_empty(), "it has no entries");
    item.unless(entries.is_sorted_by(|a, b| a.value < b.value), "its values do not rise");
    item.check_once("entry", &mut entries.iter().map(|entry| &entry.name));
    for entry in entries {
        let Entry { name, value, auto: _, command, origin } = entry;
        let mut item = item.part("entry", name);
        item.check_origin(origin);
        item.unless(*value <= repr.highest(), "its value does not fit the enum");
        command.iter().for_each(|command| check_command(&mut item, command));
    }
}

fn check_command(item: &mut Item<'_>, command: &Command) {
    let Command { params, has_location: _, is_destination: _, mission_only: _ } = command;
    item.unless(params.is_sorted_by(|a, b| a.index < b.index), "the indices of its params do not rise");
    for param in params {
        let Param { index, label: _, units: _, enum_, limits, default, reserved: _, origin } = param;
        let mut item = item.other(format!("{}, param {index}", item.path), item.span);
        item.unless(PARAMS.contains(index), "its index is not one from 1 to 7");
        item.check_enum(*enum_);
        item.check_limits(*limits);
        item.unless(default.is_none_or(|value| !value.is_infinite()), "its default is infinite");
        item.check_origin(origin);
    }
}
