//! Uses: which fields carry which enum.

use super::enums::Enums;
use super::message::{Draft, Lost};
use super::suggest::suggest;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{EnumId, FileIndex, Repr};
use crate::read::Loaded;
use crate::syntax::{self, Text};

/// A field that carries an enum.
pub(super) struct Use<'a> {
    /// The file of the message.
    pub(super) file: FileIndex,
    /// The integer of the field, or of its elements.
    pub(super) repr: Repr,
    /// The message.
    pub(super) message: &'a syntax::Message,
    /// The field.
    pub(super) field: &'a syntax::Field,
    /// The `enum` attribute.
    pub(super) name: &'a Text,
}

/// Reports fields whose enum does not exist, also those of messages that are wrong in other ways.
pub(super) fn check(loaded: &Loaded, enums: &Enums<'_>, diagnostics: &mut Diagnostics) {
    if !enums.complete {
        return;
    }
    for message in loaded.files.iter().flat_map(|file| &file.messages) {
        for field in &message.fields {
            let Some(name) = named(field).filter(|name| enums.id(&name.value).is_none()) else { continue };
            let problem = suggest(unknown(message, field, name), &name.value, enums.names(), diagnostics);
            diagnostics.push(problem);
        }
    }
}

/// Reports fields that cannot carry their enums, in messages that cannot be read.
pub(super) fn check_lost(lost: &[Lost<'_>], enums: &Enums<'_>, diagnostics: &mut Diagnostics) {
    for Lost { ty, syntax } in lost {
        let Some(name) = named(syntax).filter(|name| enums.id(&name.value).is_some()) else { continue };
        if ty.scalar.repr().is_none() {
            diagnostics.push(unsuitable(syntax, name));
        }
    }
}

/// The uses of every enum, in the order of the enums.
pub(super) fn collect<'a>(drafts: &[Draft<'a>], enums: &Enums<'a>, diagnostics: &mut Diagnostics) -> Vec<Vec<Use<'a>>> {
    let mut uses = enums.list.iter().map(|_| Vec::new()).collect_vec();
    for draft in drafts {
        for field in &draft.fields {
            let syntax = field.syntax;
            let Some(name) = named(syntax) else { continue };
            let list = enums.id(&name.value).and_then(|EnumId(index)| uses.get_mut(index));
            match (list, field.ty.scalar.repr()) {
                (Some(list), Some(repr)) => {
                    list.push(Use { file: field.origin.file, repr, message: draft.syntax, field: syntax, name });
                }
                (Some(_), None) => diagnostics.push(unsuitable(syntax, name)),
                (None, _) => {}
            }
        }
    }
    uses
}

/// The `enum` attribute; pymavlink takes an empty one for none.
pub(super) fn named(field: &syntax::Field) -> Option<&Text> {
    field.enum_.as_ref().filter(|name| !name.value.is_empty())
}

fn unknown(message: &syntax::Message, field: &syntax::Field, name: &Text) -> Diagnostic {
    let text = format!("enum `{}` of `{}.{}` does not exist", name.value, message.name.value, field.name.value);
    Diagnostic::new(Code::UnknownEnum, name.span, text).label("no such enum")
}

fn unsuitable(field: &syntax::Field, name: &Text) -> Diagnostic {
    let message = format!("a field of type `{}` cannot carry enum `{}`", field.ty.value, name.value);
    let problem = Diagnostic::new(Code::EnumOnField, name.span, message).label("ignored");
    problem.related(field.ty.span, "not a plain integer")
}
