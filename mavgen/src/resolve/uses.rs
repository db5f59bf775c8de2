//! Uses: which fields carry which enum, and which bits and bindings of overlays.

use super::enums::Enums;
use super::message::{DraftField, Drafts};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{EnumId, FileIndex, Repr, largest_of_bits};
use crate::read::Loaded;
use crate::source::Span;
use crate::syntax::{self, Text};

/// A field that carries an enum.
pub(super) struct Use<'a> {
    /// The file of the message.
    pub(super) file: FileIndex,
    /// The integer of the field, or of its elements.
    pub(super) repr: Repr,
    pub(super) message: &'a syntax::Message,
    pub(super) field: &'a syntax::Field,
    /// The `enum` attribute.
    pub(super) name: &'a Text,
}

/// Bits or a field that an overlay gives an enum to.
pub(super) struct EnumUse<'a> {
    pub(super) enum_: EnumId,
    /// Where it is named.
    pub(super) name: &'a Text,
    /// What carries it, and where its width or its type stands.
    pub(super) place: (UsePlace, Span),
}

/// What carries an enum.
#[derive(Clone, Copy)]
pub(super) enum UsePlace {
    /// So many bits, 1 to 64.
    Bits(u8),
    /// A field.
    Field(Repr),
}

impl EnumUse<'_> {
    /// The integer that suits it.
    pub(super) fn repr(&self) -> Repr {
        match self.place.0 {
            UsePlace::Bits(width) => Repr::smallest_for(largest_of_bits(width)),
            UsePlace::Field(repr) => repr,
        }
    }
}

/// Reports fields whose enum does not exist, also those of messages that are wrong in other ways.
pub(super) fn check(loaded: &Loaded, enums: &Enums<'_>, diagnostics: &mut Diagnostics) {
    for message in loaded.messages() {
        for field in &message.fields {
            if let Some(name) = named(field).filter(|name| enums.id(&name.value).is_none()) {
                let of = format!(" of `{}.{}`", message.name.value, field.name.value);
                enums.report_unknown(name, Code::UnknownEnum, &of, diagnostics);
            }
        }
    }
}

/// The uses of every enum, in the order of the enums. Fields that cannot carry theirs are reported.
pub(super) fn collect<'a>(drafts: &Drafts<'a>, enums: &Enums<'a>, diagnostics: &mut Diagnostics) -> Vec<Vec<Use<'a>>> {
    let mut uses = enums.list.iter().map(|_| Vec::new()).collect_vec();
    for field in &drafts.lost {
        carried(field, enums, diagnostics);
    }
    for draft in &drafts.messages {
        for field in &draft.fields {
            let Some((name, EnumId(index), repr)) = carried(field, enums, diagnostics) else { continue };
            let one = Use { file: field.origin.file, repr, message: draft.syntax, field: field.syntax, name };
            if let Some(list) = uses.get_mut(index) {
                list.push(one);
            }
        }
    }
    uses
}

/// The enum that a field carries, and the integer that it is in; nothing if it does not exist.
fn carried<'a>(
    field: &DraftField<'a>,
    enums: &Enums<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<(&'a Text, EnumId, Repr)> {
    let name = named(field.syntax)?;
    let id = enums.id(&name.value)?;
    let repr = field.ty.scalar.repr();
    if repr.is_none() {
        let ty = &field.syntax.ty;
        let message = format!("a field of type `{}` cannot carry enum `{}`", ty.value, name.value);
        let problem = Diagnostic::new(Code::EnumOnField, name.span, message).label("ignored");
        diagnostics.push(problem.related(ty.span, "not a plain integer"));
    }
    Some((name, id, repr?))
}

/// The `enum` attribute; pymavlink takes an empty one for none.
pub(super) fn named(field: &syntax::Field) -> Option<&Text> {
    field.enum_.as_ref().filter(|name| !name.value.is_empty())
}
