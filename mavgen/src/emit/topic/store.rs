//! How a topic is written: every field that a definition has, where it has it, in its type.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::field::{plain, unknown_element};
use super::load::part;
use crate::emit::token::{decimal, ident};
use crate::emit::ty::number_in;
use crate::rust::{Held, Move, Plain, Row, Topic, TopicField, TopicSlot, TopicType};

/// Statements that write a message, which begins at `base` of `p`; `source` is where it lies.
pub(super) fn all(source: &TokenStream, fields: &[Move<'_>], base: u32) -> TokenStream {
    let fields = fields.iter().map(|field| {
        let own = ident(field.slot.ident);
        let source = quote!(#source.#own);
        match &field.held {
            Held::Plain(stored, len) => {
                let (value, at) = (stored_as(field.slot, (*stored, *len), &source), decimal(base + field.at));
                quote!(put(p, #at, #value);)
            }
            Held::Messages(rows) => messages(field.slot, rows, &source, base),
        }
    });
    quote!(#(#fields)*)
}

fn messages(slot: TopicSlot<'_>, rows: &[Row<'_>], source: &TokenStream, base: u32) -> TokenStream {
    if let ([row], None) = (rows, slot.len) {
        return all(source, &row.fields, base + row.at);
    }
    let stored: u16 = rows.iter().map(|row| row.count).sum();
    let check = slot.len.zip(rows.first()).filter(|(len, _)| *len > stored).map(|(_, row)| {
        let (stored, of, name) = (decimal(stored), ident(row.ident), slot.ident);
        quote! {
            if !#source.iter().skip(#stored).all(#of::is_blank) {
                return Err(wire::uorb::CdrError::DoesNotFit { field: #name });
            }
        }
    });
    let rows = rows.iter().map(|row| {
        let Row { at, stride, len, .. } = row;
        let (at, stride, len, part) = (decimal(base + at), decimal(*stride), decimal(*len), part(row, slot));
        let fields = all(&quote!(one), &row.fields, 0);
        quote! {
            for (one, p) in #source.iter() #part .zip(wire::generated::elements_mut::<#len>(p, #at, #stride)) {
                #fields
            }
        }
    });
    quote!(#check #(#rows)*)
}

/// The value in the type and length that the definition has.
fn stored_as(slot: TopicSlot<'_>, (stored, len): (Plain, Option<u16>), source: &TokenStream) -> TokenStream {
    let (name, is_all) = (slot.ident, slot.len.unwrap_or(1) == len.unwrap_or(1));
    let is_same = slot.ty.plain() == Some(stored);
    let few = len.map(Literal::u16_unsuffixed);
    if stored == Plain::Char {
        let few = Literal::u16_unsuffixed(len.unwrap_or(1));
        return if is_all { source.clone() } else { quote!(wire::generated::first::<_, #few>(&#source.0, 0, #name)?) };
    }
    let mut value = match slot.ty {
        TopicType::Enum(one) if !(is_same && is_all) => match len {
            Some(_) => {
                let number = number_in(one.as_int(), &quote!(v));
                quote!(#source.map(|v| #number))
            }
            None => number_in(one.as_int(), source),
        },
        _ => source.clone(),
    };
    if !is_all {
        let unknown = unknown_element(slot);
        let unknown = match slot.ty {
            TopicType::Enum(one) => number_in(one.as_int(), &unknown),
            _ => unknown,
        };
        value = quote!(wire::generated::first::<_, #few>(&#value, #unknown, #name)?);
    }
    if !is_same {
        let of = plain(stored);
        value = match len {
            Some(_) => quote!(wire::generated::narrow_each::<#of, _, _>(#value, #name)?),
            None => quote!(wire::generated::narrow::<#of, _>(#value, #name)?),
        };
    }
    match (stored, len) {
        (Plain::Bool, Some(_)) => quote!(#value.map(u8::from)),
        (Plain::Bool, None) => quote!(u8::from(#value)),
        _ => value,
    }
}

/// Whether a topic says anything: what is left out of a definition with fewer elements must not.
pub(super) fn is_blank(topic: &Topic<'_>) -> TokenStream {
    let fields = topic.fields.iter().map(is_blank_field);
    quote! {
        #[doc = " Whether it says nothing."]
        pub(super) fn is_blank(&self) -> bool {
            #(#fields)&&*
        }
    }
}

fn is_blank_field(field: &TopicField<'_>) -> TokenStream {
    let (name, len) = (ident(field.slot.ident), field.slot.len);
    let value = quote!(self.#name);
    let blank = match field.slot.ty {
        TopicType::Message { .. } if len.is_none() => return quote!(#value.is_blank()),
        TopicType::Message { ident: of, .. } => {
            let of = ident(of);
            return quote!(#value.iter().all(#of::is_blank));
        }
        TopicType::Plain(Plain::Char) => quote!(wire::generated::is_blank(#value.0)),
        TopicType::Plain(_) => quote!(wire::generated::is_blank(#value)),
        TopicType::Enum(one) if len.is_none() => {
            let number = number_in(one.as_int(), &value);
            quote!(wire::generated::is_blank(#number))
        }
        TopicType::Enum(one) => {
            let number = number_in(one.as_int(), &quote!(v));
            quote!(wire::generated::is_blank(#value.map(|v| #number)))
        }
    };
    // NaN is blank in any case.
    let sentinel = matches!(field.slot.unknown, Some(crate::rust::Unknown::Is(_))).then(|| unknown_element(field.slot));
    match (sentinel, len.map(Literal::u16_unsuffixed)) {
        (None, _) => blank,
        (Some(sentinel), None) => quote!((#blank || #value == #sentinel)),
        (Some(sentinel), Some(len)) => quote!((#blank || #value == [#sentinel; #len])),
    }
}
