//! One `<bits>` or `<reserved>`: where it lies.

use std::ops::RangeInclusive;

use super::words::Words;
use super::{meaning, ranges};
use crate::diag::{Code, Diagnostic};
use crate::ir::{Member, Presence, Repeat, mask};
use crate::resolve::message_scope::MessageScope;
use crate::resolve::number::count;
use crate::resolve::origin::or_empty;
use crate::resolve::{boolean, names};
use crate::syntax::Text;
use crate::syntax::overlay::{self, Bits};

/// A part of a layout.
pub(super) struct PlacedBits<'a> {
    /// The bits it covers.
    pub(super) mask: u128,
    /// Where it says where it begins.
    pub(super) at: &'a Text,
    /// The member, if it is one and is clear, with its element.
    pub(super) member: Option<(Member, &'a Bits)>,
    /// Its name, if it has one.
    name: Option<&'a Text>,
}

impl PlacedBits<'_> {
    pub(super) fn title(&self) -> String {
        self.name.map_or_else(|| "reserved bits".to_owned(), |name| format!("`{}`", name.value))
    }
}

/// Resolves a piece. `None` if it is not clear where it lies; what else is wrong leaves it without a member.
pub(super) fn resolve<'a>(
    scope: &mut MessageScope<'_, 'a>,
    element: &'a overlay::Piece,
    words: &Words,
) -> Option<PlacedBits<'a>> {
    match element {
        overlay::Piece::Reserved(reserved) => {
            let (at, width) = place(scope, &reserved.at, &reserved.width, words)?;
            Some(PlacedBits { mask: mask(at, width, None), at: &reserved.at, member: None, name: None })
        }
        overlay::Piece::Bits(bits) => {
            let (at, width) = place(scope, &bits.at, &bits.width, words)?;
            let repeat = repeat(scope, bits, (at, width), words)?;
            let member = member(scope, bits, (at, width), repeat).map(|member| (member, &**bits));
            Some(PlacedBits { mask: mask(at, width, repeat), at: &bits.at, member, name: Some(&bits.name) })
        }
    }
}

fn member<'a>(
    scope: &mut MessageScope<'_, 'a>,
    bits: &'a Bits,
    (at, width): (u8, u8),
    repeat: Option<Repeat>,
) -> Option<Member> {
    let signed = boolean::of_overlay(&bits.signed, scope.diagnostics) == Some(true);
    let meaning = meaning::resolve(scope, bits, (width, signed))?;
    let (name, description) = (names::label(&bits.name), or_empty(&bits.description));
    Some(Member { name, at, width, signed, meaning, repeat, presence: Presence::Always, description })
}

/// The first bit and the width, inside of the words.
fn place(scope: &mut MessageScope<'_, '_>, at: &Text, width: &Text, words: &Words) -> Option<(u8, u8)> {
    let (first, count) = (number(scope, at), number(scope, width));
    let (first, count) = (first?, count?);
    if count == 0 {
        let problem = Diagnostic::new(Code::BitsPlace, width.span, "bits of no width");
        return scope.refuse(problem.help("the width is at least 1"));
    }
    let last = first.saturating_add(count - 1);
    if last >= u64::from(words.width) {
        return scope.refuse(beyond(at, first..=last, words));
    }
    Some((u8::try_from(first).ok()?, u8::try_from(count).ok()?))
}

/// Says that the words do not have these bits.
fn beyond(text: &Text, bits: RangeInclusive<u64>, words: &Words) -> Diagnostic {
    let what = if bits.start() == bits.end() { "bit" } else { "bits" };
    let message = format!("no room for {what} {}: the words end at bit {}", ranges::list(&[bits]), words.width - 1);
    let problem = Diagnostic::new(Code::BitsPlace, text.span, message);
    let problem = problem.related(words.span, format!("{} bits", words.width));
    problem.help("bit 0 is the least significant one of the first word")
}

fn number(scope: &mut MessageScope<'_, '_>, text: &Text) -> Option<u64> {
    let number = count(&text.value);
    if number.is_none() {
        let message = format!("`{}` is not a number of bits", text.value);
        scope.report(Diagnostic::new(Code::BadNumber, text.span, message).label("not a decimal number"));
    }
    number
}

/// `repeat` and `stride`; `None` if they make no sense.
fn repeat(
    scope: &mut MessageScope<'_, '_>,
    bits: &Bits,
    (at, width): (u8, u8),
    words: &Words,
) -> Option<Option<Repeat>> {
    let Some(text) = &bits.repeat else {
        if let Some(stride) = &bits.stride {
            let problem = Diagnostic::new(Code::Repeat, stride.span, "a `stride` without `repeat`");
            scope.report(problem.help("`repeat` says how many there are"));
        }
        return Some(None);
    };
    let (at, width) = (u64::from(at), u64::from(width));
    let count = number(scope, text)?;
    let stride = bits.stride.as_ref().map_or(Some(width), |stride| number(scope, stride))?;
    let last = count.saturating_sub(1).saturating_mul(stride).saturating_add(at + width - 1);
    let problem = if count < 2 {
        Diagnostic::new(Code::Repeat, text.span, format!("`repeat` is {count}")).help("at least 2, or no `repeat`")
    } else if stride < width {
        let message = format!("the stride {stride} is less than the width {width}: each would overlap the next");
        let place = bits.stride.as_ref().map_or(text.span, |stride| stride.span);
        let problem = Diagnostic::new(Code::Repeat, place, message).related(bits.width.span, "the width");
        problem.help("without a stride, one follows the other")
    } else if last >= u64::from(words.width) {
        beyond(text, at..=last, words)
    } else {
        return Some(Some(Repeat { count: u8::try_from(count).ok()?, stride: u8::try_from(stride).ok()? }));
    };
    scope.refuse(problem)
}
