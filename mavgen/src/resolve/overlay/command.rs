//! `<command>`: what the params of a command are, where the definitions do not name them.

use std::collections::HashMap;

use super::super::enums::{Enums, Merged};
use super::super::origin::origin;
use super::super::{boolean, number, suggest, units};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{self, FileIndex, Limits, Origin, Param, param_words};
use crate::read::Loaded;
use crate::syntax::Text;
use crate::syntax::overlay::{Command, NamedParam};

/// The enum of the commands.
const COMMANDS: &str = "MAV_CMD";

/// What overlays say of commands, by entry.
pub(in crate::resolve) struct Commands<'a> {
    said: HashMap<&'a str, Vec<(FileIndex, &'a Command)>>,
}

impl<'a> Commands<'a> {
    /// Reads the commands of all overlays. One that does not exist is reported.
    pub(in crate::resolve) fn of(loaded: &'a Loaded, enums: &Enums<'a>, diagnostics: &mut Diagnostics) -> Self {
        let mut said: HashMap<&'a str, Vec<_>> = HashMap::new();
        let known = enums.id(COMMANDS).and_then(|id| enums.get(id));
        for (file, overlay) in loaded.numbered_overlays() {
            for command in &overlay.commands {
                said.entry(&command.name.value).or_default().push((file, command));
                check(&command.name, known, enums.complete, diagnostics);
            }
        }
        Self { said }
    }

    /// Adds what they say of an entry.
    pub(in crate::resolve) fn add_to(
        &self,
        (enum_, entry): (&str, &str),
        (command, origin): (&mut Option<ir::Command>, &mut Origin),
        enums: &Enums<'_>,
        diagnostics: &mut Diagnostics,
    ) {
        let Some(said) = self.said.get(entry).filter(|_| enum_ == COMMANDS) else { return };
        let command = command.get_or_insert_default();
        let mut named: HashMap<u8, &Text> = HashMap::new();
        for (file, element) in said {
            origin.overlays.extend((!origin.overlays.contains(file)).then_some(*file));
            for (text, flag) in [
                (&element.has_location, &mut command.has_location),
                (&element.is_destination, &mut command.is_destination),
            ] {
                *flag = boolean::of_overlay(text, diagnostics).unwrap_or(*flag);
            }
            for param in &element.params {
                let Some(index) = index(param, &mut named, diagnostics) else { continue };
                name(command, index, (*file, param), enums, diagnostics);
            }
        }
        check_labels(command, &named, diagnostics);
    }
}

/// Reports a command that does not exist.
fn check(name: &Text, known: Option<&Merged<'_>>, complete: bool, diagnostics: &mut Diagnostics) {
    let entries = || known.into_iter().flat_map(Merged::entry_names);
    if !complete || entries().any(|entry| entry == name.value) {
        return;
    }
    let message = format!("`{COMMANDS}` has no command `{}`", name.value);
    let problem = Diagnostic::new(Code::OverlayCommand, name.span, message).label("no such command");
    suggest::report(problem, &name.value, &mut entries(), diagnostics);
}

/// The number of a param, which is named once.
fn index<'a>(param: &'a NamedParam, named: &mut HashMap<u8, &'a Text>, diagnostics: &mut Diagnostics) -> Option<u8> {
    let text = &param.index;
    let index = number::count(&text.value).and_then(|index| u8::try_from(index).ok());
    let Some(index) = index.filter(|index| (1..=7).contains(index)) else {
        let message = format!("param index `{}` is not a number from 1 to 7", text.value);
        let problem = Diagnostic::new(Code::OverlayParam, text.span, message);
        diagnostics.push(problem.help("`COMMAND_LONG` and `COMMAND_INT` carry seven"));
        return None;
    };
    if let Some(first) = named.insert(index, &param.label) {
        let message = format!("param {index} is named twice");
        let problem = Diagnostic::new(Code::OverlayParam, text.span, message).related(first.span, "the first time");
        diagnostics.push(problem.help("leave one of them out"));
        return None;
    }
    Some(index)
}

/// Names a param.
fn name(
    command: &mut ir::Command,
    index: u8,
    (file, element): (FileIndex, &NamedParam),
    enums: &Enums<'_>,
    diagnostics: &mut Diagnostics,
) {
    let place = command.params.partition_point(|param| param.index < index);
    if command.params.get(place).is_none_or(|param| param.index != index) {
        command.params.insert(place, unsaid(index, file, element));
    }
    let Some(param) = command.params.get_mut(place) else { return };
    if param.reserved {
        let message = format!("param {index} is reserved: it is sent as its default");
        let problem = Diagnostic::new(Code::OverlayParam, element.index.span, message);
        diagnostics.push(problem.related(param.origin.span, "the definition").help("leave it out"));
        return;
    }
    if param.label.as_deref() == Some(&element.label.value) {
        let message = format!("param {index} is `{}` already", element.label.value);
        let problem = Diagnostic::new(Code::NeedlessRefinement, element.label.span, message).label("not needed");
        diagnostics.push(problem.related(param.origin.span, "the definition").help("leave it out"));
    }
    param.label = Some(element.label.value.clone());
    units::check(&element.units, diagnostics);
    if let Some(text) = &element.units {
        param.units = Some(text.value.clone());
    }
    if let Some(text) = &element.enum_ {
        param.enum_ = enums.find(text, diagnostics).or(param.enum_);
    }
    param.origin.span = element.span;
    param.origin.overlays.extend((param.origin.file != file).then_some(file));
}

/// A param that the definition does not list.
fn unsaid(index: u8, file: FileIndex, element: &NamedParam) -> Param {
    Param {
        index,
        label: None,
        units: None,
        enum_: None,
        limits: Limits::default(),
        default: None,
        reserved: false,
        origin: origin(file, element.span, &None, None),
    }
}

/// Reports the labels of overlays that make no name of their own, and drops them. What the definitions call their params is theirs.
fn check_labels(command: &mut ir::Command, named: &HashMap<u8, &Text>, diagnostics: &mut Diagnostics) {
    let problems = (0..command.params.len()).map(|at| label_problem(&command.params, at, named)).collect_vec();
    for (param, problem) in command.params.iter_mut().zip(problems) {
        if let Some(problem) = problem {
            diagnostics.push(problem);
            param.label = None;
        }
    }
}

/// What is wrong with the label that an overlay gives to a param.
fn label_problem(params: &[Param], at: usize, named: &HashMap<u8, &Text>) -> Option<Diagnostic> {
    let text = named.get(&params.get(at)?.index)?;
    let Some(words) = param_words(&text.value) else {
        let message = format!("label `{}` has no letter that a name can have", text.value);
        let problem = Diagnostic::new(Code::OverlayLabel, text.span, message);
        return Some(problem.help("use letters and digits of ASCII"));
    };
    // Of two that the overlay names, the second is told.
    let rivals = params
        .iter()
        .enumerate()
        .filter(|(other, param)| !param.reserved && (*other < at || *other > at && !named.contains_key(&param.index)));
    let of_label = |param: &Param| param.label.as_deref().and_then(param_words).is_some_and(|other| other == words);
    let (_, rival) = rivals.into_iter().find(|(_, param)| of_label(param))?;
    let message = format!("label `{}` is that of param {}", text.value, rival.index);
    let problem = Diagnostic::new(Code::OverlayLabel, text.span, message);
    Some(problem.related(rival.origin.span, "the other one").help("rename one of them"))
}
