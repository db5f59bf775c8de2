//! What the overlay's words about a message can refer to: its fields, and the enums.

use super::super::invalid::Entries;
use super::super::merge::Enums;
use super::super::message::Draft;
use super::super::suggest::suggest;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{self, EnumId, FieldIndex, FileIndex};
use crate::syntax::{self, Text};

/// A message that an overlay speaks of.
pub(in crate::resolve) struct Scene<'s, 'a> {
    /// The overlay.
    pub(in crate::resolve) file: FileIndex,
    /// Whether nothing was lost in reading the overlay: only then is what is missing there a mistake.
    pub(in crate::resolve) whole: bool,
    /// The message.
    pub(in crate::resolve) draft: &'s Draft<'a>,
    /// All enums.
    pub(in crate::resolve) enums: &'s Enums<'a>,
    /// Their entries.
    pub(in crate::resolve) entries: &'s Entries<'a>,
}

/// A field that an overlay names.
#[derive(Clone, Copy)]
pub(in crate::resolve) struct Found<'s> {
    /// Its place in the message.
    pub(in crate::resolve) index: FieldIndex,
    /// The field.
    pub(in crate::resolve) field: &'s ir::Field,
    /// Where it is defined.
    pub(in crate::resolve) syntax: &'s syntax::Field,
}

impl<'s, 'a: 's> Scene<'s, 'a> {
    /// The name of the message.
    pub(in crate::resolve) fn name(&self) -> &'a str {
        &self.draft.syntax.name.value
    }

    /// The field of that name, as the XML spells it. One that may have been lost in reading is not reported.
    pub(in crate::resolve) fn field(&self, name: &Text, diagnostics: &mut Diagnostics) -> Option<Found<'s>> {
        let mut fields = self.draft.fields().enumerate();
        let found = fields.find(|(_, (_, syntax))| syntax.name.value == name.value);
        if let Some((index, (field, syntax))) = found {
            return Some(Found { index: FieldIndex(index), field, syntax });
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
    pub(in crate::resolve) fn values(&self, name: &Text, diagnostics: &mut Diagnostics) -> Option<EnumId> {
        let id = self.enums.id(&name.value);
        if id.is_none() && self.enums.complete {
            let message = format!("enum `{}` does not exist", name.value);
            let problem = Diagnostic::new(Code::OverlayEnum, name.span, message).label("no such enum");
            let problem = suggest(problem, &name.value, self.enums.names(), diagnostics);
            diagnostics.push(problem);
        }
        id
    }

    /// The enum whose values a field carries, as the definitions say.
    pub(in crate::resolve) fn values_of(&self, field: &syntax::Field) -> Option<EnumId> {
        field.values.as_ref().and_then(|name| self.enums.id(&name.value))
    }

    /// The value of an entry of an enum.
    pub(in crate::resolve) fn entry(&self, values: EnumId, name: &str) -> Option<u64> {
        let mut entries = self.enums.list.get(values.0)?.entries.iter();
        let entry = entries.find(|entry| entry.syntax.name.value == name)?;
        u64::try_from(entry.value).ok()
    }

    /// The names of the entries of an enum.
    pub(in crate::resolve) fn entry_names(&self, values: EnumId) -> impl Iterator<Item = &'a str> {
        let list = self.enums.list.get(values.0).map(|merged| merged.entries.as_slice());
        list.unwrap_or_default().iter().map(|entry| entry.syntax.name.value.as_str())
    }
}
