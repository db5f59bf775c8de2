//! Getters and setters beside the plain fields: for sentinels ("not known"), and for enums in fields of another width.
//!
//! All of them are inlined: there are hundreds, of which a program uses a few, and code that is not made costs no build time.

use crate::emit::token::ident;
use crate::emit::ty::{maker, number_in, value_of};
use crate::rust::{Convert, Element, Extent, Sentinel, Unknown};
use crate::tokens::{TokenStream, quote};

/// The value, if it is known: `if self.temperature == 32767 { None } else { Some(self.temperature) }`.
pub(in crate::emit) fn get(Sentinel { field, unknown, extent }: &Sentinel<'_>) -> TokenStream {
    let (field, known) = (ident(field), is_known(*unknown));
    match extent {
        Extent::Each => quote!(self.#field.get(index).copied().filter(|&v| #known)),
        Extent::First => quote!(self.#field.get(index).copied().filter(|&v| index != 0 || #known)),
        Extent::Scalar | Extent::Whole(_) => {
            let value = quote!(self.#field #(if *extent != Extent::Scalar => [0]));
            quote!(if #{is_unknown(*unknown, &value)} { None } else { Some(self.#field) })
        }
    }
}

/// The elements, each if it is known.
pub(in crate::emit) fn iter(Sentinel { field, unknown, extent }: &Sentinel<'_>) -> TokenStream {
    let (field, known) = (ident(field), is_known(*unknown));
    match extent {
        Extent::First => quote!(self.#field.iter().enumerate().map(|(index, &v)| (index != 0 || #known).then_some(v))),
        _ => quote!(self.#field.iter().map(|&v| (#known).then_some(v))),
    }
}

/// Puts the value, or what says that it is not known, into the field: `self.temperature = value.unwrap_or(32767);`.
pub(in crate::emit) fn set(Sentinel { field, unknown, extent }: &Sentinel<'_>) -> TokenStream {
    match extent {
        Extent::Scalar => quote!(self.#{ident(field)} = value.unwrap_or(#unknown);),
        Extent::Whole(length) => quote!(self.#{ident(field)} = value.unwrap_or([#unknown; #length]);),
        Extent::Each | Extent::First => set_element(field, &quote!(value.unwrap_or(#unknown))),
    }
}

fn set_element(field: &str, value: &TokenStream) -> TokenStream {
    quote! {
        let element = self.#{ident(field)}.get_mut(index).ok_or(wire::OutOfRange)?;
        *element = #value;
        Ok(())
    }
}

/// The number as the enum, if it is known and one.
pub(in crate::emit) fn get_enum(convert: &Convert<'_>) -> TokenStream {
    let (field, enum_int, to) = (ident(convert.field), convert.to.int, Element::Enum(convert.to));
    if !convert.is_optional() {
        return value_of(to, &quote!(#enum_int::from(self.#field)));
    }
    let number = match convert.element {
        true => quote!(self.#field.get(index).copied()),
        false => quote!(Some(self.#field)),
    };
    let filter = convert.unknown.map(is_known).map(|known| quote!(.filter(|&v| #known)));
    match convert.always_gets() {
        true => quote!(#number #filter.map(|v| #{value_of(to, &quote!(#enum_int::from(v)))})),
        false => quote!(#number #filter.and_then(|v| #enum_int::try_from(v).ok()).map(#{maker(convert.to)})),
    }
}

/// Puts the number of the enum into the field, if it fits.
pub(in crate::emit) fn set_enum(convert: &Convert<'_>) -> TokenStream {
    let (own, number) = (convert.int, number_in(Element::Enum(convert.to), &quote!(value)));
    let number = match convert.always_sets() {
        true => quote!(#own::from(#number)),
        false => quote!(#own::try_from(#number).map_err(|_| wire::OutOfRange)?),
    };
    match convert.element {
        true => set_element(convert.field, &number),
        false => quote!(self.#{ident(convert.field)} = #number; #(if !convert.always_sets() => Ok(()))),
    }
}

/// `self.x == 65535`, `self.x.is_nan()`
fn is_unknown(unknown: Unknown<'_>, value: &TokenStream) -> TokenStream {
    match unknown {
        Unknown::Is(sentinel) => quote!(#value == #sentinel),
        Unknown::NanF32 | Unknown::NanF64 => quote!(#value.is_nan()),
    }
}

/// `v != 65535`, `!v.is_nan()`
fn is_known(unknown: Unknown<'_>) -> TokenStream {
    match unknown {
        Unknown::Is(sentinel) => quote!(v != #sentinel),
        Unknown::NanF32 | Unknown::NanF64 => quote!(!v.is_nan()),
    }
}
