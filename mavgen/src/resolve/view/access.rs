//! How a message gives a view: once, or once a slot with the slot's keys; or once, as values in fields.

use super::sentinel;
use super::words::{Shape, Words, beside};
use crate::diag::{Code, Diagnostic};
use crate::ir::{Access, Condition, FieldIndex, Key, Label, Place, Record, Slots, unit_words};
use crate::resolve::message_scope::{Found, MessageScope};
use crate::resolve::names;
use crate::resolve::origin::{non_empty, or_empty};
use crate::source::Span;
use crate::syntax::Text;
use crate::syntax::overlay::{self, Part, Piece, View};

/// Resolves `item`, `items`, `count` and the keys of a view with words.
pub(super) fn of_words(scope: &mut MessageScope<'_, '_>, element: &View, words: &Words) -> Option<Access> {
    if let Some(shape) = words.shape {
        return slots(scope, element, words, shape).map(Access::Slots);
    }
    let attributes = [(&element.items, "`items`"), (&element.count, "`count`")];
    let attributes = attributes.into_iter().filter_map(|(text, what)| Some((text.as_ref()?.span, what)));
    for (span, what) in attributes.chain(element.keys.iter().map(|key| (key.span, "a key"))) {
        let message = format!("{what} belongs to slots, and the view has none");
        let problem = Diagnostic::new(Code::Slots, span, message).related(words.span, "no word is `x[i]`");
        scope.report(problem.help("leave it out, or read the view from elements of arrays"));
    }
    getter(scope, element).map(|getter| Access::Once { getter })
}

fn getter(scope: &mut MessageScope<'_, '_>, element: &View) -> Option<Label> {
    let item = element.item.as_ref();
    if item.is_none() {
        let message = format!("view `{}` has no `item`", element.name.value);
        let problem = Diagnostic::new(Code::Slots, element.span, message);
        scope.report(problem.help("`item=\"…\"` names the getter that the message has for it"));
    }
    item.map(names::label)
}

fn slots(scope: &mut MessageScope<'_, '_>, element: &View, words: &Words, shape: Shape) -> Option<Slots> {
    let attributes = [
        (&element.item, "item", "the type of a slot, and the method that gives one: `esc`"),
        (&element.items, "items", "the iterator over the slots: `escs`"),
    ];
    for (_, name, what) in attributes.iter().filter(|(text, ..)| text.is_none()) {
        let message = format!("view `{}` has {} slots and no `{name}`", element.name.value, shape.length);
        let problem = Diagnostic::new(Code::Slots, element.span, message).related(shape.span, "the slots");
        scope.report(problem.help(format!("`{name}=\"…\"` names {what}")));
    }
    let count = element.count.as_ref().and_then(|text| count(scope, text));
    let mut keys = Vec::new();
    for key in &element.keys {
        let found = beside(scope, &key.field, words);
        keys.extend(found.map(|found| key_of(scope, key, found)));
    }
    let (item, items) = (names::name(element.item.as_ref()?), names::label(element.items.as_ref()?));
    Some(Slots { item, items, length: shape.length, count, keys })
}

fn count(scope: &mut MessageScope<'_, '_>, text: &Text) -> Option<FieldIndex> {
    let found = scope.field(text)?;
    if found.field.ty.array.is_none() && found.field.ty.scalar.is_unsigned() {
        return Some(found.index);
    }
    scope.refuse_type(Code::Count, text.span, found, ("is no count", "a count is a scalar unsigned integer"))
}

fn key_of(scope: &mut MessageScope<'_, '_>, element: &overlay::Key, (place, found): (Place, Found<'_>)) -> Key {
    let invalid = element.invalid.as_ref().and_then(|text| sentinel::of_field(scope, text, found));
    // An integer is mostly in a fraction of the plain unit, which its name should say; a float is in the plain one.
    let units = element.units.as_ref().filter(|units| !units.value.trim().is_empty());
    let suffix = units.filter(|_| !found.field.ty.scalar.is_float()).map(|units| unit_words(&units.value));
    Key {
        name: Label { name: names::name(&element.name), suffix },
        place,
        units: units.map(|units| units.value.clone()).or_else(|| non_empty(&found.syntax.units)),
        invalid,
        description: or_empty(&element.description),
    }
}

/// Resolves the values of a view that has no words.
pub(super) fn of_values(
    scope: &mut MessageScope<'_, '_>,
    element: &View,
    condition: Option<Condition>,
) -> Option<Access> {
    check_kind(scope, element);
    let mut taken: Vec<(FieldIndex, Span, &str)> = Vec::new();
    if let (Some(condition), Some(asked)) = (condition, &element.condition.field) {
        taken.push((condition.field, asked.span, "the condition asks it"));
    }
    let mut values = Vec::new();
    for value in &element.values {
        let Some(found) = scope.field(&value.field) else { continue };
        let span = value.field.span;
        if found.field.ty.array.is_some() {
            scope.refuse_type::<()>(Code::UnsuitableField, span, found, ("is not one value", "a value is a scalar"));
            continue;
        }
        if let Some((_, first, label)) = taken.iter().find(|(field, ..)| *field == found.index) {
            let message = format!("`{}` has its meaning in the view already", value.field.value);
            let problem = Diagnostic::new(Code::ValueTwice, span, message).related(*first, *label);
            scope.report(problem.help("leave it out, or name another field"));
        }
        taken.push((found.index, span, "the first time"));
        values.push(key_of(scope, value, (Place { field: found.index, element: false }, found)));
    }
    getter(scope, element).map(|getter| Access::Record(Record { getter, values }))
}

/// A view is of words and bits, or of values.
fn check_kind(scope: &mut MessageScope<'_, '_>, element: &View) {
    if element.values.is_empty() {
        if scope.whole && !element.parts.is_empty() {
            let message = format!("view `{}` has no `words`", element.name.value);
            let problem = Diagnostic::new(Code::ViewKind, element.name.span, message);
            scope.report(problem.help("`words=\"…\"` names the fields that the bits are in"));
        }
        return;
    }
    for (span, what) in only_with_words(element) {
        let message = format!("{what} belongs to a view of bits, and this is one of values");
        let problem = Diagnostic::new(Code::ViewKind, span, message).related(element.name.span, "it has no `words`");
        scope.report(problem.help("leave it out, or write another view for the bits"));
    }
}

/// What only a view with words has.
fn only_with_words(element: &View) -> impl Iterator<Item = (Span, &'static str)> {
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
