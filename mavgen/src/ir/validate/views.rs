//! Views: what they are read from, how a message gives them, and their members: bits inside of the words, each with one meaning.

use std::num::NonZeroU8;
use std::ops::RangeInclusive;

use super::Item;
use crate::collect::CollectVec as _;
use crate::ir::{
    Access, Condition, Field, FieldIndex, Key, MOST_BITS, Meaning, Member, Message, Place, Presence, Record, Repeat,
    Scalar, Scaled, Slots, Switch, SwitchOn, View, ViewSentinel, Word, largest_of_bits, mask,
};

/// The widest integer that an enum, or the arithmetic of scaled values, can have.
const WIDEST: u8 = 64;

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
    check_members(item, members, *width, switch.as_ref().map(|switch| switch.on.highest()));
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

/// Checks the members of a view of so many bits; `most` is the largest value of its switch.
fn check_members(item: &mut Item<'_>, members: &[Member], width: u8, most: Option<u64>) {
    for (at, member) in members.iter().enumerate() {
        let Member { name, at: _, width: _, signed: _, meaning, repeat, presence, description: _ } = member;
        let item = &mut item.part("member", &name.name);
        check_bits(item, member, *repeat, width);
        check_meaning(item, member, meaning);
        check_presence(item, presence, most);
        let overlaps = members.iter().take(at).any(|before| share_bits(before, member));
        item.unless(!overlaps, "it has bits of a member that stands before it");
    }
}

fn check_bits(item: &mut Item<'_>, member: &Member, repeat: Option<Repeat>, width: u8) {
    let Repeat { count, stride } = repeat.unwrap_or(Repeat { count: 1, stride: member.width });
    item.unless(member.width > 0, "it has no bits");
    item.unless(repeat.is_none() || count > 1 && stride >= member.width, "its repetition is none");
    let last = u32::from(member.at) + u32::from(count.saturating_sub(1)) * u32::from(stride) + u32::from(member.width);
    item.unless(last <= u32::from(width), "it lies outside of the words");
}

fn check_meaning(item: &mut Item<'_>, member: &Member, meaning: &Meaning) {
    let Member { width, signed, .. } = *member;
    item.unless(!signed || width > 1, "one bit has no sign");
    match meaning {
        Meaning::Flag => item.unless(width == 1, "a flag is one bit"),
        Meaning::Values(id) => {
            item.check_enum(Some(*id));
            let holds = item.dialect.enum_by_id(*id).is_none_or(|one| one.repr.highest() >= largest_of_bits(width));
            item.unless(holds && width <= WIDEST && !signed, "its enum does not hold all values of its bits");
        }
        Meaning::Number { units: _ } => {}
        Meaning::Scaled(Scaled { factor, bias: _, divisor, units: _, exact }) => {
            item.unless(*factor != 0 && *divisor > 0 && width <= WIDEST, "its scale is none");
            let exact = exact.as_ref().is_none_or(|exact| exact.factor != 0 && !exact.suffix().is_empty());
            item.unless(exact, "its exact getter has no factor, or no name");
        }
    }
}

/// The values of the switch for which a member is there: sorted, apart, and not all of them.
fn check_presence(item: &mut Item<'_>, presence: &Presence, most: Option<u64>) {
    let Presence::When(ranges) = presence else { return };
    let Some(most) = most else {
        item.push("it hangs on a switch that there is not");
        return;
    };
    let apart =
        |a: &RangeInclusive<u64>, b: &RangeInclusive<u64>| a.end().checked_add(1).is_some_and(|next| next < *b.start());
    let legal = ranges.iter().all(|range| range.start() <= range.end() && *range.end() <= most);
    let some = !ranges.is_empty() && *ranges != [0..=most];
    item.unless(
        legal && some && ranges.is_sorted_by(apart),
        "the values of its switch are not sorted and apart, or all",
    );
}

/// Whether two members have bits in common in one layout.
fn share_bits(a: &Member, b: &Member) -> bool {
    let together = match (&a.presence, &b.presence) {
        (Presence::When(a), Presence::When(b)) => {
            a.iter().any(|a| b.iter().any(|b| a.start() <= b.end() && b.start() <= a.end()))
        }
        _ => true,
    };
    let bits = |member: &Member| mask(member.at, member.width, member.repeat);
    together && bits(a) & bits(b) != 0
}
