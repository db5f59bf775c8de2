//! The members of a view: bits inside of its words, each with one meaning.

use std::ops::RangeInclusive;

use super::Item;
use crate::ir::{Meaning, Member, Presence, Repeat, Scaled, largest_of_bits, mask};

/// The widest integer that an enum, or the arithmetic of scaled values, can have.
const WIDEST: u8 = 64;

/// Checks the members of a view of so many bits; `most` is the largest value of its switch.
pub(super) fn check(item: &mut Item<'_>, members: &[Member], width: u8, most: Option<u64>) {
    for (at, member) in members.iter().enumerate() {
        let Member { name, at: _, width: _, signed: _, meaning, repeat, presence, description: _ } = member;
        let item = &mut item.part("member", &name.name);
        check_place(item, member, *repeat, width);
        check_meaning(item, member, meaning);
        check_presence(item, presence, most);
        let overlaps = members.iter().take(at).any(|before| share_bits(before, member));
        item.unless(!overlaps, "it has bits of a member that stands before it");
    }
}

fn check_place(item: &mut Item<'_>, member: &Member, repeat: Option<Repeat>, width: u8) {
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
