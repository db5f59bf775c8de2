//! Typed commands: their types, and their fields by the labels of params.
//!
//! Labels are documentation: what collides here is a warning, and has another name or none.

use std::collections::HashSet;

use super::{COMMANDS, CommandNames, EnumNames};
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::ir::{Command, Dialect, Entry, Param};
use crate::lower::namespace::{Claim, Namespace, Scope, What};
use crate::lower::{collision, spelling};
use crate::rust::CARRIERS;

/// Names the commands of a dialect.
pub(super) fn name(dialect: &Dialect, enums: &mut [EnumNames], diagnostics: &mut Diagnostics) {
    let Some(at) = dialect.enums.iter().position(|one| one.name.text == COMMANDS) else { return };
    let types = enums.iter().map(|names| names.ty.clone()).collect_vec();
    let (Some(model), Some(names)) = (dialect.enums.get(at), enums.get_mut(at)) else { return };
    let rivals = |command: &Command| -> HashSet<&str> {
        let enums = command.params.iter().filter_map(|param| types.get(param.enum_?.0)).map(String::as_str);
        enums.chain([CARRIERS]).collect()
    };
    let each = model.entries.iter().zip(&names.constants);
    let mut commands: Vec<_> = each
        .map(|(entry, constant)| {
            let command = entry.command.as_ref().filter(|_| u16::try_from(entry.value).is_ok())?;
            Some(of(constant, command, &rivals(command), diagnostics))
        })
        .collect_vec();
    apart(dialect, &model.entries, &mut commands, diagnostics);
    names.commands = commands;
}

/// The names of a command. Its type is called otherwise than the enums in it, and than what all commands are carried by.
fn of(constant: &str, command: &Command, rivals: &HashSet<&str>, diagnostics: &mut Diagnostics) -> CommandNames {
    let ty = spelling::type_name(constant);
    CommandNames {
        ty: if rivals.contains(ty.as_str()) { spelling::suffixed(&ty, "Command") } else { ty },
        module: spelling::item_module_name(constant),
        fields: fields(command, diagnostics),
    }
}

/// Takes their type from those that others have already: the older one keeps it.
fn apart(dialect: &Dialect, entries: &[Entry], commands: &mut [Option<CommandNames>], diagnostics: &mut Diagnostics) {
    let mut order = (0..entries.len()).collect_vec();
    crate::order::sort_by_key(&mut order, |at| entries.get(*at).map(|entry| dialect.age(entry.origin.file)));
    let mut types = Namespace::of(Scope::Commands);
    for at in order {
        let (Some(entry), Some(command)) = (entries.get(at), commands.get_mut(at)) else { continue };
        let Some(names) = command else { continue };
        if !collision::is_free(types.claim(names.ty.clone(), Claim::of(What::Entry, &entry.name)), diagnostics) {
            *command = None;
        }
    }
}

/// Takes their type from commands that came from another dialect and are called like one that is there: of one type, the first
/// that is in the list stays.
pub(in crate::lower) fn drop_rivals(commands: &mut [Option<CommandNames>], known: usize) {
    let mut types: HashSet<String> = commands.iter().take(known).flatten().map(|names| names.ty.clone()).collect();
    for command in commands.iter_mut().skip(known) {
        if command.as_ref().is_some_and(|names| !types.insert(names.ty.clone())) {
            *command = None;
        }
    }
}

/// The fields of a command: after the labels of params, or after the number of one whose label is no name of its own.
fn fields(command: &Command, diagnostics: &mut Diagnostics) -> Vec<Option<String>> {
    let mut taken = Namespace::of(Scope::Params);
    let mut names: Vec<Option<String>> = Vec::with_capacity(command.params.len());
    for param in &command.params {
        names.push(label(param).and_then(|label| {
            let Some(name) = spelling::param_name(label) else {
                diagnostics.push(collision::no_label(label, param.origin.span));
                return None;
            };
            let found = taken.claim(name.clone(), Claim::at(What::Param, label, param.origin.span));
            collision::is_free(found, diagnostics).then_some(name)
        }));
    }
    for (param, name) in command.params.iter().zip(&mut names) {
        if label(param).is_some() && name.is_none() {
            let numbered = format!("param{}", param.index);
            // No label ends with an underscore.
            *name = Some(if taken.get(&numbered).is_some() { numbered + "_" } else { numbered });
        }
    }
    names
}

/// The label of a param that a command has a field for.
fn label(param: &Param) -> Option<&str> {
    param.label.as_deref().filter(|_| !param.reserved)
}
