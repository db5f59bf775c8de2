//! What the overlay's words about a message can refer to: its fields, and the enums.

mod condition;
mod enum_use;
mod list;

use super::enums::Enums;
use super::field::DraftField;
use super::invalid::Entries;
use super::message::Draft;
use super::suggest::suggest;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{EnumId, FieldIndex, FileIndex};
use crate::syntax::{self, Text};

pub(super) use condition::resolve as condition;
pub(super) use enum_use::{EnumUse, UsePlace, check as check_enum_uses};
pub(super) use list::parts;

/// A message that an overlay speaks of.
pub(super) struct MessageScope<'s, 'a> {
    /// The overlay.
    pub(super) file: FileIndex,
    /// Whether nothing was lost in reading the overlay: only then is what is missing there a mistake.
    pub(super) whole: bool,
    /// The message.
    pub(super) draft: &'s Draft<'a>,
    /// All enums.
    pub(super) enums: &'s Enums<'a>,
    /// Their entries.
    pub(super) entries: &'s Entries<'a>,
}

/// A field that an overlay names.
#[derive(Clone, Copy)]
pub(super) struct Found<'s> {
    /// Its place in the message.
    pub(super) index: FieldIndex,
    /// The field.
    pub(super) field: &'s DraftField<'s>,
    /// Where it is defined.
    pub(super) syntax: &'s syntax::Field,
}

impl<'s, 'a: 's> MessageScope<'s, 'a> {
    /// The name of the message.
    pub(super) fn name(&self) -> &'a str {
        &self.draft.syntax.name.value
    }

    /// The field of that name, as the XML spells it. One that may have been lost in reading is not reported.
    pub(super) fn field(&self, name: &Text, diagnostics: &mut Diagnostics) -> Option<Found<'s>> {
        let mut fields = self.draft.fields.iter().enumerate();
        if let Some((index, field)) = fields.find(|(_, field)| field.syntax.name.value == name.value) {
            return Some(Found { index: FieldIndex(index), field, syntax: field.syntax });
        }
        if !self.enums.complete {
            return None;
        }
        let message = format!("message `{}` has no field `{}`", self.name(), name.value);
        let problem = Diagnostic::new(Code::OverlayField, name.span, message).label("no such field");
        let problem = problem.related(self.draft.syntax.name.span, "the message");
        let names = self.draft.syntax.fields.iter().map(|field| field.name.value.as_str());
        let problem = suggest(problem, &name.value, names, diagnostics);
        diagnostics.push(problem);
        None
    }

    /// The enum of that name; the same goes for it.
    pub(super) fn enum_(&self, name: &Text, diagnostics: &mut Diagnostics) -> Option<EnumId> {
        let id = self.enums.id(&name.value);
        if id.is_none() && self.enums.complete {
            let message = format!("enum `{}` does not exist", name.value);
            let problem = Diagnostic::new(Code::OverlayEnum, name.span, message).label("no such enum");
            let problem = suggest(problem, &name.value, self.enums.names(), diagnostics);
            diagnostics.push(problem);
        }
        id
    }

    /// The enum that a field carries, as the definitions say.
    pub(super) fn enum_of(&self, field: &syntax::Field) -> Option<EnumId> {
        field.enum_.as_ref().and_then(|name| self.enums.id(&name.value))
    }

    /// The value of an entry of an enum.
    pub(super) fn entry(&self, enum_: EnumId, name: &str) -> Option<u64> {
        let mut entries = self.enums.list.get(enum_.0)?.entries.iter();
        let entry = entries.find(|entry| entry.syntax.name.value == name)?;
        u64::try_from(entry.value).ok()
    }

    /// The names of the entries of an enum, if there is one.
    pub(super) fn entry_names(&self, enum_: Option<EnumId>) -> impl Iterator<Item = &'a str> {
        let merged = enum_.and_then(|enum_| self.enums.list.get(enum_.0));
        merged.map_or(&[][..], |merged| &merged.entries).iter().map(|entry| entry.syntax.name.value.as_str())
    }
}
