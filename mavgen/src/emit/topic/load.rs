//! How what a definition has is read: one literal, then what is put over what is not known.

use super::field::{element, plain};
use crate::emit::token::{decimal, ident};
use crate::emit::ty::maker;
use crate::rust::{Held, Move, Part, Plain, Row, Scalars, TopicSlot, TopicType};
use crate::tokens::{Literal, TokenStream, quote};

/// What a function that reads a definition does and gives.
pub(super) fn body(part: &Part<'_>) -> TokenStream {
    let (literal, statements) = (literal(part), statements(part, &quote!(read)));
    if statements.is_empty() {
        return quote!(Ok(#literal));
    }
    quote! {
        let mut read = #literal;
        #statements
        Ok(read)
    }
}

/// `EscReport { esc_rpm: get(p, 12), …, ..EscReport::UNKNOWN }`
fn literal(part: &Part<'_>) -> TokenStream {
    let name = ident(part.ident);
    let values = part.fields.iter().filter(|field| !field.later).map(|field| {
        let (own, value) = (ident(field.slot.ident), value(field));
        quote!(#own: #value,)
    });
    let rest = part.lacks.then(|| quote!(..#name::UNKNOWN));
    quote!(#name { #(#values)* #rest })
}

/// A field that is one value.
fn value(field: &Move<'_>) -> TokenStream {
    match &field.held {
        Held::Scalars(scalars) => loaded(field.slot, *scalars, field.at),
        Held::Message(part) => literal(part),
        Held::Each(row) => {
            let Row { at, stride, len, .. } = row;
            let (literal, at, stride, len) = (literal(&row.part), decimal(*at), decimal(*stride), decimal(*len));
            quote!(wire::generated::each(p, #at, #stride, |p: &[u8; #len]| #literal))
        }
        Held::Rows(..) => TokenStream::new(),
    }
}

/// Statements that put the other fields into `target`.
fn statements(part: &Part<'_>, target: &TokenStream) -> TokenStream {
    let later = part.fields.iter().filter(|field| field.later).map(|field| {
        let own = ident(field.slot.ident);
        let target = quote!(#target.#own);
        match &field.held {
            Held::Scalars(scalars) => fill(field.slot, *scalars, &target, field.at),
            Held::Message(part) => {
                let (literal, statements) = (literal(part), statements(part, &target));
                quote!(#target = #literal; #statements)
            }
            Held::Rows(rows, _) => rows.iter().map(|row| self::row(row, &target)).collect(),
            Held::Each(_) => TokenStream::new(),
        }
    });
    later.collect()
}

/// `for (one, p) in read.esc.iter_mut().zip(wire::generated::elements::<35>(p, 16, 40)) { … }`
fn row(row: &Row<'_>, target: &TokenStream) -> TokenStream {
    let (literal, statements) = (literal(&row.part), statements(&row.part, &quote!(one)));
    let (at, stride, len, part) = (decimal(row.at), decimal(row.stride), decimal(row.len), part(row));
    quote! {
        for (one, p) in #target.iter_mut() #part .zip(wire::generated::elements::<#len>(p, #at, #stride)) {
            *one = #literal;
            #statements
        }
    }
}

/// `.skip(1).take(7)`: which elements of an array a row has.
pub(super) fn part(row: &Row<'_>) -> TokenStream {
    let (first, count) = (decimal(row.skip), row.take.map(decimal));
    let skip = (row.skip > 0).then(|| quote!(.skip(#first)));
    let take = count.map(|count| quote!(.take(#count)));
    quote!(#skip #take)
}

/// `wire::generated::fill(&mut read.levels, &get::<[u16; 2]>(p, 78));`
fn fill(slot: TopicSlot<'_>, scalars: Scalars, target: &TokenStream, at: u32) -> TokenStream {
    let values = loaded(slot, scalars, at);
    let bytes = (scalars.stored == Plain::Char).then(|| quote!(.0));
    quote!(wire::generated::fill(&mut #target #bytes, &#values);)
}

/// What a definition has as these scalars: `get(p, 12)`, `get::<u8>(p, 12).into()`, `boolean(p, 9, "armed")?`
fn loaded(slot: TopicSlot<'_>, Scalars { stored, len, widens, few }: Scalars, at: u32) -> TokenStream {
    let (name, at) = (slot.name, decimal(at));
    let of = if widens || slot.ty == TopicType::Plain(Plain::Char) { plain(stored) } else { element(slot.ty) };
    let raw = match (stored, len.map(Literal::of)) {
        (Plain::Bool, Some(len)) => quote!(booleans::<#len>(p, #at, #name)?),
        (Plain::Bool, None) => quote!(boolean(p, #at, #name)?),
        _ if !widens && !few => quote!(get(p, #at)),
        (_, Some(len)) => quote!(get::<[#of; #len]>(p, #at)),
        (_, None) => quote!(get::<#of>(p, #at)),
    };
    let made = match slot.ty {
        TopicType::Enum(one) => Some(maker(one)),
        _ => None,
    };
    match (made, len) {
        _ if !widens => raw,
        (None, None) => quote!(#raw.into()),
        (None, Some(_)) => quote!(#raw.map(Into::into)),
        (Some(maker), None) => quote!(#maker(#raw.into())),
        (Some(maker), Some(_)) => quote!(#raw.map(|n| #maker(n.into()))),
    }
}
