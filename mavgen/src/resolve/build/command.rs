//! Commands: what an entry of `MAV_CMD` says beyond its value.

use super::super::boolean::{self, Attribute};
use super::super::enums::{Enums, ValuedEntry};
use super::super::origin::{non_empty, origin};
use super::super::{limits, number, units};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Command, EnumId, FileIndex, Param};
use crate::order;
use crate::syntax::{self, Text};

/// Commands carry so many params.
const PARAMS: u8 = 7;

/// Two of them are integers in some messages.
const INTEGER_PARAMS: [u8; 2] = [5, 6];

/// What an entry of the enum of that name says as a command.
///
/// Enums of commands are known by their name, as pymavlink does it; in others, by what the entry has.
pub(super) fn resolve(
    enum_name: &str,
    entry: &ValuedEntry<'_>,
    enums: &Enums<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Command> {
    let syntax = entry.syntax;
    let flags = [&syntax.has_location, &syntax.is_destination, &syntax.mission_only];
    let says_something = !syntax.params.is_empty() || flags.iter().any(|flag| flag.is_some());
    if !enum_name.contains("MAV_CMD") && !says_something {
        return None;
    }
    let location = Attribute::OnlyWords("hasLocation");
    let has_location = boolean::read(&syntax.has_location, location, diagnostics);
    let is_destination = boolean::read(&syntax.is_destination, Attribute::Unread("isDestination"), diagnostics);
    let mission_only = boolean::read(&syntax.mission_only, Attribute::Unread("missionOnly"), diagnostics);
    let mut params: Vec<(&Text, Param)> = Vec::new();
    for element in &syntax.params {
        let Some(index) = index(&element.index, diagnostics) else { continue };
        let param = param(index, element, entry.file, enums, diagnostics);
        match params.iter_mut().find(|(_, known)| known.index == index) {
            Some(known) => {
                diagnostics.push(twice(index, &element.index, known.0));
                *known = (&element.index, param);
            }
            None => params.push((&element.index, param)),
        }
    }
    order::sort_by_key(&mut params, |(_, param)| param.index);
    let params = params.into_iter().map(|(_, param)| param).collect_vec();
    Some(Command { params, has_location, is_destination, mission_only })
}

/// Says that of two params the last is taken, as pymavlink does it.
fn twice(index: u8, element: &Text, first: &Text) -> Diagnostic {
    let message = format!("param {index} stands twice");
    let problem = Diagnostic::new(Code::ParamIndex, element.span, message).label("this one counts");
    problem.related(first.span, "the first one").help("commands carry each param once: number them from 1 to 7")
}

fn param(
    index: u8,
    element: &syntax::Param,
    file: FileIndex,
    enums: &Enums<'_>,
    diagnostics: &mut Diagnostics,
) -> Param {
    units::check(&element.units, diagnostics);
    let ranges = [&element.min, &element.max, &element.increment];
    Param {
        index,
        label: non_empty(&element.label),
        units: non_empty(&element.units),
        enum_: element.enum_.as_ref().and_then(|name| enum_id(name, enums, diagnostics)),
        limits: limits::resolve(ranges, is_float, diagnostics),
        default: element.default.as_ref().and_then(|text| default(index, text, diagnostics)),
        reserved: boolean::read(&element.reserved, Attribute::AnyText("reserved"), diagnostics),
        origin: origin(file, element.span, &element.description, None),
    }
}

fn enum_id(name: &Text, enums: &Enums<'_>, diagnostics: &mut Diagnostics) -> Option<EnumId> {
    let id = enums.id(&name.value);
    if id.is_none() && !name.value.is_empty() {
        enums.report_unknown(name, Code::ParamEnum, " of a param", diagnostics);
    }
    id
}

fn index(text: &Text, diagnostics: &mut Diagnostics) -> Option<u8> {
    let index = number::count(&text.value).and_then(|index| u8::try_from(index).ok());
    let index = index.filter(|index| (1..=PARAMS).contains(index));
    if index.is_none() {
        let message = format!("param index `{}` is not a number from 1 to {PARAMS}", text.value);
        let problem = Diagnostic::new(Code::ParamIndex, text.span, message).label("the param is left out");
        diagnostics.push(problem.help("`COMMAND_LONG` and `COMMAND_INT` carry seven"));
    }
    index
}

/// Whether a `float` holds it, as commands carry their params.
fn is_float(value: f64) -> bool {
    (value as f32).is_finite()
}

/// A number, or NaN. `COMMAND_INT` and `MISSION_ITEM_INT` carry the params 5 and 6 as integers, which are never NaN.
fn default(index: u8, text: &Text, diagnostics: &mut Diagnostics) -> Option<f64> {
    let value = number::float(&text.value).filter(|value| value.is_nan() || is_float(*value));
    if value.is_none() {
        let why = limits::why_not(text, "is neither a finite number nor NaN");
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
