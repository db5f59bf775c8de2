//! Commands: what an entry of `MAV_CMD` says beyond its value, and what overlays say of it where the definitions say nothing.

use std::collections::HashMap;

use super::super::boolean::{self, Attribute};
use super::super::enums::{Enums, Merged, ValuedEntry};
use super::super::origin::{non_empty, origin};
use super::super::{number, suggest, units};
use super::Build;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Command, EnumId, FileIndex, Limits, Origin, PARAMS, Param, Scalar, param_words};
use crate::order;
use crate::read::Loaded;
use crate::syntax::{self, Text, overlay};

/// The enum of the commands.
const COMMANDS: &str = "MAV_CMD";

/// Two of the params are integers in some messages.
const INTEGER_PARAMS: [u8; 2] = [5, 6];

/// What overlays say of commands, by entry.
pub(in crate::resolve) struct Commands<'a> {
    said: HashMap<&'a str, Vec<(FileIndex, &'a overlay::Command)>>,
}

impl<'a> Commands<'a> {
    /// Reads the commands of all overlays. One that does not exist is reported.
    pub(in crate::resolve) fn of(loaded: &'a Loaded, enums: &Enums<'a>, diagnostics: &mut Diagnostics) -> Self {
        let mut said: HashMap<&'a str, Vec<_>> = HashMap::new();
        let known = enums.id(COMMANDS).and_then(|id| enums.get(id));
        for (file, overlay) in loaded.numbered_overlays() {
            for command in &overlay.commands {
                let name = &command.name;
                said.entry(&name.value).or_default().push((file, command));
                let entries = || known.into_iter().flat_map(Merged::entry_names);
                if enums.complete && !entries().any(|entry| entry == name.value) {
                    let message = format!("`{COMMANDS}` has no command `{}`", name.value);
                    let problem = Diagnostic::new(Code::OverlayCommand, name.span, message).label("no such command");
                    suggest::report(problem, &name.value, &mut entries(), diagnostics);
                }
            }
        }
        Self { said }
    }
}

impl Build<'_, '_> {
    /// What an entry of the enum of that name says as a command, also in overlays, which are added to its origin.
    pub(super) fn command(&mut self, enum_: &str, entry: &ValuedEntry<'_>, origin: &mut Origin) -> Option<Command> {
        let mut command = self.defined(enum_, entry);
        let said = self.commands.said.get(entry.syntax.name.value.as_str());
        if let Some(said) = said.filter(|_| enum_ == COMMANDS) {
            self.refine(said, command.get_or_insert_default(), origin);
        }
        command
    }

    /// What the definitions say.
    ///
    /// Enums of commands are known by their name, as pymavlink does it; in others, by what the entry has.
    fn defined(&mut self, enum_: &str, entry: &ValuedEntry<'_>) -> Option<Command> {
        let syntax = entry.syntax;
        let flags = [&syntax.has_location, &syntax.is_destination, &syntax.mission_only];
        let says_something = !syntax.params.is_empty() || flags.iter().any(|flag| flag.is_some());
        if !enum_.contains(COMMANDS) && !says_something {
            return None;
        }
        let [location, destination, only] = flags;
        let has_location = boolean::read(location, Attribute::OnlyWords("hasLocation"), self.diagnostics);
        let is_destination = boolean::read(destination, Attribute::Unread("isDestination"), self.diagnostics);
        let mission_only = boolean::read(only, Attribute::Unread("missionOnly"), self.diagnostics);
        let mut params: Vec<(&Text, Param)> = Vec::new();
        for element in &syntax.params {
            let Some(index) = self.index(&element.index, Code::ParamIndex, "the param is left out") else { continue };
            let param = self.param(index, element, entry.file);
            match params.iter_mut().find(|(_, known)| known.index == index) {
                Some(known) => {
                    self.diagnostics.push(twice(index, &element.index, known.0));
                    *known = (&element.index, param);
                }
                None => params.push((&element.index, param)),
            }
        }
        order::sort_by_key(&mut params, |(_, param)| param.index);
        let params = params.into_iter().map(|(_, param)| param).collect_vec();
        Some(Command { params, has_location, is_destination, mission_only })
    }

    fn index(&mut self, text: &Text, code: Code, label: &str) -> Option<u8> {
        let index = number::count(&text.value).and_then(|index| u8::try_from(index).ok());
        let index = index.filter(|index| PARAMS.contains(index));
        if index.is_none() {
            let message = format!("param index `{}` is not a number from 1 to {}", text.value, PARAMS.end());
            let problem = Diagnostic::new(code, text.span, message).label(label);
            self.diagnostics.push(problem.help("`COMMAND_LONG` and `COMMAND_INT` carry seven"));
        }
        index
    }

    fn param(&mut self, index: u8, element: &syntax::Param, file: FileIndex) -> Param {
        units::check(&element.units, self.diagnostics);
        let ranges = [&element.min, &element.max, &element.increment];
        Param {
            index,
            label: non_empty(&element.label),
            units: non_empty(&element.units),
            enum_: element.enum_.as_ref().and_then(|name| self.param_enum(name)),
            limits: number::limits(ranges, is_float, self.diagnostics),
            default: element.default.as_ref().and_then(|text| default(index, text, self.diagnostics)),
            reserved: boolean::read(&element.reserved, Attribute::AnyText("reserved"), self.diagnostics),
            origin: origin(file, element.span, &element.description, None),
        }
    }

    fn param_enum(&mut self, name: &Text) -> Option<EnumId> {
        let id = self.enums.id(&name.value);
        if id.is_none() && !name.value.is_empty() {
            self.enums.report_unknown(name, Code::ParamEnum, " of a param", self.diagnostics);
        }
        id
    }

    /// Adds what overlays say. Each names a param once.
    fn refine(&mut self, said: &[(FileIndex, &overlay::Command)], command: &mut Command, origin: &mut Origin) {
        let mut named: HashMap<u8, &Text> = HashMap::new();
        for (file, element) in said {
            origin.overlays.extend((!origin.overlays.contains(file)).then_some(*file));
            for (text, flag) in [
                (&element.has_location, &mut command.has_location),
                (&element.is_destination, &mut command.is_destination),
            ] {
                *flag = boolean::of_overlay(text, self.diagnostics).unwrap_or(*flag);
            }
            for param in &element.params {
                let Some(index) = self.index(&param.index, Code::OverlayParam, "") else { continue };
                if let Some(first) = named.insert(index, &param.label) {
                    let message = format!("param {index} is named twice");
                    let problem = Diagnostic::new(Code::OverlayParam, param.index.span, message);
                    let problem = problem.related(first.span, "the first time");
                    self.diagnostics.push(problem.help("leave one of them out"));
                } else {
                    self.name(command, index, *file, param);
                }
            }
        }
        self.check_labels(command, &named);
    }

    fn name(&mut self, command: &mut Command, index: u8, file: FileIndex, element: &overlay::NamedParam) {
        let place = command.params.partition_point(|param| param.index < index);
        if command.params.get(place).is_none_or(|param| param.index != index) {
            command.params.insert(place, unsaid(index, origin(file, element.span, &None, None)));
        }
        let Some(param) = command.params.get_mut(place) else { return };
        if param.reserved {
            let message = format!("param {index} is reserved: it is sent as its default");
            let problem = Diagnostic::new(Code::OverlayParam, element.index.span, message);
            self.diagnostics.push(problem.related(param.origin.span, "the definition").help("leave it out"));
            return;
        }
        let label = &element.label;
        if param.label.as_deref() == Some(&label.value) {
            let message = format!("param {index} is `{}` already", label.value);
            let problem = Diagnostic::new(Code::NeedlessRefinement, label.span, message).label("not needed");
            self.diagnostics.push(problem.related(param.origin.span, "the definition").help("leave it out"));
        }
        param.label = Some(label.value.clone());
        units::check(&element.units, self.diagnostics);
        if let Some(text) = &element.units {
            param.units = Some(text.value.clone());
        }
        if let Some(text) = &element.enum_ {
            param.enum_ = self.enums.find(text, self.diagnostics).or(param.enum_);
        }
        param.origin.span = element.span;
        param.origin.overlays.extend((param.origin.file != file).then_some(file));
    }

    /// Reports the labels of overlays that make no name of their own, and drops them. What the definitions call their params is theirs.
    fn check_labels(&mut self, command: &mut Command, named: &HashMap<u8, &Text>) {
        let problems = (0..command.params.len()).map(|at| label_problem(&command.params, at, named)).collect_vec();
        for (param, problem) in command.params.iter_mut().zip(problems) {
            if let Some(problem) = problem {
                self.diagnostics.push(problem);
                param.label = None;
            }
        }
    }
}

/// Says that of two params the last is taken, as pymavlink does it.
fn twice(index: u8, element: &Text, first: &Text) -> Diagnostic {
    let message = format!("param {index} stands twice");
    let problem = Diagnostic::new(Code::ParamIndex, element.span, message).label("this one counts");
    problem.related(first.span, "the first one").help("commands carry each param once: number them from 1 to 7")
}

/// Whether a `float` holds it, as commands carry their params.
fn is_float(value: f64) -> bool {
    Scalar::F32.holds_float(value)
}

/// A number, or NaN. `COMMAND_INT` and `MISSION_ITEM_INT` carry the params 5 and 6 as integers, which are never NaN.
fn default(index: u8, text: &Text, diagnostics: &mut Diagnostics) -> Option<f64> {
    let value = number::float(&text.value).filter(|value| value.is_nan() || is_float(*value));
    if value.is_none() {
        let why = number::why_not(text, "is neither a finite number nor NaN");
        let message = format!("default `{}` {why}", text.value);
        diagnostics.push(Diagnostic::new(Code::DocumentedNumber, text.span, message).label("left out"));
    }
    if value.is_some_and(f64::is_nan) && INTEGER_PARAMS.contains(&index) {
        let message = format!("param {index} has the default NaN, which `COMMAND_INT` cannot carry");
        let problem = Diagnostic::new(Code::ParamDefault, text.span, message).label("an `int32_t` there");
        diagnostics.push(problem.help("leave it out, or give a number"));
    }
    value
}

/// A param that the definition does not list.
fn unsaid(index: u8, origin: Origin) -> Param {
    let (label, units, enum_, limits, default) = (None, None, None, Limits::default(), None);
    Param { index, label, units, enum_, limits, default, reserved: false, origin }
}

/// What is wrong with the label that an overlay gives to a param.
fn label_problem(params: &[Param], at: usize, named: &HashMap<u8, &Text>) -> Option<Diagnostic> {
    let text = named.get(&params.get(at)?.index)?;
    let problem = |message| Diagnostic::new(Code::OverlayLabel, text.span, message);
    let Some(words) = param_words(&text.value) else {
        let problem = problem(format!("label `{}` has no letter that a name can have", text.value));
        return Some(problem.help("use letters and digits of ASCII"));
    };
    // Of two that the overlay names, the second is told.
    let (_, rival) = params.iter().enumerate().find(|(other, param)| {
        let is_older = *other < at || *other > at && !named.contains_key(&param.index);
        let other_words = param.label.as_deref().and_then(param_words);
        !param.reserved && is_older && other_words.is_some_and(|other| other == words)
    })?;
    let problem = problem(format!("label `{}` is that of param {}", text.value, rival.index));
    Some(problem.related(rival.origin.span, "the other one").help("rename one of them"))
}
