//! Types, and the numbers in values and out of them.

use super::token::{decimal, float, ident, integer};
use crate::rust::{AsInt, EnumType, Error, Int, Literal, Through, Ty};
use crate::tokens::{Ident, TokenStream, quote};

pub(super) fn int(int: Int) -> Ident {
    ident(int.name())
}

/// `u16`, `Option<MavState>`; `()` where nothing is given.
pub(super) fn ty(of: &Ty<'_>) -> TokenStream {
    match of {
        Ty::Int(one) => {
            let name = int(*one);
            quote!(#name)
        }
        Ty::F32 => quote!(f32),
        Ty::F64 => quote!(f64),
        Ty::Bool => quote!(bool),
        Ty::Usize => quote!(usize),
        Ty::Unit => quote!(()),
        Ty::Own => quote!(Self),
        Ty::Enum(one) => named(one.ident),
        Ty::Named(name) => named(name),
        Ty::Array(inner, length) => {
            let (inner, length) = (ty(inner), decimal(*length));
            quote!([#inner; #length])
        }
        Ty::Option(inner) => {
            let inner = ty(inner);
            quote!(Option<#inner>)
        }
        Ty::Fallible(error) => result(&quote!(()), *error),
        Ty::Made(error) => result(&quote!(Self), *error),
        Ty::Params => quote!(&'static [wire::ParamInfo]),
        Ty::Iterator(item) => {
            let item = ty(item);
            quote!(impl Iterator<Item = #item> + '_)
        }
    }
}

fn result(of: &TokenStream, error: Error) -> TokenStream {
    match error {
        Error::OutOfRange => quote!(Result<#of, wire::OutOfRange>),
        Error::View => quote!(Result<#of, wire::ViewError>),
    }
}

fn named(name: &str) -> TokenStream {
    let name = ident(name);
    quote!(#name)
}

/// The integer in a value: `x`, `x.0`, `x.bits()`.
pub(super) fn number_in(as_int: AsInt<'_>, value: &TokenStream) -> TokenStream {
    match as_int.through {
        Through::Plain => value.clone(),
        Through::Open(_) => quote!(#value.0),
        Through::Flags(_) => quote!(#value.bits()),
        Through::Float | Through::Double => quote!(#value.to_bits()),
    }
}

/// The value of an integer: `n`, `T(n)`, `T::from_bits_retain(n)`.
pub(super) fn value_of(as_int: AsInt<'_>, number: &TokenStream) -> TokenStream {
    match as_int.through {
        Through::Plain => number.clone(),
        Through::Open(one) | Through::Flags(one) => {
            let maker = maker(one);
            quote!(#maker(#number))
        }
        Through::Float => quote!(f32::from_bits(#number)),
        Through::Double => quote!(f64::from_bits(#number)),
    }
}

/// What makes an enum of its integer: `T`, `T::from_bits_retain`.
pub(super) fn maker(of: EnumType<'_>) -> TokenStream {
    let ty = ident(of.ident);
    if of.flags { quote!(#ty::from_bits_retain) } else { quote!(#ty) }
}

/// `65535`, `MavAutopilot::AUTOQUAD`, `PodKind(7)`
pub(super) fn literal(literal: Literal<'_>) -> TokenStream {
    match literal {
        Literal::Constant(one, constant) => {
            let (ty, constant) = (ident(one.ident), ident(constant));
            quote!(#ty::#constant)
        }
        Literal::Number(as_int, number) => value_of(as_int, &integer(number)),
        Literal::Float(value) => float(value),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::EnumId;
    use crate::rust::{Element, EnumType};

    fn tank(flags: bool) -> EnumType<'static> {
        EnumType { id: EnumId(0), ident: "Tank", int: Int::of_bits(16, true), flags, deprecated: false }
    }

    #[test]
    fn every_element_is_read_and_made_by_its_number() {
        for (element, read, made) in [
            (Element::Int(Int::of_bits(8, false)), "x", "n"),
            (Element::F32, "x . to_bits ( )", "f32 :: from_bits ( n )"),
            (Element::F64, "x . to_bits ( )", "f64 :: from_bits ( n )"),
            (Element::Enum(tank(false)), "x . 0", "Tank ( n )"),
            (Element::Enum(tank(true)), "x . bits ( )", "Tank :: from_bits_retain ( n )"),
        ] {
            assert_eq!(number_in(element.as_int(), &quote!(x)).to_string(), read);
            assert_eq!(value_of(element.as_int(), &quote!(n)).to_string(), made);
        }
    }

    #[test]
    fn numbers_are_written_in_the_type_of_the_value() {
        for (given, expected) in [
            (Literal::Constant(tank(false), "FULL"), "Tank :: FULL"),
            (Literal::Number(tank(false).as_int(), -1), "Tank ( - 1 )"),
            (Literal::Number(tank(true).as_int(), 6), "Tank :: from_bits_retain ( 6 )"),
            (Literal::Number(Element::Int(Int::of_bits(16, false)).as_int(), 65535), "65535"),
            (Literal::Float(-0.5), "- 0.5"),
        ] {
            assert_eq!(literal(given).to_string(), expected);
        }
    }

    #[test]
    fn types_are_spelled_as_signatures_have_them() {
        let named = Ty::Named("Esc");
        for (given, expected) in [
            (Ty::Enum(tank(false)).optional(true), "Option < Tank >"),
            (Ty::Array(Box::new(Ty::F32), 4).optional(true), "Option < [ f32 ; 4 ] >"),
            (Ty::Fallible(Error::View), "Result < ( ) , wire :: ViewError >"),
            (Ty::Fallible(Error::OutOfRange), "Result < ( ) , wire :: OutOfRange >"),
            (Ty::Iterator(Box::new(named)), "impl Iterator < Item = Esc > + '_"),
        ] {
            assert_eq!(ty(&given).to_string(), expected);
        }
    }
}
