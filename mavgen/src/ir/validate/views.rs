//! Views: what they are read from, and how a message gives them.

use std::num::NonZeroU8;

use super::{Item, members};
use crate::collect::CollectVec as _;
use crate::ir::{
    Access, Condition, Field, FieldIndex, Key, MOST_BITS, Message, Place, Record, Scalar, Slots, Switch, SwitchOn,
    View, ViewSentinel, Word,
};

/// A switch looks at so many bits.
const MOST_SWITCHED: u8 = 64;

pub(super) fn check(item: &mut Item<'_>, message: &Message, view: &View) {
    let View { name, words, width, access, condition, invalid, switch, members, origin } = view;
    let item = &mut item.part("view", name);
    item.check_origin(origin);
    if let Access::Record(record) = access {
        let bare = words.is_empty() && *width == 0 && invalid.is_empty() && switch.is_none() && members.is_empty();
        item.unless(bare, "it has values, and bits as well");
        check_condition(item, message, condition.as_ref());
        check_record(item, message, record, condition.as_ref());
        return;
    }
    check_words(item, message, words, *width);
    if let Access::Once { getter } = access {
        item.check_name(&getter.name);
    }
    let length = if let Access::Slots(slots) = access { Some(slots.length) } else { None };
    check_slots(item, message, words, access);
    check_condition(item, message, condition.as_ref());
    for sentinel in invalid {
        check_sentinel(item, message, *sentinel, (*width, length));
    }
    if let Some(switch) = switch {
        check_switch(item, message, switch, (*width, length));
    }
    members::check(item, members, *width, switch.as_ref().map(|switch| switch.on.highest()));
}

/// The words are integers, each once, and together as wide as is said.
fn check_words(item: &mut Item<'_>, message: &Message, words: &[Word], width: u8) {
    let field_of = |word: &Word| match word {
        Word::One(place) => place.field,
        Word::Joined(field) => *field,
    };
    let mut bits = 0;
    for (at, word) in words.iter().enumerate() {
        let Some(field) = message.fields.get(field_of(word).0) else {
            item.push("a word is of a field that does not exist");
            continue;
        };
        let again = words.iter().take(at).any(|before| field_of(before) == field_of(word));
        item.unless(!again, "a word stands twice");
        item.unless(field.ty.scalar.is_word(), "a word is of a type that is none");
        let (wants_array, size) = match word {
            Word::One(place) => (place.element, field.ty.scalar.size()),
            Word::Joined(_) => (true, field.ty.size()),
        };
        item.unless(field.ty.array.is_some() == wants_array, "a word is an element of a scalar, or a whole array");
        bits += 8 * size;
    }
    item.unless(bits == usize::from(width) && (1..=MOST_BITS).contains(&bits), "its width is not that of its words");
}

/// The view is given in slots if and only if its words are elements, of arrays of one length.
fn check_slots(item: &mut Item<'_>, message: &Message, words: &[Word], access: &Access) {
    let elements = words.iter().filter(|word| matches!(word, Word::One(Place { element: true, .. }))).count();
    let Access::Slots(Slots { item: slot, items, length, count, keys }) = access else {
        item.unless(elements == 0, "a word is an element, and there are no slots");
        return;
    };
    item.check_name(slot);
    item.check_name(&items.name);
    item.unless(elements == words.len(), "a word is no element, and there are slots");
    for word in words {
        if let Word::One(place) = word {
            check_place(item, message, *place, Some(*length));
        }
    }
    if let Some(FieldIndex(count)) = count {
        let field = message.fields.get(*count);
        let suits = field.is_some_and(|field| field.ty.array.is_none() && field.ty.scalar.is_unsigned());
        item.unless(suits, "its count is no scalar unsigned integer");
    }
    keys.iter().for_each(|key| check_key(item, message, key, Some(*length)));
}

fn check_key(item: &mut Item<'_>, message: &Message, key: &Key, slots: Option<NonZeroU8>) {
    let Key { name, place, units: _, invalid, description: _ } = key;
    let item = &mut item.part("key", &name.name);
    if let (Some(field), Some(invalid)) = (check_place(item, message, *place, slots), invalid) {
        check_compared(item, field, *invalid);
    }
}

/// The values are scalars, each field once; what the condition asks is none of them.
fn check_record(item: &mut Item<'_>, message: &Message, record: &Record, condition: Option<&Condition>) {
    let Record { getter, values } = record;
    item.check_name(&getter.name);
    item.unless(!values.is_empty(), "it has no values");
    let mut taken = condition.iter().map(|condition| condition.field).collect_vec();
    for value in values {
        check_key(item, message, value, None);
        item.unless(!taken.contains(&value.place.field), "a value is twice in it, or asked by its condition");
        taken.push(value.place.field);
    }
}

/// A scalar, or an element of an array with one for each slot.
fn check_place<'m>(
    item: &mut Item<'_>,
    message: &'m Message,
    place: Place,
    slots: Option<NonZeroU8>,
) -> Option<&'m Field> {
    let Some(field) = message.fields.get(place.field.0) else {
        item.push("it names a field that does not exist");
        return None;
    };
    let right =
        if place.element { field.ty.array.is_some() && field.ty.array == slots } else { field.ty.array.is_none() };
    item.unless(right, "it names an element of what has none for each slot, or a whole array");
    Some(field)
}

fn check_compared(item: &mut Item<'_>, field: &Field, value: i128) {
    let range = field.ty.scalar.range().filter(|_| field.ty.scalar != Scalar::Char);
    item.unless(range.is_some_and(|range| range.contains(&value)), "a field cannot have the value of its sentinel");
}

fn check_sentinel(
    item: &mut Item<'_>,
    message: &Message,
    sentinel: ViewSentinel,
    (width, slots): (u8, Option<NonZeroU8>),
) {
    match sentinel {
        ViewSentinel::Field(place, value) => {
            if let Some(field) = check_place(item, message, place, slots) {
                check_compared(item, field, value);
            }
        }
        ViewSentinel::Words(value) => {
            item.unless(
                value.checked_shr(u32::from(width)).unwrap_or_default() == 0,
                "its words cannot have the value of its sentinel",
            );
        }
    }
}

/// A condition asks a scalar integer for a value that it can have.
pub(super) fn check_condition(item: &mut Item<'_>, message: &Message, condition: Option<&Condition>) {
    let Some(Condition { field, value, enum_ }) = condition else { return };
    item.check_enum(*enum_);
    let field = message.fields.get(field.0).filter(|field| field.ty.array.is_none());
    let highest = field.and_then(|field| field.ty.scalar.repr()).map(|repr| repr.highest());
    item.unless(highest.is_some_and(|highest| *value <= highest), "its condition never holds");
}

fn check_switch(item: &mut Item<'_>, message: &Message, switch: &Switch, (width, slots): (u8, Option<NonZeroU8>)) {
    let Switch { name, on, span: _ } = switch;
    item.check_name(&name.name);
    match *on {
        SwitchOn::Field(place, repr) => {
            let field = check_place(item, message, place, slots);
            let suits = field.is_none_or(|field| field.ty.scalar.is_unsigned() && field.ty.scalar.repr() == Some(repr));
            item.unless(suits, "its switch looks at a field that is no such unsigned integer");
        }
        SwitchOn::Bits { at, width: bits } => {
            let inside = u16::from(at) + u16::from(bits) <= u16::from(width);
            item.unless(inside && (1..=MOST_SWITCHED).contains(&bits), "its switch looks at bits that are not there");
        }
    }
}
