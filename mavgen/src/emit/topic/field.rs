//! A field of a topic: its declaration, its value where nothing is known, and its names.

use crate::emit::token::ident;
use crate::emit::ty::zero;
use crate::rust::{Plain, TopicField, TopicSlot, TopicType};
use crate::tokens::{ToTokens, TokenStream, quote};

/// `pub esc_rpm: i32,` with its documentation.
pub(super) fn declaration(TopicField { slot, docs, .. }: &TopicField<'_>) -> TokenStream {
    let ty = match (slot.ty, slot.len) {
        (TopicType::Plain(Plain::Char), len) => quote!(wire::Chars<#{len.unwrap_or(1)}>),
        (element, Some(len)) => quote!([#element; #len]),
        (element, None) => quote!(#element),
    };
    quote!(#docs pub #{ident(slot.ident)}: #ty,)
}

/// The type of one element; a `char` is a byte.
impl ToTokens for TopicType<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        match self {
            Self::Plain(one) => one.to_tokens(tokens),
            Self::Enum(one) => one.to_tokens(tokens),
            Self::Message(name) => ident(name).to_tokens(tokens),
        }
    }
}

/// The type of a scalar.
impl ToTokens for Plain {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        match self {
            Self::Int(one) => quote!(#one),
            Self::F32 => quote!(f32),
            Self::F64 => quote!(f64),
            Self::Bool => quote!(bool),
            Self::Char => quote!(u8),
        }
        .to_tokens(tokens);
    }
}

/// `esc_voltage: f32::NAN`
pub(super) fn unknown(TopicField { slot, .. }: &TopicField<'_>) -> TokenStream {
    let element = unknown_element(*slot);
    let value = match (slot.ty, slot.len) {
        (TopicType::Plain(Plain::Char), len) => quote!(wire::Chars([0; #{len.unwrap_or(1)}])),
        (_, Some(len)) => quote!([#element; #len]),
        (_, None) => element,
    };
    quote!(#{ident(slot.ident)}: #value)
}

/// One element of which nothing is known.
fn unknown_element(slot: TopicSlot<'_>) -> TokenStream {
    match (slot.unknown, slot.ty) {
        (Some(unknown), _) => quote!(#unknown),
        (None, TopicType::Plain(Plain::Int(_) | Plain::Char)) => quote!(0),
        (None, TopicType::Plain(Plain::F32 | Plain::F64)) => quote!(0.0),
        (None, TopicType::Plain(Plain::Bool)) => quote!(false),
        (None, TopicType::Enum(one)) => zero(one),
        (None, TopicType::Message(name)) => quote!(#{ident(name)}::UNKNOWN),
    }
}

/// `r#type`, `self_ = "self"`, `temperature was "temp"`: what binding by name needs beside the value where nothing is known.
pub(super) fn bound(TopicField { slot, named, was, .. }: &TopicField<'_>) -> TokenStream {
    quote!(#{ident(slot.ident)} #(if let Some(named) = named => = #named) #(if let Some(was) = was => was #was))
}
