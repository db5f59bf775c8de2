//! Methods: those that a message has for its fields and by overlays, those of a view, and the fields of a slot or a record.

use super::{MessageNames, ViewNames};
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::ir::{Access, Field, FieldIndex, Meaning, Member, Message, Record, Scalar, Values, View};
use crate::lower::namespace::{Claim, Collision, Namespace, Scope, What};
use crate::lower::{collision, spelling};
use crate::rust::Extent;

/// Checks the methods of a message and of its views, and decides which fields have a getter and a setter.
pub(super) fn check(message: &Message, names: &MessageNames, diagnostics: &mut Diagnostics) -> Vec<FieldIndex> {
    let mut methods = Namespace::of(Scope::Methods);
    let mut with_accessors = Vec::new();
    for (index, (field, name)) in message.fields.iter().zip(&names.fields).enumerate() {
        if has_accessors(field) {
            let found = methods.claim_all(&accessors(name, iterates(field)), Claim::of(What::Accessors, &field.name));
            with_accessors.extend(collision::is_free(found, diagnostics).then_some(FieldIndex(index)));
        }
    }
    for (binding, name) in message.bindings.iter().zip(&names.bindings) {
        let found = methods.claim_all(&binding_methods(name), Claim::of(What::Binding, &binding.name.name));
        collision::report(found, diagnostics);
    }
    for (view, names) in message.views.iter().zip(&names.views) {
        let spans = match &view.access {
            Access::Once { getter } | Access::Record(Record { getter, .. }) => [getter.name.span; 2],
            Access::Slots(slots) => [slots.item.span, slots.items.name.span],
        };
        for (names, span) in methods_by_name(view, names).iter().zip(spans) {
            collision::report(methods.claim_all(names, Claim::at(What::View, &view.name.text, span)), diagnostics);
        }
        of_view(view, names, diagnostics);
    }
    with_accessors
}

/// Whether a field has a getter and a setter, if their names are free: because it may be unknown, or because it carries an enum
/// that is not its type.
fn has_accessors(field: &Field) -> bool {
    let text = field.ty.scalar == Scalar::Char && field.ty.array.is_some();
    matches!(field.values, Some(Values::Converted(_))) || field.invalid.is_some() && !text
}

/// Whether the accessors of a field have an iterator over its elements beside them.
fn iterates(field: &Field) -> bool {
    let extent = field.invalid.map(|invalid| Extent::of(invalid.scope, field.ty.array.map(|n| n.get().into())));
    extent.is_some_and(Extent::is_indexed) && !matches!(field.values, Some(Values::Converted(_)))
}

/// The methods of a field that has some.
pub(in crate::lower) fn accessors(name: &str, iterates: bool) -> Vec<String> {
    let iterator = iterates.then(|| iterator(name));
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
pub(in crate::lower) fn view_methods(view: &View, names: &ViewNames) -> Vec<String> {
    methods_by_name(view, names).concat()
}

/// Those that are named after the getter, and the iterator over slots, which has a name of its own.
fn methods_by_name(view: &View, ViewNames { getter, slots, .. }: &ViewNames) -> [Vec<String>; 2] {
    let prefixes: &[&str] = match &view.access {
        Access::Once { .. } => &["", "set_"],
        Access::Record(_) => &["", "set_", "with_"],
        Access::Slots(_) => &["set_", "push_", "store_", ""],
    };
    let named = prefixes.iter().map(|prefix| format!("{prefix}{getter}"));
    [named.collect_vec(), slots.iter().map(|slots| slots.items.clone()).collect_vec()]
}

/// The methods of a view, and the fields of its slot or record.
fn of_view(view: &View, names: &ViewNames, diagnostics: &mut Diagnostics) {
    let mut methods = Namespace::of(Scope::ViewMethods);
    if let (Some(name), Some(switch)) = (&names.switch, &view.switch) {
        let found = methods.claim(name.clone(), Claim::at(What::Switch, &switch.name.name.text, switch.span));
        collision::report(found, diagnostics);
    }
    for (member, name) in view.members.iter().zip(&names.members) {
        let by = Claim::of(What::Member, &member.name.name);
        let collision = methods.claim_each(&member_methods(member, name), by);
        collision::report(collision.or_else(|| operator(member, name, by)), diagnostics);
    }
    let (scope, what) = match &view.access {
        Access::Record(_) => (Scope::RecordFields, What::Value),
        Access::Once { .. } | Access::Slots(_) => (Scope::SlotFields, What::Key),
    };
    let mut fields = Namespace::of(scope);
    for (key, name) in view.keys().iter().zip(&names.keys) {
        collision::report(fields.claim(name.clone(), Claim::of(what, &key.name.name)), diagnostics);
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
    let first = Claim::reserved("the method of an operator");
    let is_operator = scaled && names.contains(&name);
    is_operator.then(|| Collision { scope: Scope::ViewMethods, name: name.to_owned(), first, second: by })
}

fn setter(name: &str) -> String {
    format!("set_{name}")
}

fn with(name: &str) -> String {
    format!("with_{name}")
}
