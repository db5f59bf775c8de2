//! Getters and setters of named bits: masks, shifts, and the test for a layout.

use std::ops::RangeInclusive;

use crate::emit::token::{ident, mask};
use crate::emit::ty::{int, number_in, value_of};
use crate::ir::Repeat;
use crate::rust::{AsInt, BitField, Holds, Int, Present, Selector, Through};
use crate::tokens::{Literal, TokenStream, quote};

/// What the bits hold: `((self.bits >> 29) & 0x7fff) as u16`, `self.bits & (1 << 4) != 0`; in an `Option` where there may be none.
pub(in crate::emit) fn get(bits: &BitField<'_>) -> TokenStream {
    let value = match as_int(bits) {
        None => {
            let bit = At::of(bits).left(&quote!(1));
            quote!(self.bits & #bit != 0)
        }
        Some(as_int) => {
            let raw = read(bits.storage, &At::of(bits), bits.width, bits.raw);
            let wanted = int(as_int.int);
            let number = if bits.raw == as_int.int { raw } else { quote!((#raw) as #wanted) };
            value_of(as_int, &number)
        }
    };
    let there = bits.present.as_ref().map(|present| {
        let (selector, patterns) = (selector(bits.storage, present), patterns(present));
        quote! {
            match #selector {
                #patterns => Some(#value),
                _ => None,
            }
        }
    });
    match (bits.repeat.map(|repeat| Literal::of(repeat.count)), there) {
        (None, None) => value,
        (None, Some(there)) => there,
        (Some(count), None) => quote!(if index < #count { Some(#value) } else { None }),
        (Some(count), Some(there)) => quote!(if index < #count { #there } else { None }),
    }
}

/// Puts `value` into the bits if it fits, and if there are such bits.
pub(in crate::emit) fn set(bits: &BitField<'_>) -> TokenStream {
    let is_there = bits.present.as_ref().map(|present| {
        let (selector, patterns) = (selector(bits.storage, present), patterns(present));
        quote! {
            match #selector {
                #patterns => {}
                _ => return Err(wire::ViewError::Absent),
            }
        }
    });
    let is_one = bits.repeat.map(|repeat| {
        let count = Literal::of(repeat.count);
        quote!(if index >= #count { return Err(wire::ViewError::OutOfRange); })
    });
    let store = store(bits);
    quote!(#is_there #is_one #store)
}

/// What the bits hold as an integer; `None` for a flag.
fn as_int<'d>(bits: &BitField<'d>) -> Option<AsInt<'d>> {
    match bits.holds {
        Holds::Flag => None,
        Holds::Number => Some(AsInt { int: bits.raw, through: Through::Plain }),
        Holds::Enum(one) => Some(one.as_int()),
    }
}

fn store(bits: &BitField<'_>) -> TokenStream {
    let at = At::of(bits);
    let done = (!bits.always_sets()).then(|| quote!(Ok(())));
    let Some(as_int) = as_int(bits) else {
        let bit = at.left(&quote!(1));
        return quote! {
            self.bits = if value { self.bits | #bit } else { self.bits & !#bit };
            #done
        };
    };
    let number = number_in(as_int, &quote!(value));
    if as_int.int.bits() == bits.width {
        let bits = write(bits, &at, &number, as_int.int);
        return quote! {
            self.bits = #bits;
            #done
        };
    }
    let (range, bits) = (raw_range(bits), write(bits, &at, &quote!(raw), as_int.int));
    quote! {
        match #number {
            raw @ #range => {
                self.bits = #bits;
                Ok(())
            }
            _ => Err(wire::ViewError::OutOfRange),
        }
    }
}

/// The raw number: `((self.bits >> 29) & 0x7fff) as u16`.
fn read(storage: Int, at: &At, width: u8, raw: Int) -> TokenStream {
    let shifted = at.right(&quote!(self.bits));
    // An integer that is exactly as wide takes no more bits than it should: the cast drops the others.
    let number = if width == raw.bits() {
        shifted
    } else {
        let mask = mask_of(width);
        quote!((#shifted & #mask))
    };
    let unsigned = int(raw.unsigned());
    let number = if raw.unsigned() == storage { number } else { quote!((#number as #unsigned)) };
    if !raw.is_signed() {
        return number.without_parentheses();
    }
    // Two's complement: the sign bit goes to the top, and comes back with its copies.
    let signed = int(raw);
    match raw.bits() - width {
        0 => quote!(#number as #signed),
        spare => {
            let spare = Literal::of(spare);
            quote!(((#number << #spare) as #signed) >> #spare)
        }
    }
}

/// `(self.bits & !(0x7fff << 29)) | ((raw as u64) << 29)`
fn write(bits: &BitField<'_>, at: &At, number: &TokenStream, of: Int) -> TokenStream {
    let (storage, mask) = (int(bits.storage), mask_of(bits.width));
    if bits.width == bits.storage.bits() {
        return if of == bits.storage { number.clone() } else { quote!(#number as #storage) };
    }
    let number = if of == bits.storage { number.clone() } else { quote!((#number as #storage)) };
    let number = if of.is_signed() { quote!((#number & #mask)) } else { number };
    let (place, value) = (at.left(&mask), at.left(&number));
    quote!((self.bits & !#place) | #value)
}

/// `0..=0xfff`, `-256..=255`: the raw numbers that fit.
pub(super) fn raw_range(bits: &BitField<'_>) -> TokenStream {
    if !bits.raw.is_signed() {
        let mask = mask_of(bits.width);
        return quote!(0..=#mask);
    }
    let end = 1_u128 << (bits.width.max(1) - 1);
    let (start, last) = (Literal::of(end), Literal::of(end - 1));
    quote!(-#start..=#last)
}

/// `0xfff`
fn mask_of(width: u8) -> TokenStream {
    mask(u128::MAX >> (128 - width.clamp(1, 128)))
}

/// The value that selects the layout: `self.data_version`.
fn selector(storage: Int, present: &Present<'_>) -> TokenStream {
    match present.selector {
        Selector::Field(name) => {
            let name = ident(name);
            quote!(self.#name)
        }
        Selector::Bits { at, width } => read(storage, &At::Bit(at), width, Int::of_bits(width, false)),
    }
}

/// `3..=9 | 30..=255`
fn patterns(present: &Present<'_>) -> TokenStream {
    let patterns = present.ranges.iter().map(pattern);
    quote!(#(#patterns)|*)
}

fn pattern(range: &RangeInclusive<u64>) -> TokenStream {
    let (start, end) = (Literal::of(*range.start()), Literal::of(*range.end()));
    if range.start() == range.end() { quote!(#start) } else { quote!(#start..=#end) }
}

/// Where bits begin.
enum At {
    /// At this bit.
    Bit(u8),
    /// At the bit that this expression gives.
    Computed(TokenStream),
}

impl At {
    fn of(bits: &BitField<'_>) -> Self {
        match bits.repeat {
            None => Self::Bit(bits.at),
            Some(Repeat { stride, .. }) => Self::Computed(position(bits.at, stride)),
        }
    }

    fn right(&self, value: &TokenStream) -> TokenStream {
        match self {
            Self::Bit(0) => value.clone(),
            Self::Bit(at) => {
                let at = Literal::of(*at);
                quote!((#value >> #at))
            }
            Self::Computed(at) => quote!((#value >> (#at))),
        }
    }

    fn left(&self, value: &TokenStream) -> TokenStream {
        match self {
            Self::Bit(0) => value.clone(),
            Self::Bit(at) => {
                let at = Literal::of(*at);
                quote!((#value << #at))
            }
            Self::Computed(at) => quote!((#value << (#at))),
        }
    }
}

/// `3 + index * 2`
fn position(at: u8, stride: u8) -> TokenStream {
    let (start, step) = (Literal::of(at), Literal::of(stride));
    match (at, stride) {
        (0, 1) => quote!(index),
        (0, _) => quote!(index * #step),
        (_, 1) => quote!(#start + index),
        _ => quote!(#start + index * #step),
    }
}
