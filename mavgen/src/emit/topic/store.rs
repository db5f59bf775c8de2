//! How a topic is written: every field that a definition has, where it has it, in its type.

use super::field::plain;
use super::load::part;
use crate::emit::token::{decimal, ident};
use crate::emit::ty::number_in;
use crate::rust::{Held, Part, Plain, Row, Scalars, TopicSlot, TopicType};
use crate::tokens::{Literal, TokenStream, quote};

/// Statements that write a message into `p`; `source` is where it lies.
pub(super) fn all(part: &Part<'_>, source: &TokenStream) -> TokenStream {
    let of = ident(part.ident);
    let fields = part.fields.iter().map(|field| {
        let (own, name) = (ident(field.slot.ident), field.slot.name);
        let (source, unknown) = (quote!(#source.#own), quote!(#of::UNKNOWN.#own));
        match &field.held {
            Held::Scalars(scalars) => {
                let (value, at) = (stored_as(field.slot, *scalars, (&source, &unknown)), decimal(field.at));
                quote!(put(p, #at, #value);)
            }
            Held::Message(part) => all(part, &source),
            Held::Each(row) => self::row(row, &source),
            Held::Rows(rows, room) => {
                let check =
                    room.map(decimal).map(|room| quote!(wire::generated::fit(&#source, &#unknown, #room, #name)?;));
                let rows = rows.iter().map(|row| self::row(row, &source));
                quote!(#check #(#rows)*)
            }
        }
    });
    fields.collect()
}

/// `for (one, p) in self.esc.iter().zip(wire::generated::elements_mut::<35>(p, 16, 40)) { … }`
fn row(row: &Row<'_>, source: &TokenStream) -> TokenStream {
    let (at, stride, len, part) = (decimal(row.at), decimal(row.stride), decimal(row.len), part(row));
    let fields = all(&row.part, &quote!(one));
    quote! {
        for (one, p) in #source.iter() #part .zip(wire::generated::elements_mut::<#len>(p, #at, #stride)) {
            #fields
        }
    }
}

/// The value in the type and length that the definition has.
fn stored_as(slot: TopicSlot<'_>, scalars: Scalars, (source, unknown): (&TokenStream, &TokenStream)) -> TokenStream {
    let (Scalars { stored, len, widens, few }, name) = (scalars, slot.name);
    let mut value = source.clone();
    if few {
        let (len, bytes) = (Literal::of(len.unwrap_or(1)), (stored == Plain::Char).then(|| quote!(.0)));
        value = quote!(wire::generated::first::<_, #len>(&#value #bytes, &#unknown #bytes, #name)?);
    }
    if widens {
        if let TopicType::Enum(one) = slot.ty {
            let number = number_in(one.as_int(), &len.map_or(value.clone(), |_| quote!(v)));
            value = if len.is_some() { quote!(#value.map(|v| #number)) } else { number };
        }
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
