//! What the messages of a dialect need: its enums, and the enums that the params of commands among them name.

use std::collections::BTreeMap;

use crate::ir::{Binding, Dialect, Enum, EnumId, Meaning, Message, Param, Values, View};

/// Drops the enums that no message needs and nobody wants, and numbers the others anew.
pub(super) fn keep_needed(dialect: &mut Dialect, wants: impl Fn(&Enum) -> bool) {
    let wanted = dialect.enums.iter().enumerate().filter(|(_, values)| wants(values));
    let wanted = wanted.map(|(index, _)| EnumId(index)).collect();
    let kept = renumbered(&needed(dialect, wanted));
    let mut index = 0;
    dialect.enums.retain(|_| {
        index += 1;
        kept.contains_key(&EnumId(index - 1))
    });
    // Whatever names an enum had it among its needs, so that it has a new number.
    let renumber = |id: &mut EnumId| *id = kept.get(id).copied().unwrap_or(*id);
    dialect.messages.iter_mut().for_each(|message| each_of_message(message, renumber));
    dialect.enums.iter_mut().for_each(|values| each_of_enum(values, renumber));
}

/// For every enum whether it is needed, or one of those in `open`. Changes nothing; the visits are those that renumber.
fn needed(dialect: &mut Dialect, mut open: Vec<EnumId>) -> Vec<bool> {
    let mut needed = vec![false; dialect.enums.len()];
    for message in &mut dialect.messages {
        each_of_message(message, |id| open.push(*id));
    }
    while let Some(id) = open.pop() {
        let (Some(seen), Some(values)) = (needed.get_mut(id.0), dialect.enums.get_mut(id.0)) else { continue };
        if !std::mem::replace(seen, true) {
            each_of_enum(values, |id| open.push(*id));
        }
    }
    needed
}

/// The new number of every needed enum.
fn renumbered(needed: &[bool]) -> BTreeMap<EnumId, EnumId> {
    let old = needed.iter().enumerate().filter(|(_, needed)| **needed).map(|(old, _)| EnumId(old));
    old.enumerate().map(|(new, old)| (old, EnumId(new))).collect()
}

/// Visits every enum that a message names.
pub(super) fn each_of_message(message: &mut Message, mut visit: impl FnMut(&mut EnumId)) {
    for field in &mut message.fields {
        if let Some(Values::Typed(id) | Values::Converted(id)) = &mut field.values {
            visit(id);
        }
    }
    for View { condition, members, .. } in &mut message.views {
        condition.iter_mut().filter_map(|condition| condition.values.as_mut()).for_each(&mut visit);
        for member in members {
            if let Meaning::Values(id) = &mut member.meaning {
                visit(id);
            }
        }
    }
    for Binding { values, condition, .. } in &mut message.bindings {
        visit(values);
        condition.iter_mut().filter_map(|condition| condition.values.as_mut()).for_each(&mut visit);
    }
}

/// Visits every enum that the params of an enum of commands name.
fn each_of_enum(values: &mut Enum, visit: impl FnMut(&mut EnumId)) {
    let commands = values.entries.iter_mut().filter_map(|entry| entry.command.as_mut());
    let params = commands.flat_map(|command| &mut command.params);
    params.filter_map(|Param { values, .. }| values.as_mut()).for_each(visit);
}
