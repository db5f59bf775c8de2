//! A field of a topic: its declaration, its value where nothing is known, and its names.

use crate::emit::doc;
use crate::emit::token::ident;
use crate::emit::ty::{int, literal};
use crate::rust::{Plain, TopicField, TopicSlot, TopicType, Unknown};
use crate::tokens::{Literal, TokenStream, quote};

/// `pub esc_rpm: i32,` with its documentation.
pub(super) fn declaration(field: &TopicField<'_>) -> TokenStream {
    let (docs, name) = (doc::documentation(&field.docs), ident(field.slot.ident));
    let element = element(field.slot.ty);
    let ty = match (field.slot.ty, field.slot.len) {
        (TopicType::Plain(Plain::Char), len) => {
            let len = Literal::of(len.unwrap_or(1));
            quote!(wire::Chars<#len>)
        }
        (_, Some(len)) => {
            let len = Literal::of(len);
            quote!([#element; #len])
        }
        (_, None) => element,
    };
    quote!(#docs pub #name: #ty,)
}

/// The type of one element; a `char` is a byte.
pub(super) fn element(ty: TopicType<'_>) -> TokenStream {
    match ty {
        TopicType::Plain(one) => plain(one),
        TopicType::Enum(one) => {
            let name = ident(one.ident);
            quote!(#name)
        }
        TopicType::Message(name) => {
            let name = ident(name);
            quote!(#name)
        }
    }
}

/// The type of a scalar.
pub(super) fn plain(plain: Plain) -> TokenStream {
    match plain {
        Plain::Int(one) => {
            let name = int(one);
            quote!(#name)
        }
        Plain::F32 => quote!(f32),
        Plain::F64 => quote!(f64),
        Plain::Bool => quote!(bool),
        Plain::Char => quote!(u8),
    }
}

/// `esc_voltage: f32::NAN`
pub(super) fn unknown(field: &TopicField<'_>) -> TokenStream {
    let (name, element) = (ident(field.slot.ident), unknown_element(field.slot));
    let value = match (field.slot.ty, field.slot.len) {
        (TopicType::Plain(Plain::Char), len) => {
            let len = Literal::of(len.unwrap_or(1));
            quote!(wire::Chars([0; #len]))
        }
        (_, Some(len)) => {
            let len = Literal::of(len);
            quote!([#element; #len])
        }
        (_, None) => element,
    };
    quote!(#name: #value)
}

/// One element of which nothing is known.
fn unknown_element(slot: TopicSlot<'_>) -> TokenStream {
    match (slot.unknown, slot.ty) {
        (Some(Unknown::Is(sentinel)), _) => literal(sentinel),
        (Some(Unknown::NanF32), _) => quote!(f32::NAN),
        (Some(Unknown::NanF64), _) => quote!(f64::NAN),
        (None, TopicType::Plain(Plain::Int(_) | Plain::Char)) => quote!(0),
        (None, TopicType::Plain(Plain::F32 | Plain::F64)) => quote!(0.0),
        (None, TopicType::Plain(Plain::Bool)) => quote!(false),
        (None, TopicType::Enum(one)) => {
            let name = ident(one.ident);
            if one.flags { quote!(#name::empty()) } else { quote!(#name(0)) }
        }
        (None, TopicType::Message(name)) => {
            let name = ident(name);
            quote!(#name::UNKNOWN)
        }
    }
}

/// `r#type`, `self_ = "self"`, `temperature was "temp"`: what binding by name needs beside the value where nothing is known.
pub(super) fn bound(field: &TopicField<'_>) -> TokenStream {
    let name = ident(field.slot.ident);
    let named = field.named.map(|named| quote!(= #named));
    let was = field.was.map(|was| quote!(was #was));
    quote!(#name #named #was)
}
