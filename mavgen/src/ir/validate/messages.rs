//! Messages, their fields and what the wire makes of them.

use super::{Item, views};
use crate::collect::CollectVec as _;
use crate::ir::{
    Binding, Field, FieldType, Invalid, LARGEST_ID, Layout, MOST_FIELDS, Message, Scalar, Scope, Sentinel, Values,
};

pub(super) fn check(item: &mut Item<'_>) {
    let messages = &item.dialect.messages;
    item.unless(messages.is_sorted_by(|a, b| a.id < b.id), "the ids of its messages do not rise");
    item.check_once("message", &mut messages.iter().map(|message| &message.name));
    messages.iter().for_each(|message| check_message(item, message));
}

fn check_message(item: &mut Item<'_>, message: &Message) {
    let Message { id, name, crc_extra: _, len_v1: _, len_v2: _, fields, views, bindings, origin } = message;
    let item = &mut item.named("message", name);
    item.check_origin(origin);
    item.unless(*id <= LARGEST_ID, "its id is more than 24 bits");
    item.unless((1..=MOST_FIELDS).contains(&fields.len()), "it has not 1 to 64 fields");
    item.check_once("field", &mut fields.iter().map(|field| &field.name));
    let base_first =
        fields.is_sorted_by_key(|field| field.extension) && !fields.first().is_some_and(|one| one.extension);
    item.unless(base_first, "an extension stands before a field that is none");
    check_wire(item, message);
    fields.iter().for_each(|field| check_field(item, field));
    views.iter().for_each(|view| views::check(item, message, view));
    bindings.iter().for_each(|binding| check_binding(item, message, binding));
}

/// Offsets, lengths and checksum are worked out anew.
fn check_wire(item: &mut Item<'_>, message: &Message) {
    let fields = message.fields.iter().map(|field| (field.name.text.as_str(), field.ty, field.extension));
    let Ok(layout) = Layout::of(&message.name.text, &fields.collect_vec()) else {
        item.push("its fields are more than a payload can hold");
        return;
    };
    let lengths = (message.len_v1, message.len_v2) == (layout.len_v1, layout.len_v2);
    item.unless(lengths, "its lengths are not the sum of its fields");
    let offsets = message.fields.iter().map(|field| field.offset);
    item.unless(offsets.eq(layout.offsets.iter().copied()), "a field does not lie where the wire has it");
    item.unless(message.crc_extra == layout.crc_extra, "its `crc_extra` is another");
}

#[rustfmt::skip]
fn check_field(item: &mut Item<'_>, field: &Field) {
    let Field {
        name, ty, values, invalid, limits, origin, offset: _, extension: _, units: _, multiplier: _, default: _,
        print_format: _, display_bitmask: _, instance: _,
    } = field;
    let mut item = item.part("field", name);
    item.check_origin(origin);
    item.check_limits(*limits);
    let array_of_version = matches!(ty.scalar, Scalar::Version(_)) && ty.array.is_some();
    item.unless(!array_of_version, "it is an array of versions");
    values.iter().for_each(|values| check_values(&mut item, *ty, *values));
    invalid.iter().for_each(|invalid| check_invalid(&mut item, *ty, *invalid));
}

/// The enum is the field's type if and only if it has the same integer.
fn check_values(item: &mut Item<'_>, ty: FieldType, values: Values) {
    let (own, of_enum) = (ty.scalar.repr(), item.dialect.enum_by_id(values.id()).map(|one| one.repr));
    item.check_enum(Some(values.id()));
    let (Some(own), Some(of_enum)) = (own, of_enum) else {
        item.unless(own.is_some(), "it is no integer and carries an enum");
        return;
    };
    let right = matches!(values, Values::Typed(_)) == (own == of_enum);
    item.unless(right, "it is typed although its integer is not the enum's, or the other way round");
}

fn check_invalid(item: &mut Item<'_>, ty: FieldType, invalid: Invalid) {
    let Invalid { scope, sentinel } = invalid;
    item.unless(ty.array.is_some() || scope == Scope::Each, "its sentinel is for an array");
    let fits = match sentinel {
        Sentinel::Integer(value) => ty.scalar.range().is_some_and(|range| range.contains(&value)),
        Sentinel::Float(value) => ty.scalar.holds_float(value),
        Sentinel::NotANumber => ty.scalar.is_float(),
    };
    item.unless(fits, "it cannot have its sentinel");
}

fn check_binding(item: &mut Item<'_>, message: &Message, binding: &Binding) {
    let Binding { name, field, enum_, condition, description: _ } = binding;
    let item = &mut item.part("binding", &name.name);
    item.check_enum(Some(*enum_));
    views::check_condition(item, message, condition.as_ref());
    let Some(field) = message.fields.get(field.0) else {
        item.push("it names a field that does not exist");
        return;
    };
    let repr = item.dialect.enum_by_id(*enum_).map(|one| one.repr);
    let suits = field.ty.array.is_none() && field.ty.scalar.repr() == repr && field.values.is_none();
    item.unless(suits, "its field is no scalar as wide as the enum, or carries one");
}
