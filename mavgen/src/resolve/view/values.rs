//! A view of values: fields that have a name and a unit of their own, mostly while a condition holds.

use super::slots;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Access, Condition, FieldIndex, Place, Record};
use crate::resolve::message_scope::{Found, MessageScope};
use crate::source::Span;
use crate::syntax::overlay::{self, Part, Piece, View};

/// Resolves the values of a view that has no words.
pub(super) fn access(
    scope: &MessageScope<'_, '_>,
    element: &View,
    condition: Option<Condition>,
    diagnostics: &mut Diagnostics,
) -> Option<Access> {
    check_kind(scope, element, diagnostics);
    let mut taken: Vec<(FieldIndex, Span, &str)> = Vec::new();
    if let (Some(condition), Some(asked)) = (condition, &element.condition.field) {
        taken.push((condition.field, asked.span, "the condition asks it"));
    }
    let mut values = Vec::new();
    for value in &element.values {
        let Some(found) = scalar(scope, value, diagnostics) else { continue };
        if let Some((_, first, label)) = taken.iter().find(|(field, ..)| *field == found.index) {
            let message = format!("`{}` has its meaning in the view already", value.field.value);
            let problem = Diagnostic::new(Code::ValueTwice, value.field.span, message).related(*first, *label);
            diagnostics.push(problem.help("leave it out, or name another field"));
        }
        taken.push((found.index, value.field.span, "the first time"));
        let place = Place { field: found.index, element: false };
        values.push(slots::key_of(scope, value, (place, found), diagnostics));
    }
    slots::getter(element, diagnostics).map(|getter| Access::Record(Record { getter, values }))
}

/// A view is of words and bits, or of values.
fn check_kind(scope: &MessageScope<'_, '_>, element: &View, diagnostics: &mut Diagnostics) {
    if element.values.is_empty() {
        if scope.whole && !element.parts.is_empty() {
            let message = format!("view `{}` has no `words`", element.name.value);
            let problem = Diagnostic::new(Code::ViewKind, element.name.span, message);
            diagnostics.push(problem.help("`words=\"…\"` names the fields that the bits are in"));
        }
        return;
    }
    for (span, what) in of_words(element) {
        let message = format!("{what} belongs to a view of bits, and this is one of values");
        let problem = Diagnostic::new(Code::ViewKind, span, message).related(element.name.span, "it has no `words`");
        diagnostics.push(problem.help("leave it out, or write another view for the bits"));
    }
}

/// What only a view with words has.
fn of_words(element: &View) -> impl Iterator<Item = (Span, &'static str)> {
    let attributes = [(&element.items, "`items`"), (&element.count, "`count`"), (&element.partial, "`partial`")];
    let attributes = attributes.into_iter().filter_map(|(text, what)| Some((text.as_ref()?.span, what)));
    let keys = element.keys.iter().map(|key| (key.span, "a key"));
    let invalid = element.invalids.iter().map(|invalid| (invalid.span, "`<invalid>`"));
    let parts = element.parts.iter().map(|part| match part {
        Part::Piece(Piece::Bits(bits)) => (bits.span, "`<bits>`"),
        Part::Piece(Piece::Reserved(reserved)) => (reserved.span, "`<reserved>`"),
        Part::Switch(switch) => (switch.span, "`<switch>`"),
    });
    attributes.chain(keys).chain(invalid).chain(parts)
}

/// The field of a value.
fn scalar<'s>(
    scope: &MessageScope<'s, '_>,
    element: &overlay::Key,
    diagnostics: &mut Diagnostics,
) -> Option<Found<'s>> {
    let found = scope.field(&element.field, diagnostics)?;
    if found.field.ty.array.is_none() {
        return Some(found);
    }
    let (ty, name) = (&found.syntax.ty, &element.field.value);
    let message = format!("`{}.{name}` is `{}`, which is not one value", scope.name(), ty.value);
    let problem = Diagnostic::new(Code::UnsuitableField, element.field.span, message).related(ty.span, "the field");
    diagnostics.push(problem.help("a value is a scalar"));
    None
}
