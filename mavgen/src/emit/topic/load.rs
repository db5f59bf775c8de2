//! How what a definition has is read: one literal, then what is put over what is not known.

use crate::emit::token::ident;
use crate::emit::ty::maker;
use crate::rust::{Held, Move, Part, Plain, Row, Scalars, TopicSlot, TopicType};
use crate::tokens::{TokenStream, quote};

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
fn literal(Part { ident: name, fields, lacks }: &Part<'_>) -> TokenStream {
    let (name, fields) = (ident(name), fields.iter().filter(|field| !field.later));
    quote! {
        #name {
            #(for field in fields => #{ident(field.slot.ident)}: #{value(field)},)*
            #(if *lacks => ..#name::UNKNOWN)
        }
    }
}

/// A field that is one value.
fn value(field: &Move<'_>) -> TokenStream {
    match &field.held {
        Held::Scalars(scalars) => loaded(field.slot, *scalars, field.at),
        Held::Message(part) => literal(part),
        Held::Each(Row { at, stride, len, part, .. }) => {
            quote!(wire::generated::each(p, #at, #stride, |p: &[u8; #len]| #{literal(part)}))
        }
        Held::Rows(..) => TokenStream::new(),
    }
}

/// Statements that put the other fields into `target`.
fn statements(part: &Part<'_>, target: &TokenStream) -> TokenStream {
    let later = part.fields.iter().filter(|field| field.later);
    let statement = |field: &Move<'_>| {
        let target = quote!(#target.#{ident(field.slot.ident)});
        match &field.held {
            Held::Scalars(scalars) => fill(field.slot, *scalars, &target, field.at),
            Held::Message(part) => quote!(#target = #{literal(part)}; #{statements(part, &target)}),
            Held::Rows(rows, _) => quote!(#(for row in rows => #{self::row(row, &target)})*),
            Held::Each(_) => TokenStream::new(),
        }
    };
    quote!(#(for field in later => #{statement(field)})*)
}

/// `for (one, p) in read.esc.iter_mut().zip(wire::generated::elements::<35>(p, 16, 40)) { … }`
fn row(row: &Row<'_>, target: &TokenStream) -> TokenStream {
    let Row { at, stride, len, part, .. } = row;
    quote! {
        for (one, p) in #target.iter_mut() #{cut(row)} .zip(wire::generated::elements::<#len>(p, #at, #stride)) {
            *one = #{literal(part)};
            #{statements(part, &quote!(one))}
        }
    }
}

/// `.skip(1).take(7)`: which elements of an array a row has.
pub(super) fn cut(Row { skip, take, .. }: &Row<'_>) -> TokenStream {
    quote!(#(if *skip > 0 => .skip(#skip)) #(if let Some(take) = take => .take(#take)))
}

/// `wire::generated::fill(&mut read.levels, &get::<[u16; 2]>(p, 78));`
fn fill(slot: TopicSlot<'_>, scalars: Scalars, target: &TokenStream, at: u32) -> TokenStream {
    let is_text = scalars.stored == Plain::Char;
    quote!(wire::generated::fill(&mut #target #(if is_text => .0), &#{loaded(slot, scalars, at)});)
}

/// What a definition has as these scalars: `get(p, 12)`, `get::<u8>(p, 12).into()`, `boolean(p, 9, "armed")?`
fn loaded(slot: TopicSlot<'_>, Scalars { stored, len, widens, few }: Scalars, at: u32) -> TokenStream {
    let (name, is_stored) = (slot.name, widens || slot.ty == TopicType::Plain(Plain::Char));
    let of = if is_stored { quote!(#stored) } else { quote!(#{slot.ty}) };
    let raw = match (stored, len) {
        (Plain::Bool, Some(len)) => quote!(booleans::<#len>(p, #at, #name)?),
        (Plain::Bool, None) => quote!(boolean(p, #at, #name)?),
        _ if !widens && !few => quote!(get(p, #at)),
        (_, Some(len)) => quote!(get::<[#of; #len]>(p, #at)),
        (_, None) => quote!(get::<#of>(p, #at)),
    };
    match (slot.ty, len) {
        _ if !widens => raw,
        (TopicType::Enum(one), None) => quote!(#{maker(one)}(#raw.into())),
        (TopicType::Enum(one), Some(_)) => quote!(#raw.map(|n| #{maker(one)}(n.into()))),
        (_, None) => quote!(#raw.into()),
        (_, Some(_)) => quote!(#raw.map(Into::into)),
    }
}
