//! Messages, their fields and what the wire makes of them.

use super::{Faults, Item, views};
use crate::collect::CollectVec as _;
use crate::ir::{
    Binding, Field, FieldType, Invalid, LARGEST_ID, Layout, MOST_FIELDS, Message, Scalar, Scope, Sentinel, Values,
};

pub(super) fn check(faults: &mut Faults<'_>) {
    let messages = &faults.dialect.messages;
    let item = Item { path: format!("dialect `{}`", faults.dialect.name), span: None };
    faults.unless(messages.is_sorted_by(|a, b| a.id < b.id), &item, "the ids of its messages do not rise");
    faults.check_once(&item, "message", messages.iter().map(|message| message.name.text.as_str()));
    messages.iter().for_each(|message| check_message(message, faults));
}

fn check_message(message: &Message, faults: &mut Faults<'_>) {
    let Message { id, name, crc_extra: _, len_v1: _, len_v2: _, fields, views, bindings, origin } = message;
    let item = Item::named("message", name);
    faults.check_name(&item, name);
    faults.check_origin(&item, origin);
    faults.unless(*id <= LARGEST_ID, &item, "its id is more than 24 bits");
    faults.unless((1..=MOST_FIELDS).contains(&fields.len()), &item, "it has not 1 to 64 fields");
    faults.check_once(&item, "field", fields.iter().map(|field| field.name.text.as_str()));
    let base_first =
        fields.is_sorted_by_key(|field| field.extension) && !fields.first().is_some_and(|one| one.extension);
    faults.unless(base_first, &item, "an extension stands before a field that is none");
    check_wire(&item, message, faults);
    fields.iter().for_each(|field| check_field(&item, field, faults));
    views.iter().for_each(|view| views::check(&item, message, view, faults));
    bindings.iter().for_each(|binding| check_binding(&item, message, binding, faults));
}

/// Offsets, lengths and checksum are worked out anew.
fn check_wire(item: &Item, message: &Message, faults: &mut Faults<'_>) {
    let fields = message.fields.iter().map(|field| (field.name.text.as_str(), field.ty, field.extension));
    let layout = Layout::of(&message.name.text, &fields.collect_vec());
    let lengths = [(message.len_v1, layout.v1), (message.len_v2, layout.v2)];
    let right = lengths.iter().all(|(said, found)| usize::from(*said) == *found);
    faults.unless(right, item, "its lengths are not the sum of its fields");
    let offsets = message.fields.iter().map(|field| usize::from(field.offset));
    faults.unless(offsets.eq(layout.offsets.iter().copied()), item, "a field does not lie where the wire has it");
    faults.unless(message.crc_extra == layout.crc_extra, item, "its `crc_extra` is another");
}

fn check_field(item: &Item, field: &Field, faults: &mut Faults<'_>) {
    let Field {
        name,
        ty,
        offset: _,
        extension: _,
        values,
        units: _,
        invalid,
        limits,
        multiplier: _,
        default: _,
        print_format: _,
        display_bitmask: _,
        instance: _,
        origin,
    } = field;
    let item = item.part("field", name);
    faults.check_name(&item, name);
    faults.check_origin(&item, origin);
    faults.check_limits(&item, *limits);
    let array_of_version = matches!(ty.scalar, Scalar::Version(_)) && ty.array.is_some();
    faults.unless(!array_of_version, &item, "it is an array of versions");
    if let Some(values) = values {
        check_values(&item, *ty, *values, faults);
    }
    if let Some(invalid) = invalid {
        check_invalid(&item, *ty, *invalid, faults);
    }
}

/// The enum is the field's type if and only if it has the same integer.
fn check_values(item: &Item, ty: FieldType, values: Values, faults: &mut Faults<'_>) {
    let (own, of_enum) = (ty.scalar.repr(), faults.dialect.enum_by_id(values.id()).map(|one| one.repr));
    faults.check_enum(item, Some(values.id()));
    let (Some(own), Some(of_enum)) = (own, of_enum) else {
        faults.unless(own.is_some(), item, "it is no integer and carries an enum");
        return;
    };
    let right = matches!(values, Values::Typed(_)) == (own == of_enum);
    faults.unless(right, item, "it is typed although its integer is not the enum's, or the other way round");
}

fn check_invalid(item: &Item, ty: FieldType, invalid: Invalid, faults: &mut Faults<'_>) {
    let Invalid { scope, sentinel } = invalid;
    faults.unless(ty.array.is_some() || scope == Scope::Each, item, "its sentinel is for an array");
    let fits = match sentinel {
        Sentinel::Integer(value) => ty.scalar.range().is_some_and(|range| range.contains(&value)),
        Sentinel::Float(value) => ty.scalar.holds_float(value),
        Sentinel::NotANumber => ty.scalar.is_float(),
    };
    faults.unless(fits, item, "it cannot have its sentinel");
}

fn check_binding(item: &Item, message: &Message, binding: &Binding, faults: &mut Faults<'_>) {
    let Binding { name, field, enum_, condition, description: _ } = binding;
    let item = item.part("binding", &name.name);
    faults.check_name(&item, &name.name);
    faults.check_enum(&item, Some(*enum_));
    views::check_condition(&item, message, condition.as_ref(), faults);
    let Some(field) = message.fields.get(field.0) else {
        faults.push(&item, "it names a field that does not exist");
        return;
    };
    let repr = faults.dialect.enum_by_id(*enum_).map(|one| one.repr);
    let suits = field.ty.array.is_none() && field.ty.scalar.repr() == repr && field.values.is_none();
    faults.unless(suits, &item, "its field is no scalar as wide as the enum, or carries one");
}
