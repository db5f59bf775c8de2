//! Types, and the numbers in values and out of them.

use super::token::{float, ident, integer};
use crate::rust::{Element, EnumType, Error, Int, Literal, Ty, Unknown};
use crate::tokens::{ToTokens, TokenStream, quote};

impl ToTokens for Int {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.push_token(&self.name());
    }
}

/// Its name.
impl ToTokens for EnumType<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        ident(self.ident).to_tokens(tokens);
    }
}

/// `u16`, `Option<MavState>`; `()` where nothing is given.
impl ToTokens for Ty<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        match self {
            Self::Int(int) => quote!(#int),
            Self::F32 => quote!(f32),
            Self::F64 => quote!(f64),
            Self::Bool => quote!(bool),
            Self::Usize => quote!(usize),
            Self::Unit => quote!(()),
            Self::Own => quote!(Self),
            Self::Enum(one) => quote!(#one),
            Self::Named(name) => ident(name),
            Self::Array(inner, length) => quote!([#inner; #length]),
            Self::Option(inner) => quote!(Option<#inner>),
            Self::Fallible(error) => quote!(Result<(), #error>),
            Self::Made(error) => quote!(Result<Self, #error>),
            Self::Params => quote!(&'static [wire::ParamInfo]),
            Self::Iterator(item) => quote!(impl Iterator<Item = #item> + '_),
        }
        .to_tokens(tokens);
    }
}

impl ToTokens for Error {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        match self {
            Self::OutOfRange => quote!(wire::OutOfRange),
            Self::View => quote!(wire::ViewError),
        }
        .to_tokens(tokens);
    }
}

/// `65535`, `MavAutopilot::AUTOQUAD`, `PodKind(7)`
impl ToTokens for Literal<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        match self {
            Self::Constant(one, constant) => quote!(#one::#{ident(constant)}),
            Self::Number(element, number) => value_of(*element, &integer(*number)),
            Self::Float(value) => float(*value),
        }
        .to_tokens(tokens);
    }
}

/// `65535`, `f32::NAN`
impl ToTokens for Unknown<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        match self {
            Self::Is(literal) => quote!(#literal),
            Self::NanF32 => quote!(f32::NAN),
            Self::NanF64 => quote!(f64::NAN),
        }
        .to_tokens(tokens);
    }
}

/// The integer in a value: `x`, `x.0`, `x.bits()`.
pub(super) fn number_in(element: Element<'_>, value: &TokenStream) -> TokenStream {
    match element {
        Element::Int(_) => value.clone(),
        Element::Enum(one) if one.flags => quote!(#value.bits()),
        Element::Enum(_) => quote!(#value.0),
        Element::F32 | Element::F64 => quote!(#value.to_bits()),
    }
}

/// The value of an integer: `n`, `T(n)`, `T::from_bits_retain(n)`.
pub(super) fn value_of(element: Element<'_>, number: &TokenStream) -> TokenStream {
    match element {
        Element::Int(_) => number.clone(),
        Element::Enum(one) => quote!(#{maker(one)}(#number)),
        Element::F32 => quote!(f32::from_bits(#number)),
        Element::F64 => quote!(f64::from_bits(#number)),
    }
}

/// What makes an enum of its integer: `T`, `T::from_bits_retain`.
pub(super) fn maker(of: EnumType<'_>) -> TokenStream {
    quote!(#of #(if of.flags => ::from_bits_retain))
}

/// The value of an enum that has no bits set.
pub(super) fn zero(of: EnumType<'_>) -> TokenStream {
    if of.flags { quote!(#of::empty()) } else { quote!(#of(0)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::EnumId;

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
            assert_eq!(number_in(element, &quote!(x)).to_string(), read);
            assert_eq!(value_of(element, &quote!(n)).to_string(), made);
        }
    }

    #[test]
    fn numbers_are_written_in_the_type_of_the_value() {
        for (given, expected) in [
            (Literal::Constant(tank(false), "FULL"), "Tank :: FULL"),
            (Literal::Number(Element::Enum(tank(false)), -1), "Tank ( - 1 )"),
            (Literal::Number(Element::Enum(tank(true)), 6), "Tank :: from_bits_retain ( 6 )"),
            (Literal::Number(Element::Int(Int::of_bits(16, false)), 65535), "65535"),
            (Literal::Float(-0.5), "- 0.5"),
        ] {
            assert_eq!(quote!(#given).to_string(), expected);
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
            assert_eq!(quote!(#given).to_string(), expected);
        }
    }
}
