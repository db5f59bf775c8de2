//! Getters and setters of named bits: masks, shifts, and the test for a layout.

use crate::emit::token::{ident, mask};
use crate::emit::ty::{number_in, value_of};
use crate::ir::Repeat;
use crate::rust::{BitField, Element, Holds, Int, Present, Selector};
use crate::tokens::{TokenStream, quote};

/// What the bits hold: `((self.bits >> 29) & 0x7fff) as u16`, `self.bits & (1 << 4) != 0`; in an `Option` where there may be none.
pub(in crate::emit) fn get(bits: &BitField<'_>) -> TokenStream {
    let value = match element(bits) {
        None => quote!(self.bits & #{shifted(&quote!(1), &quote!(<<), &place(bits))} != 0),
        Some(element) => {
            let (raw, wanted) = (read(bits.storage, &place(bits), bits.width, bits.raw), element.int());
            let number = if bits.raw == wanted { raw } else { quote!((#raw) as #wanted) };
            value_of(element, &number)
        }
    };
    let value = match &bits.present {
        Some(present) => {
            let (selector, patterns) = (selector(bits.storage, present), patterns(present));
            quote!(match #selector { #patterns => Some(#value), _ => None, })
        }
        None if bits.repeat.is_some() => quote!(Some(#value)),
        None => value,
    };
    match bits.repeat {
        Some(Repeat { count, .. }) => quote!(if index < #count { #value } else { None }),
        None => value,
    }
}

/// Puts `value` into the bits if it fits, and if there are such bits.
pub(in crate::emit) fn set(bits: &BitField<'_>) -> TokenStream {
    quote! {
        #(if let Some(present) = &bits.present => match #{selector(bits.storage, present)} {
            #{patterns(present)} => {}
            _ => return Err(wire::ViewError::Absent),
        })
        #(if let Some(Repeat { count, .. }) = bits.repeat =>
            if index >= #count { return Err(wire::ViewError::OutOfRange); })
        #{store(bits)}
    }
}

/// What the bits hold as an integer; `None` for a flag.
fn element<'d>(bits: &BitField<'d>) -> Option<Element<'d>> {
    match bits.holds {
        Holds::Flag => None,
        Holds::Number => Some(Element::Int(bits.raw)),
        Holds::Enum(one) => Some(Element::Enum(one)),
    }
}

fn store(bits: &BitField<'_>) -> TokenStream {
    let place = place(bits);
    let value = match element(bits) {
        None => {
            let bit = shifted(&quote!(1), &quote!(<<), &place);
            quote!(if value { self.bits | #bit } else { self.bits & !#bit })
        }
        Some(element) => {
            let number = number_in(element, &quote!(value));
            if element.int().bits() != bits.width {
                return quote! {
                    match #number {
                        raw @ #{raw_range(bits)} => {
                            self.bits = #{write(bits, &place, &quote!(raw), element.int())};
                            Ok(())
                        }
                        _ => Err(wire::ViewError::OutOfRange),
                    }
                };
            }
            write(bits, &place, &number, element.int())
        }
    };
    quote!(self.bits = #value; #(if !bits.always_sets() => Ok(())))
}

/// The raw number: `((self.bits >> 29) & 0x7fff) as u16`.
fn read(storage: Int, place: &Option<TokenStream>, width: u8, raw: Int) -> TokenStream {
    let (bits, unsigned) = (quote!(self.bits), raw.unsigned());
    // An integer that is exactly as wide takes no more bits than it should: the cast drops the others.
    let number = match place {
        _ if width != raw.bits() => quote!(#{shifted(&bits, &quote!(>>), place)} & #{mask_of(width)}),
        Some(place) => quote!(self.bits >> #place),
        None => bits.clone(),
    };
    let inner = if number == bits { bits } else { quote!((#number)) };
    if !raw.is_signed() {
        return if unsigned == storage { number } else { quote!(#inner as #unsigned) };
    }
    let number = if unsigned == storage { inner } else { quote!((#inner as #unsigned)) };
    // Two's complement: the sign bit goes to the top, and comes back with its copies.
    match raw.bits() - width {
        0 => quote!(#number as #raw),
        spare => quote!(((#number << #spare) as #raw) >> #spare),
    }
}

/// `(self.bits & !(0x7fff << 29)) | ((raw as u64) << 29)`
fn write(bits: &BitField<'_>, place: &Option<TokenStream>, number: &TokenStream, of: Int) -> TokenStream {
    let (storage, mask) = (bits.storage, mask_of(bits.width));
    if bits.width == storage.bits() {
        return quote!(#number #(if of != storage => as #storage));
    }
    let number = if of == storage { number.clone() } else { quote!((#number as #storage)) };
    let number = if of.is_signed() { quote!((#number & #mask)) } else { number };
    let [own, value] = [mask, number].map(|bits| shifted(&bits, &quote!(<<), place));
    quote!((self.bits & !#own) | #value)
}

/// `0..=0xfff`, `-256..=255`: the raw numbers that fit.
pub(super) fn raw_range(bits: &BitField<'_>) -> TokenStream {
    if !bits.raw.is_signed() {
        return quote!(0..=#{mask_of(bits.width)});
    }
    let end = 1_u128 << (bits.width.max(1) - 1);
    quote!(-#end..=#{end - 1})
}

/// `0xfff`
fn mask_of(width: u8) -> TokenStream {
    mask(u128::MAX >> (128 - width.clamp(1, 128)))
}

/// The value that selects the layout: `self.data_version`.
fn selector(storage: Int, present: &Present<'_>) -> TokenStream {
    match present.selector {
        Selector::Field(name) => quote!(self.#{ident(name)}),
        Selector::Bits { at, width } => read(storage, &first(at), width, Int::of_bits(width, false)),
    }
}

/// `3..=9 | 30..=255`
fn patterns(present: &Present<'_>) -> TokenStream {
    let ranges = present.ranges.iter().map(|range| (range.start(), range.end()));
    quote!(#(for (start, end) in ranges => #start #(if start != end => ..=#end))|*)
}

/// Where bits begin: `29`, `(3 + index * 2)`; nothing at the first bit.
fn place(bits: &BitField<'_>) -> Option<TokenStream> {
    let Some(Repeat { stride, .. }) = bits.repeat else { return first(bits.at) };
    let start = first(bits.at).map(|at| quote!(#at +));
    Some(quote!((#start index #(if stride != 1 => * #stride))))
}

fn first(at: u8) -> Option<TokenStream> {
    (at != 0).then(|| quote!(#at))
}

/// `(self.bits >> 29)`, `(1 << 29)`
fn shifted(value: &TokenStream, shift: &TokenStream, place: &Option<TokenStream>) -> TokenStream {
    place.as_ref().map_or_else(|| value.clone(), |place| quote!((#value #shift #place)))
}
