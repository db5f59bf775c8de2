//! Bits in expressions: masks, shifts, and the test for a layout.

use std::ops::RangeInclusive;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::storage;
use crate::emit::token::{ident, mask};
use crate::ir::{Member, Presence, SwitchOn, View};

/// The integer of a member's raw number: the smallest that holds it.
pub(super) fn raw_type(member: &Member) -> Ident {
    let (sign, width) = (if member.signed { 'i' } else { 'u' }, integer_width(member.width));
    ident(&format!("{sign}{width}"))
}

/// Bits of the smallest integer for `width` bits.
pub(super) fn integer_width(width: u8) -> u8 {
    width.next_power_of_two().max(8)
}

/// `0xfff`
pub(super) fn mask_of(width: u8) -> TokenStream {
    let all = u128::MAX.checked_shr(128 - u32::from(width)).unwrap_or_default();
    u64::try_from(all).map_or_else(
        |_| {
            let hexadecimal = format!("{all:#x}").parse::<Literal>();
            hexadecimal.map_or_else(|_| quote!(u128::MAX), |literal| quote!(#literal))
        },
        mask,
    )
}

/// The raw number: `((self.bits >> 29) & 0x7fff) as u16`; with an offset `at` that is an expression for repeated bits.
pub(super) fn read(view: &View, at: &At, width: u8, raw: &Ident, signed: bool) -> TokenStream {
    let (storage, shifted) = (storage(view), at.right(&quote!(self.bits)));
    // An integer that is exactly as wide takes no more bits than it should: the cast drops the others.
    let number = if width == integer_width(width) {
        shifted
    } else {
        let mask = mask_of(width);
        quote!((#shifted & #mask))
    };
    let unsigned = ident(&format!("u{}", integer_width(width)));
    let number = if unsigned == storage { number } else { quote!((#number as #unsigned)) };
    if !signed {
        return unparenthesised(number);
    }
    // Two's complement: the sign bit goes to the top, and comes back with its copies.
    match integer_width(width) - width {
        0 => quote!(#number as #raw),
        spare => {
            let spare = Literal::u8_unsuffixed(spare);
            quote!(((#number << #spare) as #raw) >> #spare)
        }
    }
}

/// `(a & b)` without its outer parentheses, which only an operand needs.
fn unparenthesised(tokens: TokenStream) -> TokenStream {
    let mut trees = tokens.clone().into_iter();
    match (trees.next(), trees.next()) {
        (Some(proc_macro2::TokenTree::Group(group)), None)
            if group.delimiter() == proc_macro2::Delimiter::Parenthesis =>
        {
            group.stream()
        }
        _ => tokens,
    }
}

/// `(self.bits & !(0x7fff << 29)) | ((raw as u64) << 29)`
pub(super) fn write(view: &View, at: &At, width: u8, raw: &TokenStream, raw_type: &Ident) -> TokenStream {
    let (storage, mask) = (storage(view), mask_of(width));
    let number = if *raw_type == storage { quote!(#raw) } else { quote!((#raw as #storage)) };
    let number = if raw_type.to_string().starts_with('i') { quote!((#number & #mask)) } else { number };
    if width == view.width && width == integer_width(view.width) {
        return number;
    }
    let (place, value) = (at.left(&mask), at.left(&number));
    quote!((self.bits & !#place) | #value)
}

/// Where bits begin.
pub(super) enum At {
    /// At this bit.
    Bit(u8),
    /// At the bit that this expression gives.
    Computed(TokenStream),
}

impl At {
    fn right(&self, value: &TokenStream) -> TokenStream {
        match self {
            Self::Bit(0) => value.clone(),
            Self::Bit(at) => {
                let at = Literal::u8_unsuffixed(*at);
                quote!((#value >> #at))
            }
            Self::Computed(at) => quote!((#value >> (#at))),
        }
    }

    pub(super) fn left(&self, value: &TokenStream) -> TokenStream {
        match self {
            Self::Bit(0) => value.clone(),
            Self::Bit(at) => {
                let at = Literal::u8_unsuffixed(*at);
                quote!((#value << #at))
            }
            Self::Computed(at) => quote!((#value << (#at))),
        }
    }
}

/// The layouts that have a member: `match value { patterns => …, _ => … }`.
pub(super) struct Present {
    /// The value that selects the layout: `self.data_version`.
    pub(super) value: TokenStream,
    /// `3..=9 | 30..=255`
    pub(super) patterns: TokenStream,
}

/// The layouts that have a member; nothing for what is in every layout.
pub(super) fn present(view: &View, member: &Member) -> Option<Present> {
    let (Presence::When(ranges), Some(switch)) = (&member.presence, &view.switch) else { return None };
    let patterns = ranges.iter().map(pattern);
    let value = match switch.on {
        SwitchOn::Field(..) => {
            let name = ident(&switch.name.rust());
            quote!(self.#name)
        }
        SwitchOn::Bits { at, width } => {
            let raw = ident(&format!("u{}", integer_width(width)));
            read(view, &At::Bit(at), width, &raw, false)
        }
    };
    Some(Present { value, patterns: quote!(#(#patterns)|*) })
}

fn pattern(range: &RangeInclusive<u64>) -> TokenStream {
    let (start, end) = (Literal::u64_unsuffixed(*range.start()), Literal::u64_unsuffixed(*range.end()));
    if range.start() == range.end() { quote!(#start) } else { quote!(#start..=#end) }
}

/// `3..=9`, `30`
pub(super) fn range_text(range: &RangeInclusive<u64>) -> String {
    let (start, end) = (range.start(), range.end());
    if start == end { start.to_string() } else { format!("{start}..={end}") }
}
