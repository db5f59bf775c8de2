//! One `<bits>` or `<reserved>`: where it lies.

use std::ops::RangeInclusive;

use super::words::Words;
use super::{meaning, ranges, spelling, text};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Member, Presence, Repeat};
use crate::resolve::boolean;
use crate::resolve::message_scope::{EnumUse, MessageScope};
use crate::resolve::number::count;
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
    /// What a message calls it.
    pub(super) fn title(&self) -> String {
        self.name.map_or_else(|| "reserved bits".to_owned(), |name| format!("`{}`", name.value))
    }
}

/// Where bits lie.
#[derive(Clone, Copy)]
pub(super) struct Extent {
    /// The first bit.
    pub(super) at: u8,
    /// How many.
    pub(super) width: u8,
    /// Several alike.
    pub(super) repeat: Option<Repeat>,
}

impl Extent {
    fn mask(self) -> u128 {
        let one = (u128::MAX >> (128 - u32::from(self.width))) << self.at;
        let Repeat { count, stride } = self.repeat.unwrap_or(Repeat { count: 1, stride: 0 });
        (0..u32::from(count)).fold(0, |mask, index| mask | one << (index * u32::from(stride)))
    }
}

/// Resolves a piece. `None` if it is not clear where it lies; what else is wrong leaves it without a member.
pub(super) fn resolve<'a>(
    scope: &MessageScope<'_, 'a>,
    element: &'a overlay::Piece,
    words: &Words,
    enum_uses: &mut Vec<EnumUse<'a>>,
    diagnostics: &mut Diagnostics,
) -> Option<PlacedBits<'a>> {
    match element {
        overlay::Piece::Reserved(reserved) => {
            let (at, width) = place(&reserved.at, &reserved.width, words, diagnostics)?;
            let mask = Extent { at, width, repeat: None }.mask();
            Some(PlacedBits { mask, at: &reserved.at, member: None, name: None })
        }
        overlay::Piece::Bits(bits) => {
            let (at, width) = place(&bits.at, &bits.width, words, diagnostics)?;
            let extent = Extent { at, width, repeat: repeat(bits, (at, width), words, diagnostics)? };
            let member = member(scope, bits, extent, enum_uses, diagnostics).map(|member| (member, &**bits));
            Some(PlacedBits { mask: extent.mask(), at: &bits.at, member, name: Some(&bits.name) })
        }
    }
}

fn member<'a>(
    scope: &MessageScope<'_, 'a>,
    bits: &'a Bits,
    extent: Extent,
    enum_uses: &mut Vec<EnumUse<'a>>,
    diagnostics: &mut Diagnostics,
) -> Option<Member> {
    let signed = bits.signed.as_ref().and_then(|text| boolean::of_overlay(text, diagnostics)) == Some(true);
    let meaning = meaning::resolve(scope, bits, (extent.width, signed), enum_uses, diagnostics)?;
    Some(Member {
        name: spelling::label(&bits.name),
        at: extent.at,
        width: extent.width,
        signed,
        meaning,
        repeat: extent.repeat,
        presence: Presence::Always,
        description: text::or_empty(bits.description.as_ref()),
    })
}

/// The first bit and the width, inside of the words.
fn place(at: &Text, width: &Text, words: &Words, diagnostics: &mut Diagnostics) -> Option<(u8, u8)> {
    let (first, count) = (number(at, diagnostics), number(width, diagnostics));
    let (first, count) = (first?, count?);
    if count == 0 {
        let problem = Diagnostic::new(Code::BitsPlace, width.span, "bits of no width");
        diagnostics.push(problem.help("the width is at least 1"));
        return None;
    }
    let last = first.saturating_add(count - 1);
    if last >= u64::from(words.width) {
        diagnostics.push(beyond(at, first..=last, words));
        return None;
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

fn number(text: &Text, diagnostics: &mut Diagnostics) -> Option<u64> {
    let number = count(&text.value);
    if number.is_none() {
        let message = format!("`{}` is not a number of bits", text.value);
        diagnostics.push(Diagnostic::new(Code::BadNumber, text.span, message).label("not a decimal number"));
    }
    number
}

/// `repeat` and `stride`; `None` if they make no sense.
fn repeat(bits: &Bits, (at, width): (u8, u8), words: &Words, diagnostics: &mut Diagnostics) -> Option<Option<Repeat>> {
    let Some(text) = &bits.repeat else {
        if let Some(stride) = &bits.stride {
            let problem = Diagnostic::new(Code::Repeat, stride.span, "a `stride` without `repeat`");
            diagnostics.push(problem.help("`repeat` says how many there are"));
        }
        return Some(None);
    };
    let (at, width) = (u64::from(at), u64::from(width));
    let count = number(text, diagnostics)?;
    let stride = bits.stride.as_ref().map_or(Some(width), |stride| number(stride, diagnostics))?;
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
    diagnostics.push(problem);
    None
}
