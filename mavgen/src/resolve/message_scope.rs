//! What the overlay's words about a message can refer to: its fields, and the enums; and what every one of them can have: a
//! condition, `if="autopilot" is="MAV_AUTOPILOT_AUTOQUAD"`.

use super::enums::Enums;
use super::invalid::Entries;
use super::message::{Draft, DraftField};
use super::uses::EnumUse;
use super::{number, suggest};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Condition, EnumId, FieldIndex, FileIndex, Repr};
use crate::source::Span;
use crate::syntax::{self, Text, overlay};

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

    /// Reports what leaves nothing to go on with.
    pub(super) fn refuse<T>(&mut self, problem: Diagnostic) -> Option<T> {
        self.diagnostics.refuse(problem)
    }

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
    pub(super) fn refuse_type<T>(
        &mut self,
        code: Code,
        at: Span,
        found: Found<'_>,
        (which, help): (&str, &str),
    ) -> Option<T> {
        let (ty, field) = (&found.syntax.ty, &found.syntax.name.value);
        let message = format!("`{}.{field}` is `{}`, which {which}", self.name(), ty.value);
        self.refuse(Diagnostic::new(code, at, message).related(ty.span, "the field").help(help))
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

    /// Resolves a condition: nothing if there is none. What is wrong with one is reported.
    pub(super) fn condition(&mut self, condition: &overlay::Condition) -> Option<Condition> {
        let (name, text) = (condition.field.as_ref()?, condition.value.as_ref()?);
        let found = self.field(name)?;
        let Some(repr) = found.scalar_repr() else {
            let why = ("no condition can ask", "a condition asks a scalar integer");
            return self.refuse_type(Code::Condition, name.span, found, why);
        };
        let enum_ = self.enum_of(found.syntax);
        let entry = || enum_.and_then(|enum_| self.entry(enum_, &text.value));
        match number::unsigned(&text.value).ok().or_else(entry) {
            Some(value) if value <= repr.highest() => return Some(Condition { field: found.index, value, enum_ }),
            Some(value) => {
                let (ty, field) = (&found.syntax.ty, &found.syntax.name.value);
                let message = format!("`{}.{field}` is never {value}: it is `{}`", self.name(), ty.value);
                let problem = Diagnostic::new(Code::Condition, text.span, message).related(ty.span, "the field");
                self.report(problem.help("the condition would never hold"));
            }
            None if !self.entries.complete => {}
            None => self.report_value(not_a_value(self.name(), text, found), &text.value, enum_),
        }
        None
    }
}

fn not_a_value(message: &str, text: &Text, found: Found<'_>) -> Diagnostic {
    let field = &found.syntax.name;
    let (problem, place, label) = match &found.syntax.enum_ {
        Some(enum_) => {
            let problem = format!("`{}` is neither a number nor an entry of `{}`", text.value, enum_.value);
            (problem, enum_.span, "the enum of the field".to_owned())
        }
        None => {
            let label = format!("`{message}.{}` carries no enum", field.value);
            (format!("`{}` is not a number from 0", text.value), field.span, label)
        }
    };
    let problem = Diagnostic::new(Code::Condition, text.span, problem).related(place, label);
    problem.help("write a number, or an entry of the enum that the field carries")
}
