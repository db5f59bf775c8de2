//! What comments and overlays say of the fields of a message: enums, values that mean "not known", units, former names.

mod carried;

use std::collections::{HashMap, HashSet};

use super::model::{Field, Message, MessageIndex, Package};
use super::syntax::{FieldSyntax, GroupKind, MsgFile};
use super::{invalid, names};
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::ir::Invalid;
use crate::source::Span;
use crate::syntax::Text;
use crate::syntax::uorb_overlay as overlay;

/// Refines the fields of a message that is laid out and not yet in the package.
pub(super) fn apply(
    message: &mut Message,
    file: &MsgFile,
    said: Option<&overlay::Message>,
    package: &mut Package,
    diagnostics: &mut Diagnostics,
) {
    let refined = said.map(|said| of_fields(said, message, diagnostics)).unwrap_or_default();
    let index = MessageIndex(package.messages.len());
    let mut fields = std::mem::take(&mut message.fields);
    let mut scope = Scope { index, message, package, diagnostics, taken: HashSet::new() };
    for (field, syntax) in fields.iter_mut().zip(&file.fields) {
        let said = refined.iter().copied().find(|said| said.name.value == field.name);
        scope.refine(field, said, syntax);
    }
    let taken = scope.taken;
    message.constants.retain(|constant| !taken.contains(&constant.name));
    message.fields = fields;
}

/// What an overlay says of the fields of a message, of each once.
fn of_fields<'o>(
    said: &'o overlay::Message,
    message: &Message,
    diagnostics: &mut Diagnostics,
) -> Vec<&'o overlay::Field> {
    let mut fields: Vec<&overlay::Field> = Vec::new();
    let mut former: HashMap<&str, Span> = HashMap::new();
    let existing = || message.fields.iter().map(|field| (&*field.name, field.span));
    for refinement in &said.fields {
        let name = &refinement.name;
        if !existing().any(|(known, _)| known == name.value) {
            let problem = format!("`{}` has no field `{}`", message.name, name.value);
            let problem = Diagnostic::new(Code::OverlayField, name.span, problem).label("no such field");
            diagnostics.push(problem.meant(nearest(&name.value, existing().map(|(known, _)| known))));
        } else if let Some(first) = fields.iter().find(|first| first.name.value == name.value) {
            let problem = format!("an overlay speaks of field `{}` twice", name.value);
            let problem = Diagnostic::new(Code::DuplicateField, name.span, problem);
            diagnostics.push(problem.related(first.name.span, "the first time"));
        } else {
            fields.push(refinement);
        }
        diagnostics.extend(incomplete(refinement));
        let Some(was) = &refinement.was else { continue };
        let other = existing().find(|(known, _)| *known == was.value).map(|(_, span)| span);
        match other.or_else(|| former.insert(&was.value, was.span)) {
            Some(other) => diagnostics.push(former_name(was, other)),
            None if !names::is_field(&was.value) => diagnostics.push(bad_name(was, "a field")),
            None => {}
        }
    }
    fields
}

/// Says that a refinement is none, or half of one.
fn incomplete(said: &overlay::Field) -> Option<Diagnostic> {
    let overlay::Field { name, enum_, flags, constants, bits, except, units, invalid, was, span } = said;
    let of = &name.value;
    let (message, help) = match (enum_, flags, constants, bits) {
        (Some(_), Some(_), ..) => (format!("field `{of}` gets an enum and flags"), "leave one of them out"),
        (_, _, Some(_), Some(_)) => {
            (format!("constants of `{of}` are values and numbers of bits"), "leave `constants` or `bits` out")
        }
        (Some(_), _, _, Some(_)) => (format!("`{of}` has an enum of bits"), "write `flags`, or `constants`"),
        (Some(_), _, None, _) => (format!("the enum of `{of}` has no constants"), "add `constants=\"PREFIX_*\"`"),
        (_, Some(_), None, None) => (format!("the flags of `{of}` have no constants"), "add `bits=\"PREFIX_*\"`"),
        (None, None, None, None) if except.is_some() => {
            (format!("`except` of `{of}` leaves out of nothing"), "add `enum` and `constants`, or `flags` and `bits`")
        }
        (None, None, Some(_), _) | (None, None, _, Some(_)) => {
            (format!("the constants of `{of}` have no name"), "add `enum=\"NAME\"` or `flags=\"NAME\"`")
        }
        (None, ..) if [flags, units, invalid, was].iter().all(|one| one.is_none()) => {
            (format!("nothing is said of field `{of}`"), "say its enum, flags, units, `invalid`, or what its name was")
        }
        _ => return None,
    };
    Some(Diagnostic::new(Code::UorbRefinement, *span, message).help(help))
}

fn former_name(was: &Text, other: Span) -> Diagnostic {
    let message = format!("`{}` is the name of another field", was.value);
    let problem = Diagnostic::new(Code::UorbFormerName, was.span, message).related(other, "that one");
    problem.help("`was` is a name that only older definitions have")
}

fn bad_name(name: &Text, of: &str) -> Diagnostic {
    let message = format!("`{}` cannot be the name of {of}", name.value);
    Diagnostic::new(Code::BadName, name.span, message).help("names are letters, digits and underscores, a letter first")
}

/// Where the fields of a message are refined.
struct Scope<'p> {
    /// The place of the message in the package, once it is there.
    index: MessageIndex,
    message: &'p Message,
    package: &'p mut Package,
    diagnostics: &'p mut Diagnostics,
    /// The constants that are in enums.
    taken: HashSet<String>,
}

impl Scope<'_> {
    fn refine(&mut self, field: &mut Field, said: Option<&overlay::Field>, syntax: &FieldSyntax) {
        field.enum_ = match said {
            Some(said) if said.enum_.is_some() || said.flags.is_some() => carried::of_overlay(self, said, field),
            _ => carried::of_comment(self, field, syntax),
        };
        field.invalid = match said.and_then(|said| said.invalid.as_ref()) {
            Some(text) => self.invalid_of_overlay(text, field),
            None => self.invalid_of_comment(field, syntax),
        };
        let Some(said) = said else { return };
        if let Some(units) = &said.units {
            field.docs.units = Some(units.value.clone());
        }
        field.was = said.was.as_ref().map(|was| was.value.clone());
    }

    fn invalid_of_overlay(&mut self, text: &Text, field: &Field) -> Option<Invalid> {
        invalid::of_overlay(&text.value, field, &self.message.constants)
            .map_err(|problem| {
                let problem = Diagnostic::new(Code::Sentinel, text.span, problem);
                self.diagnostics.push(problem.related(field.span, "the field"));
            })
            .ok()
    }

    fn invalid_of_comment(&mut self, field: &Field, syntax: &FieldSyntax) -> Option<Invalid> {
        let group = syntax.comment.groups.iter().rev().find(|group| matches!(group.kind, GroupKind::Invalid(_)))?;
        let GroupKind::Invalid(text) = &group.kind else { return None };
        invalid::of_comment(text, field, &self.message.constants).unwrap_or_else(|problem| {
            let problem = Diagnostic::new(Code::Invalid, group.span, problem);
            self.diagnostics.push(problem.help("the field is read as if it were always known"));
            None
        })
    }
}
