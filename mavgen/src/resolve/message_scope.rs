//! What the overlay's words about a message can refer to: its fields, and the enums.

mod condition;
mod enum_use;

use super::enums::Enums;
use super::field::DraftField;
use super::invalid::Entries;
use super::message::Draft;
use super::suggest;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{EnumId, FieldIndex, FileIndex, Repr};
use crate::source::Span;
use crate::syntax::{self, Text};

pub(super) use condition::resolve as condition;
pub(super) use enum_use::{EnumUse, UsePlace, check as check_enum_uses};

/// A message that an overlay speaks of, and what is found in reading what it says.
pub(super) struct MessageScope<'s, 'a> {
    /// The overlay.
    pub(super) file: FileIndex,
    /// Whether nothing was lost in reading the overlay: only then is what is missing there a mistake.
    pub(super) whole: bool,
    pub(super) draft: &'s Draft<'a>,
    pub(super) enums: &'s Enums<'a>,
    pub(super) entries: &'s Entries<'a>,
    pub(super) enum_uses: &'s mut Vec<EnumUse<'a>>,
    pub(super) diagnostics: &'s mut Diagnostics,
}

/// A field that an overlay names.
#[derive(Clone, Copy)]
pub(super) struct Found<'s> {
    pub(super) index: FieldIndex,
    pub(super) field: &'s DraftField<'s>,
    pub(super) syntax: &'s syntax::Field,
}

impl Found<'_> {
    /// The integer that it is, if it is a scalar.
    pub(super) fn scalar_repr(&self) -> Option<Repr> {
        self.field.ty.scalar.repr().filter(|_| self.field.ty.array.is_none())
    }
}

impl<'s, 'a: 's> MessageScope<'s, 'a> {
    pub(super) fn report(&mut self, problem: Diagnostic) {
        self.diagnostics.push(problem);
    }

    /// The name of the message.
    pub(super) fn name(&self) -> &'a str {
        &self.draft.syntax.name.value
    }

    /// The field of that name, as the XML spells it. One that may have been lost in reading is not reported.
    pub(super) fn field(&mut self, name: &Text) -> Option<Found<'s>> {
        let mut fields = self.draft.fields.iter().enumerate();
        if let Some((index, field)) = fields.find(|(_, field)| field.syntax.name.value == name.value) {
            return Some(Found { index: FieldIndex(index), field, syntax: field.syntax });
        }
        if self.enums.complete {
            let message = format!("message `{}` has no field `{}`", self.name(), name.value);
            let problem = Diagnostic::new(Code::OverlayField, name.span, message).label("no such field");
            let problem = problem.related(self.draft.syntax.name.span, "the message");
            let mut names = self.draft.syntax.fields.iter().map(|field| field.name.value.as_str());
            suggest::report(problem, &name.value, &mut names, self.diagnostics);
        }
        None
    }

    /// Reports a field that cannot be what it is named for, because of its type: `which` says so.
    pub(super) fn report_type(&mut self, code: Code, at: Span, found: Found<'_>, (which, help): (&str, &str)) {
        let (ty, field) = (&found.syntax.ty, &found.syntax.name.value);
        let message = format!("`{}.{field}` is `{}`, which {which}", self.name(), ty.value);
        self.report(Diagnostic::new(code, at, message).related(ty.span, "the field").help(help));
    }

    /// The enum that a field carries, as the definitions say.
    pub(super) fn enum_of(&self, field: &syntax::Field) -> Option<EnumId> {
        field.enum_.as_ref().and_then(|name| self.enums.id(&name.value))
    }

    /// The value of an entry of an enum.
    pub(super) fn entry(&self, enum_: EnumId, name: &str) -> Option<u64> {
        let mut entries = self.enums.get(enum_)?.entries.iter();
        let entry = entries.find(|entry| entry.syntax.name.value == name)?;
        u64::try_from(entry.value).ok()
    }

    /// Reports what is no value, with the entry of the enum that may have been meant.
    pub(super) fn report_value(&mut self, problem: Diagnostic, value: &str, enum_: Option<EnumId>) {
        let merged = enum_.and_then(|enum_| self.enums.get(enum_));
        let mut names = merged.into_iter().flat_map(|merged| merged.entry_names());
        suggest::report(problem, value, &mut names, self.diagnostics);
    }
}
