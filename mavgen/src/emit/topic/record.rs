//! How a topic is read from a record of a log, by the places that were bound to its fields, and written as one.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::field::unknown_element;
use super::store;
use crate::emit::token::{decimal, ident};
use crate::emit::ty::{maker, number_in};
use crate::rust::{Plain, Topic, TopicField, TopicType};

/// The function that reads a record.
pub(super) fn read(topic: &Topic<'_>) -> TokenStream {
    let count = decimal(topic.fields.len() as u64);
    let mut nested = topic.fields.len();
    let fields = topic.fields.iter().enumerate().map(|(at, field)| {
        let begins = nested;
        nested += field.slot.places() - 1;
        let (name, value) = (ident(field.slot.ident), value(field, at, (begins, nested)));
        quote!(#name: #value)
    });
    let fields: Vec<TokenStream> = fields.collect();
    quote! {
        fn read(places: &[wire::uorb::Place], record: &[u8]) -> Self {
            let Some((p, _)) = places.split_first_chunk::<#count>() else { return Self::UNKNOWN };
            Self { #(#fields),* }
        }
    }
}

/// A field by its place, and by those of what it nests.
fn value(field: &TopicField<'_>, at: usize, (begins, ends): (usize, usize)) -> TokenStream {
    let (place, unknown) = (decimal(at as u64), unknown_element(field.slot));
    match (field.slot.ty, field.slot.len) {
        (TopicType::Plain(Plain::Char), len) => {
            let len = Literal::u16_unsuffixed(len.unwrap_or(1));
            quote!(p[#place].array::<_, #len>(record, wire::uorb::Char(0)).into())
        }
        (TopicType::Plain(_), None) => quote!(p[#place].get(record).unwrap_or(#unknown)),
        (TopicType::Plain(_), Some(_)) => quote!(p[#place].array(record, #unknown)),
        (TopicType::Enum(one), None) => {
            let maker = maker(one);
            quote!(p[#place].get(record).map_or(#unknown, #maker))
        }
        (TopicType::Enum(one), Some(_)) => {
            let (maker, number) = (maker(one), number_in(one.as_int(), &unknown));
            quote!(p[#place].array(record, #number).map(#maker))
        }
        (TopicType::Message { .. }, len) => {
            let (begins, ends) = (decimal(begins as u64), decimal(ends as u64));
            let places = quote!(places.get(#begins..#ends).unwrap_or_default());
            if len.is_some() {
                quote!(p[#place].messages(record, #places))
            } else {
                quote!(p[#place].message(record, #places))
            }
        }
    }
}

/// The function that writes a record.
pub(super) fn store(topic: &Topic<'_>) -> TokenStream {
    let length = decimal(topic.definitions.first().map_or(0, |newest| newest.record_len));
    let stores = store::all(&quote!(self), &topic.record, 0);
    quote! {
        fn store_record(&self, record: &mut [u8]) -> Result<(), wire::uorb::CdrError> {
            let p = wire::generated::body_mut::<#length>(record)?;
            #stores
            Ok(())
        }
    }
}
