//! How a message gives a view: once, or once a slot with the slot's keys.

use super::beside::beside;
use super::sentinel;
use super::words::{Shape, Words};
use super::{spelling, text};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Access, FieldIndex, Key, Label, Place, Slots, unit_words};
use crate::resolve::message_scope::{Found, MessageScope};
use crate::source::Span;
use crate::syntax::Text;
use crate::syntax::overlay::{self, View};

/// Resolves `item`, `items`, `count` and the keys.
pub(super) fn access(
    scope: &MessageScope<'_, '_>,
    element: &View,
    words: &Words,
    diagnostics: &mut Diagnostics,
) -> Option<Access> {
    match words.shape {
        Some(shape) => slots(scope, element, words, shape, diagnostics).map(Access::Slots),
        None => once(element, words, diagnostics),
    }
}

fn once(element: &View, words: &Words, diagnostics: &mut Diagnostics) -> Option<Access> {
    let mut stray = |span: Span, what: &str| {
        let message = format!("{what} belongs to slots, and the view has none");
        let problem = Diagnostic::new(Code::Slots, span, message).related(words.span, "no word is `x[i]`");
        diagnostics.push(problem.help("leave it out, or read the view from elements of arrays"));
    };
    for (text, what) in [(&element.items, "`items`"), (&element.count, "`count`")] {
        text.iter().for_each(|text| stray(text.span, what));
    }
    element.keys.iter().for_each(|key| stray(key.span, "a key"));
    getter(element, diagnostics).map(|getter| Access::Once { getter })
}

/// `item`, of a view that a message has once.
pub(super) fn getter(element: &View, diagnostics: &mut Diagnostics) -> Option<Label> {
    let item = element.item.as_ref();
    if item.is_none() {
        let message = format!("view `{}` has no `item`", element.name.value);
        let problem = Diagnostic::new(Code::Slots, element.span, message);
        diagnostics.push(problem.help("`item=\"…\"` names the getter that the message has for it"));
    }
    item.map(spelling::label)
}

fn slots(
    scope: &MessageScope<'_, '_>,
    element: &View,
    words: &Words,
    shape: Shape,
    diagnostics: &mut Diagnostics,
) -> Option<Slots> {
    let mut required = |text: &Option<Text>, name: &str, help: &str| -> Option<Text> {
        if text.is_none() {
            let message = format!("view `{}` has {} slots and no `{name}`", element.name.value, shape.length);
            let problem = Diagnostic::new(Code::Slots, element.span, message).related(shape.span, "the slots");
            diagnostics.push(problem.help(format!("`{name}=\"…\"` names {help}")));
        }
        text.clone()
    };
    let item = required(&element.item, "item", "the type of a slot, and the method that gives one: `esc`");
    let items = required(&element.items, "items", "the iterator over the slots: `escs`");
    let count = element.count.as_ref().and_then(|text| count(scope, text, diagnostics));
    let mut keys = Vec::new();
    for key in &element.keys {
        let Some(found) = beside(scope, &key.field, words, diagnostics) else { continue };
        keys.push(key_of(scope, key, found, diagnostics));
    }
    Some(Slots { item: spelling::name(&item?), items: spelling::label(&items?), length: shape.length, count, keys })
}

fn count(scope: &MessageScope<'_, '_>, text: &Text, diagnostics: &mut Diagnostics) -> Option<FieldIndex> {
    let found = scope.field(text, diagnostics)?;
    let ty = found.field.ty;
    if ty.array.is_none() && ty.scalar.is_unsigned() {
        return Some(found.index);
    }
    let spelled = &found.syntax.ty;
    let message = format!("`{}.{}` is `{}`, which is no count", scope.name(), text.value, spelled.value);
    let problem = Diagnostic::new(Code::Count, text.span, message).related(spelled.span, "the field");
    diagnostics.push(problem.help("a count is a scalar unsigned integer"));
    None
}

/// A key or a value, of a field.
pub(super) fn key_of(
    scope: &MessageScope<'_, '_>,
    element: &overlay::Key,
    (place, found): (Place, Found<'_>),
    diagnostics: &mut Diagnostics,
) -> Key {
    let invalid = element.invalid.as_ref();
    let invalid = invalid.and_then(|text| sentinel::of_field(scope, text, found, diagnostics));
    // An integer is mostly in a fraction of the plain unit, which its name should say; a float is in the plain one.
    let units = element.units.as_ref().filter(|units| !units.value.trim().is_empty());
    let suffix = units.filter(|_| !found.field.ty.scalar.is_float()).map(|units| unit_words(&units.value));
    Key {
        name: Label { name: spelling::name(&element.name), suffix },
        place,
        units: units.map(|units| units.value.clone()).or_else(|| text::non_empty(found.syntax.units.as_ref())),
        invalid,
        description: text::or_empty(element.description.as_ref()),
    }
}
