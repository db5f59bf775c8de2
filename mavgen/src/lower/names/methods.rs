//! Methods: those that a message has for its fields and by overlays, those of a view, and the fields of a slot or a record.

use super::{AccessNames, MessageNames, ViewNames};
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::ir::{self, Access, Field, FieldIndex, Meaning, Member, Message, Record, Scalar, Slots, Values, View};
use crate::lower::namespace::{Claim, Collision, Namespace, Scope, What};
use crate::lower::{collision, spelling};

/// Checks the methods of a message and of its views, and decides which fields have a getter and a setter.
pub(super) fn check(message: &Message, names: &MessageNames, diagnostics: &mut Diagnostics) -> Vec<FieldIndex> {
    let mut methods = Namespace::of(Scope::Methods);
    let mut found: Vec<Collision<'_>> = Vec::new();
    let mut accessors = Vec::new();
    for (index, (field, name)) in message.fields.iter().zip(&names.fields).enumerate() {
        if has_accessors(field) {
            match methods.claim_all(&accessor_names(field, name), Claim::of(What::Accessors, &field.name)) {
                None => accessors.push(FieldIndex(index)),
                Some(collision) => found.push(collision),
            }
        }
    }
    for (binding, name) in message.bindings.iter().zip(&names.bindings) {
        found.extend(methods.claim_all(&binding_methods(name), Claim::of(What::Binding, &binding.name.name)));
    }
    for (view, names) in message.views.iter().zip(&names.views) {
        let spans = match &view.access {
            Access::Once { getter } | Access::Record(Record { getter, .. }) => [getter.name.span; 2],
            Access::Slots(slots) => [slots.item.span, slots.items.name.span],
        };
        for (names, span) in [slot_methods(names), iterators(names)].iter().zip(spans) {
            let by = Claim { span: Some(span), ..Claim::of(What::View, &view.name) };
            found.extend(methods.claim_all(names, by));
        }
        of_view(view, names, &mut found);
    }
    diagnostics.extend(found.iter().filter_map(collision::diagnostic));
    accessors
}

/// Whether a field has a getter and a setter, if their names are free: because it may be unknown, or because it carries an enum
/// that is not its type.
fn has_accessors(field: &Field) -> bool {
    let text = field.ty.scalar == Scalar::Char && field.ty.array.is_some();
    matches!(field.values, Some(Values::Converted(_))) || field.invalid.is_some() && !text
}

/// The methods of a field that has some.
fn accessor_names(field: &Field, name: &str) -> Vec<String> {
    let each = field.invalid.as_ref().is_some_and(|invalid| invalid.scope != ir::Scope::Whole);
    let several = field.ty.array.is_some() && each && !matches!(field.values, Some(Values::Converted(_)));
    let iterator = several.then(|| iterator(name));
    [name.to_owned(), setter(name)].into_iter().chain(iterator).collect_vec()
}

/// The iterator over the elements of a field.
pub(in crate::lower) fn iterator(name: &str) -> String {
    format!("iter_{name}")
}

/// The methods that a binding gives to its message.
pub(in crate::lower) fn binding_methods(name: &str) -> [String; 2] {
    [setter(name), name.to_owned()]
}

/// The methods that a view gives to its message, also those that nobody else sees.
pub(in crate::lower) fn view_methods(names: &ViewNames) -> Vec<String> {
    [iterators(names), slot_methods(names)].concat()
}

/// Those for one slot, or for a view that has none.
fn slot_methods(names: &ViewNames) -> Vec<String> {
    match &names.access {
        AccessNames::Once { getter } => vec![getter.clone(), setter(getter)],
        AccessNames::Record { getter, .. } => vec![getter.clone(), setter(getter), with(getter)],
        AccessNames::Slots { getter, .. } => {
            let prefixed = ["set_", "push_", "store_"].map(|prefix| format!("{prefix}{getter}"));
            prefixed.into_iter().chain([getter.clone()]).collect_vec()
        }
    }
}

/// Those for all slots.
fn iterators(names: &ViewNames) -> Vec<String> {
    match &names.access {
        AccessNames::Once { .. } | AccessNames::Record { .. } => Vec::new(),
        AccessNames::Slots { items, .. } => vec![items.clone()],
    }
}

/// The methods of a view, and the fields of its slot or record.
fn of_view<'a>(view: &'a View, names: &ViewNames, found: &mut Vec<Collision<'a>>) {
    let mut methods = Namespace::of(Scope::ViewMethods);
    if let (Some(name), Some(switch)) = (&names.switch, &view.switch) {
        let by = Claim { span: Some(switch.span), ..Claim::of(What::Switch, &switch.name.name) };
        found.extend(methods.claim(name.clone(), by));
    }
    for (member, name) in view.members.iter().zip(&names.members) {
        let by = Claim::of(What::Member, &member.name.name);
        let collision = methods.claim_each(&member_methods(member, name), by);
        found.extend(collision.or_else(|| operator(member, name, by)));
    }
    let (scope, what, keys, names) = match (&view.access, &names.access) {
        (Access::Slots(Slots { keys: model, .. }), AccessNames::Slots { keys, .. }) => {
            (Scope::SlotFields, What::Key, model, keys)
        }
        (Access::Record(record), AccessNames::Record { values, .. }) => {
            (Scope::RecordFields, What::Value, &record.values, values)
        }
        _ => return,
    };
    let mut fields = Namespace::of(scope);
    for (key, name) in keys.iter().zip(names) {
        found.extend(fields.claim(name.clone(), Claim::of(what, &key.name.name)));
    }
}

/// The methods of bits.
fn member_methods(member: &Member, name: &str) -> Vec<String> {
    let with = with(name);
    let Meaning::Scaled(scaled) = &member.meaning else { return vec![name.to_owned(), setter(name), with] };
    let raw = spelling::beside(name, "raw");
    let exact = scaled.exact.as_ref().map(|exact| spelling::beside(name, &exact.suffix()));
    let setters = [setter(name), setter(&raw), with];
    [name.to_owned(), raw].into_iter().chain(exact).chain(setters).collect_vec()
}

/// The getter of a scaled number is no `const fn`: with the name of an operator, clippy takes it for one.
fn operator<'a>(member: &Member, name: &str, by: Claim<'a>) -> Option<Collision<'a>> {
    let scaled = matches!(member.meaning, Meaning::Scaled(_));
    let names: &[&str] = if member.repeat.is_some() { &spelling::OPERATORS } else { &["into_iter"] };
    let first = Claim { what: What::Reserved("the method of an operator"), text: "", span: None, age: 0 };
    let is_operator = scaled && names.contains(&name);
    is_operator.then(|| Collision { scope: Scope::ViewMethods, name: name.to_owned(), first, second: by })
}

fn setter(name: &str) -> String {
    format!("set_{name}")
}

fn with(name: &str) -> String {
    format!("with_{name}")
}
