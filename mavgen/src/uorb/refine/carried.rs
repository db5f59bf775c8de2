//! The enum that a field carries: by `[@enum P]`, or as an overlay says.

use super::super::enums::{self, Claim, NameTaken};
use super::super::model::{Constant, Element, EnumIndex, Field, Message};
use super::super::syntax::{FieldSyntax, GroupKind};
use super::{Scope, bad_name};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::ir::{Name, Repr};
use crate::source::{Part, Span};
use crate::syntax::Text;
use crate::syntax::uorb_overlay as overlay;

/// Constants, each with the beginning of its name that entries do not have.
type Constants<'m> = Vec<(&'m Constant, &'m str)>;

/// The enum that a comment gives to a field. What is wrong with it leaves the field a number.
pub(super) fn of_comment(scope: &mut Scope<'_>, field: &Field, syntax: &FieldSyntax) -> Option<EnumIndex> {
    let mut first: Option<(&str, Span)> = None;
    let mut stems: Vec<Option<&str>> = vec![None; scope.message.constants.len()];
    let mut problem = |span, message| scope.diagnostics.push(Diagnostic::new(Code::UorbEnum, span, message));
    for group in &syntax.comment.groups {
        let GroupKind::Enum(prefixes) = &group.kind else { continue };
        for prefix in prefixes {
            let mut is_new = false;
            for (stem, constant) in stems.iter_mut().zip(&scope.message.constants).filter(|(stem, _)| stem.is_none()) {
                let has_prefix = constant.name.strip_prefix(prefix.as_str()).is_some_and(|rest| rest.starts_with('_'));
                *stem = constant.name.get(..=prefix.len()).filter(|_| has_prefix);
                is_new |= has_prefix;
            }
            match is_new {
                true => first = first.or(Some((prefix, group.span))),
                false => problem(group.span, format!("no constant of this file begins with `{prefix}_`")),
            }
        }
    }
    let (prefix, span) = first?;
    let Some(repr) = carrier(field) else {
        problem(span, format!("`{}` is {}, which cannot carry an enum", field.name, type_of(field)));
        return None;
    };
    let name = Name { text: enums::name_of(&scope.message.name, prefix), span };
    let constants = with_stems(scope.message, stems);
    let mut claim = Claim { name, flags: false, bits: false, repr, constants };
    for (constant, _) in claim.constants.iter().filter(|(constant, _)| claim.value(constant).is_none()) {
        problem(span, format!("`{}` is {}, which `{}` cannot hold", constant.name, constant.value, field.name));
    }
    claim.constants = claim.constants.iter().copied().filter(|(one, _)| claim.value(one).is_some()).collect_vec();
    add(scope, claim).map_err(|taken| scope.diagnostics.push(taken.as_warning(span, field))).ok()
}

/// The enum or flags that an overlay gives to a field.
pub(super) fn of_overlay(scope: &mut Scope<'_>, said: &overlay::Field, field: &Field) -> Option<EnumIndex> {
    let name = said.enum_.as_ref().or(said.flags.as_ref())?;
    let patterns = said.constants.as_ref().or(said.bits.as_ref())?;
    let (flags, bits) = (said.flags.is_some(), said.bits.is_some());
    if Name::fault(&name.value).is_some() || !name.value.starts_with(|first: char| first.is_ascii_uppercase()) {
        scope.diagnostics.push(bad_name(name, "an enum").help("write it as a type: `EscFailures`"));
    }
    let mut constants = matching(scope.message, patterns, scope.diagnostics);
    leave_out(scope.message, said.except.as_ref(), &mut constants, scope.diagnostics);
    let Some(repr) = carrier(field).filter(|repr| !flags || !repr.is_signed()) else {
        scope.diagnostics.push(unsuitable(name, field, flags));
        return None;
    };
    let claim = Claim { name: Name { text: name.value.clone(), span: name.span }, flags, bits, repr, constants };
    let beyond: Vec<&Constant> =
        claim.constants.iter().map(|(one, _)| *one).filter(|one| claim.value(one).is_none()).collect_vec();
    if !beyond.is_empty() {
        let problems = beyond.into_iter().map(|constant| self::beyond(bits, constant, field, patterns.span));
        scope.diagnostics.extend(problems);
        return None;
    }
    add(scope, claim).map_err(|taken| scope.diagnostics.push(taken.as_error(name))).ok()
}

/// Puts an enum into the package, and takes its constants.
fn add(scope: &mut Scope<'_>, claim: Claim<'_>) -> Result<EnumIndex, NameTaken> {
    let names = claim.constants.iter().map(|(constant, _)| constant.name.clone()).collect_vec();
    let index = enums::add(claim.into_enum(scope.index), &mut scope.package.enums)?;
    scope.taken.extend(names);
    Ok(index)
}

impl NameTaken {
    fn as_warning(&self, span: Span, field: &Field) -> Diagnostic {
        let message = match self.type_alone {
            true => format!("`{}` is {}, and another field of these constants is not", field.name, type_of(field)),
            false => format!("`{}` would carry an enum of the name of another", field.name),
        };
        let problem = Diagnostic::new(Code::UorbEnum, span, message).related(self.first, "the other one");
        problem.help("this field stays a number; an overlay can name its enum")
    }

    fn as_error(&self, name: &Text) -> Diagnostic {
        let message = match self.type_alone {
            true => format!("`{}` is of another type here", name.value),
            false => format!("`{}` has other constants here", name.value),
        };
        Diagnostic::new(Code::UorbEnumTwice, name.span, message)
            .related(self.first, "the first one")
            .help("give each a name of its own")
    }
}

/// The constants that `NAME` and `PREFIX_*` mean, in the order of the file.
fn matching<'m>(message: &'m Message, patterns: &'m Text, diagnostics: &mut Diagnostics) -> Constants<'m> {
    let mut stems: Vec<Option<&str>> = vec![None; message.constants.len()];
    for pattern in patterns.part().words() {
        let mut is_meant = false;
        for (stem, Constant { name, .. }) in stems.iter_mut().zip(&message.constants) {
            let found = match pattern.text.strip_suffix('*') {
                Some(stem) => name.starts_with(stem).then_some(stem),
                None => (name == pattern.text).then_some(""),
            };
            is_meant |= found.is_some();
            *stem = stem.or(found);
        }
        if !is_meant {
            diagnostics.push(missing(pattern, message));
        }
    }
    with_stems(message, stems)
}

/// The constants that have a stem, with it.
fn with_stems<'m>(message: &'m Message, stems: Vec<Option<&'m str>>) -> Constants<'m> {
    message.constants.iter().zip(stems).filter_map(|(constant, stem)| Some((constant, stem?))).collect_vec()
}

fn leave_out(message: &Message, except: Option<&Text>, from: &mut Constants<'_>, diagnostics: &mut Diagnostics) {
    for name in except.into_iter().flat_map(|except| except.part().words()) {
        let before = from.len();
        from.retain(|(constant, _)| constant.name != name.text);
        if from.len() == before {
            diagnostics.push(missing(name, message));
        }
    }
}

fn missing(pattern: Part<'_>, message: &Message) -> Diagnostic {
    let name = &message.name;
    let text = match pattern.text.strip_suffix('*') {
        Some(stem) => format!("no constant of `{name}` begins with `{stem}`"),
        None => format!("`{}` is none of the constants of `{name}` that are meant", pattern.text),
    };
    let names = message.constants.iter().map(|constant| constant.name.as_str());
    Diagnostic::new(Code::UorbConstants, pattern.span(), text).meant(nearest(pattern.text, names))
}

/// The type of the values that a field can have names for.
fn carrier(field: &Field) -> Option<Repr> {
    field.element.scalar()?.repr()
}

fn type_of(field: &Field) -> String {
    match field.element {
        Element::Scalar(scalar) => format!("`{}`", scalar.name()),
        Element::Message(_) => "a message".to_owned(),
    }
}

fn unsuitable(name: &Text, field: &Field, flags: bool) -> Diagnostic {
    let (what, wanted) = if flags { ("flags", "an unsigned integer") } else { ("an enum", "an integer") };
    let message = format!("`{}` is {}, which cannot carry {what}", field.name, type_of(field));
    let problem = Diagnostic::new(Code::UorbCarrier, name.span, message).related(field.span, "the field");
    problem.help(format!("{what} can be on {wanted}, or an array of them"))
}

fn beyond(bits: bool, constant: &Constant, field: &Field, patterns: Span) -> Diagnostic {
    let (name, value) = (&constant.name, constant.value);
    let message = match bits {
        true => format!("`{name}` is bit {value}, which a field that is {} does not have", type_of(field)),
        false => format!("`{name}` is {value}, which a field that is {} cannot hold", type_of(field)),
    };
    let problem = Diagnostic::new(Code::UorbCarrier, patterns, message).related(constant.span, "the constant");
    problem.help(format!("leave it out: `except=\"{name}\"`"))
}
