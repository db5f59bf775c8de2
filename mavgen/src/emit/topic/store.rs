//! How a topic is written: every field that a definition has, where it has it, in its type.

use super::load::cut;
use crate::emit::token::ident;
use crate::emit::ty::number_in;
use crate::rust::{Element, Held, Move, Part, Plain, Row, Scalars, TopicSlot, TopicType};
use crate::tokens::{TokenStream, quote};

/// Statements that write a message into `p`; `source` is where it lies.
pub(super) fn all(part: &Part<'_>, source: &TokenStream) -> TokenStream {
    let of = ident(part.ident);
    let statement = |Move { slot, at, held, .. }: &Move<'_>| {
        let own = ident(slot.ident);
        let (source, unknown) = (quote!(#source.#own), quote!(#of::UNKNOWN.#own));
        match held {
            Held::Scalars(scalars) => quote!(put(p, #at, #{stored_as(*slot, *scalars, (&source, &unknown))});),
            Held::Message(part) => all(part, &source),
            Held::Each(row) => self::row(row, &source),
            Held::Rows(rows, room) => quote! {
                #(if let Some(room) = room => wire::generated::fit(&#source, &#unknown, #room, #{slot.name})?;)
                #(for row in rows => #{self::row(row, &source)})*
            },
        }
    };
    quote!(#(for field in &part.fields => #{statement(field)})*)
}

/// `for (one, p) in self.esc.iter().zip(wire::generated::elements_mut::<35>(p, 16, 40)) { … }`
fn row(row: &Row<'_>, source: &TokenStream) -> TokenStream {
    let Row { at, stride, len, part, .. } = row;
    quote! {
        for (one, p) in #source.iter() #{cut(row)} .zip(wire::generated::elements_mut::<#len>(p, #at, #stride)) {
            #{all(part, &quote!(one))}
        }
    }
}

/// The value in the type and length that the definition has.
fn stored_as(slot: TopicSlot<'_>, scalars: Scalars, (source, unknown): (&TokenStream, &TokenStream)) -> TokenStream {
    let (Scalars { stored, len, widens, few }, name) = (scalars, slot.name);
    let mut value = source.clone();
    if few {
        let (len, bytes) = (len.unwrap_or(1), (stored == Plain::Char).then(|| quote!(.0)));
        value = quote!(wire::generated::first::<_, #len>(&#value #bytes, &#unknown #bytes, #name)?);
    }
    if widens {
        value = match (slot.ty, len) {
            (TopicType::Enum(one), Some(_)) => quote!(#value.map(|v| #{number_in(Element::Enum(one), &quote!(v))})),
            (TopicType::Enum(one), None) => number_in(Element::Enum(one), &value),
            _ => value,
        };
        value = match len {
            Some(_) => quote!(wire::generated::narrow_each::<#stored, _, _>(#value, #name)?),
            None => quote!(wire::generated::narrow::<#stored, _>(#value, #name)?),
        };
    }
    match (stored, len) {
        (Plain::Bool, Some(_)) => quote!(#value.map(u8::from)),
        (Plain::Bool, None) => quote!(u8::from(#value)),
        _ => value,
    }
}
