//! Views: what they are read from, and how a message gives them.

use std::num::NonZeroU8;

use super::{Faults, Item, members};
use crate::collect::CollectVec as _;
use crate::ir::{
    Access, Condition, Field, FieldIndex, Key, MOST_BITS, Message, Place, Record, Scalar, Slots, Switch, SwitchOn,
    View, ViewSentinel, Word,
};

/// A switch looks at so many bits.
const MOST_SWITCHED: u8 = 64;

pub(super) fn check(item: &Item, message: &Message, view: &View, faults: &mut Faults<'_>) {
    let View { name, words, width, access, condition, invalid, switch, members, origin } = view;
    let item = item.part("view", name);
    faults.check_name(&item, name);
    faults.check_origin(&item, origin);
    if let Access::Record(record) = access {
        let bare = words.is_empty() && *width == 0 && invalid.is_empty() && switch.is_none() && members.is_empty();
        faults.unless(bare, &item, "it has values, and bits as well");
        check_condition(&item, message, condition.as_ref(), faults);
        check_record(&item, message, record, condition.as_ref(), faults);
        return;
    }
    check_words(&item, message, words, *width, faults);
    let length = match access {
        Access::Once { getter } => {
            faults.check_name(&item, &getter.name);
            None
        }
        Access::Slots(slots) => Some(slots.length),
        Access::Record(_) => None,
    };
    check_slots(&item, message, words, access, faults);
    check_condition(&item, message, condition.as_ref(), faults);
    for sentinel in invalid {
        check_sentinel(&item, message, *sentinel, (*width, length), faults);
    }
    if let Some(switch) = switch {
        check_switch(&item, message, switch, (*width, length), faults);
    }
    let most = switch.as_ref().map(|switch| switch.on.highest());
    members::check(&item, members, (*width, most), faults);
}

/// The words are integers, each once, and together as wide as is said.
fn check_words(item: &Item, message: &Message, words: &[Word], width: u8, faults: &mut Faults<'_>) {
    let field_of = |word: &Word| match word {
        Word::One(place) => place.field,
        Word::Joined(field) => *field,
    };
    let mut bits = 0;
    for (at, word) in words.iter().enumerate() {
        let Some(field) = message.fields.get(field_of(word).0) else {
            faults.push(item, "a word is of a field that does not exist");
            continue;
        };
        let again = words.iter().take(at).any(|before| field_of(before) == field_of(word));
        faults.unless(!again, item, "a word stands twice");
        faults.unless(field.ty.scalar.is_word(), item, "a word is of a type that is none");
        let (wants_array, size) = match word {
            Word::One(place) => (place.element, field.ty.scalar.size()),
            Word::Joined(_) => (true, field.ty.size()),
        };
        faults.unless(
            field.ty.array.is_some() == wants_array,
            item,
            "a word is an element of a scalar, or a whole array",
        );
        bits += 8 * size;
    }
    faults.unless(
        bits == usize::from(width) && (1..=MOST_BITS).contains(&bits),
        item,
        "its width is not that of its words",
    );
}

/// The view is given in slots if and only if its words are elements, of arrays of one length.
fn check_slots(item: &Item, message: &Message, words: &[Word], access: &Access, faults: &mut Faults<'_>) {
    let elements = words.iter().filter(|word| matches!(word, Word::One(Place { element: true, .. }))).count();
    let Access::Slots(Slots { item: slot, items, length, count, keys }) = access else {
        faults.unless(elements == 0, item, "a word is an element, and there are no slots");
        return;
    };
    faults.check_name(item, slot);
    faults.check_name(item, &items.name);
    faults.unless(elements == words.len(), item, "a word is no element, and there are slots");
    for word in words {
        if let Word::One(place) = word {
            check_place(item, message, *place, Some(*length), faults);
        }
    }
    if let Some(FieldIndex(count)) = count {
        let field = message.fields.get(*count);
        let suits = field.is_some_and(|field| field.ty.array.is_none() && field.ty.scalar.is_unsigned());
        faults.unless(suits, item, "its count is no scalar unsigned integer");
    }
    keys.iter().for_each(|key| check_key(item, message, key, Some(*length), faults));
}

fn check_key(item: &Item, message: &Message, key: &Key, slots: Option<NonZeroU8>, faults: &mut Faults<'_>) {
    let Key { name, place, units: _, invalid, description: _ } = key;
    let item = item.part("key", &name.name);
    faults.check_name(&item, &name.name);
    if let (Some(field), Some(invalid)) = (check_place(&item, message, *place, slots, faults), invalid) {
        check_compared(&item, field, *invalid, faults);
    }
}

/// The values are scalars, each field once; what the condition asks is none of them.
fn check_record(
    item: &Item,
    message: &Message,
    record: &Record,
    condition: Option<&Condition>,
    faults: &mut Faults<'_>,
) {
    let Record { getter, values } = record;
    faults.check_name(item, &getter.name);
    faults.unless(!values.is_empty(), item, "it has no values");
    let mut taken = condition.iter().map(|condition| condition.field).collect_vec();
    for value in values {
        check_key(item, message, value, None, faults);
        faults.unless(!taken.contains(&value.place.field), item, "a value is twice in it, or asked by its condition");
        taken.push(value.place.field);
    }
}

/// A scalar, or an element of an array with one for each slot.
fn check_place<'m>(
    item: &Item,
    message: &'m Message,
    place: Place,
    slots: Option<NonZeroU8>,
    faults: &mut Faults<'_>,
) -> Option<&'m Field> {
    let Some(field) = message.fields.get(place.field.0) else {
        faults.push(item, "it names a field that does not exist");
        return None;
    };
    let right =
        if place.element { field.ty.array.is_some() && field.ty.array == slots } else { field.ty.array.is_none() };
    faults.unless(right, item, "it names an element of what has none for each slot, or a whole array");
    Some(field)
}

fn check_compared(item: &Item, field: &Field, value: i128, faults: &mut Faults<'_>) {
    let range = field.ty.scalar.range().filter(|_| field.ty.scalar != Scalar::Char);
    faults.unless(
        range.is_some_and(|range| range.contains(&value)),
        item,
        "a field cannot have the value of its sentinel",
    );
}

fn check_sentinel(
    item: &Item,
    message: &Message,
    sentinel: ViewSentinel,
    (width, slots): (u8, Option<NonZeroU8>),
    faults: &mut Faults<'_>,
) {
    match sentinel {
        ViewSentinel::Field(place, value) => {
            if let Some(field) = check_place(item, message, place, slots, faults) {
                check_compared(item, field, value, faults);
            }
        }
        ViewSentinel::Words(value) => {
            faults.unless(
                value.checked_shr(u32::from(width)).unwrap_or_default() == 0,
                item,
                "its words cannot have the value of its sentinel",
            );
        }
    }
}

/// A condition asks a scalar integer for a value that it can have.
pub(super) fn check_condition(item: &Item, message: &Message, condition: Option<&Condition>, faults: &mut Faults<'_>) {
    let Some(Condition { field, value, enum_ }) = condition else { return };
    faults.check_enum(item, *enum_);
    let field = message.fields.get(field.0).filter(|field| field.ty.array.is_none());
    let highest = field.and_then(|field| field.ty.scalar.repr()).map(|repr| repr.highest());
    faults.unless(highest.is_some_and(|highest| *value <= highest), item, "its condition never holds");
}

fn check_switch(
    item: &Item,
    message: &Message,
    switch: &Switch,
    (width, slots): (u8, Option<NonZeroU8>),
    faults: &mut Faults<'_>,
) {
    let Switch { name, on, span: _ } = switch;
    faults.check_name(item, &name.name);
    match *on {
        SwitchOn::Field(place, repr) => {
            let field = check_place(item, message, place, slots, faults);
            let suits = field.is_none_or(|field| field.ty.scalar.is_unsigned() && field.ty.scalar.repr() == Some(repr));
            faults.unless(suits, item, "its switch looks at a field that is no such unsigned integer");
        }
        SwitchOn::Bits { at, width: bits } => {
            let inside = u16::from(at) + u16::from(bits) <= u16::from(width);
            faults.unless(
                inside && (1..=MOST_SWITCHED).contains(&bits),
                item,
                "its switch looks at bits that are not there",
            );
        }
    }
}
