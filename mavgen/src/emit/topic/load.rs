//! How a definition's body is read: one literal of what it has, then what lies in arrays of messages.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::field::{element, plain};
use crate::emit::token::{decimal, ident};
use crate::emit::ty::maker;
use crate::rust::{Definition, Held, Move, Plain, Row, TopicSlot, TopicType};

/// The body of the function that reads a definition.
pub(super) fn body(name: &str, definition: &Definition<'_>) -> TokenStream {
    let loaded = message(name, &quote!(read), &definition.cdr, (0, definition.is_whole));
    let literal = loaded.literal;
    if loaded.statements.is_empty() {
        return quote!(Ok(#literal));
    }
    let statements = loaded.statements;
    quote! {
        let mut read = #literal;
        #(#statements)*
        Ok(read)
    }
}

/// A message as a literal, and what is put into it afterwards.
struct Loaded {
    literal: TokenStream,
    statements: Vec<TokenStream>,
}

/// A message that begins at `base` of `p`; `target` is where it comes to lie.
fn message(name: &str, target: &TokenStream, fields: &[Move<'_>], (base, is_whole): (u32, bool)) -> Loaded {
    let (mut values, mut statements, mut rest) = (Vec::new(), Vec::new(), !is_whole);
    for field in fields {
        let own = ident(field.slot.ident);
        match loaded(field, &quote!(#target.#own), base) {
            Value::Whole(value) => values.push(quote!(#own: #value)),
            Value::Later(mut later) => {
                statements.append(&mut later);
                rest = true;
            }
        }
    }
    let name = ident(name);
    let rest = rest.then(|| quote!(..#name::UNKNOWN));
    Loaded { literal: quote!(#name { #(#values,)* #rest }), statements }
}

/// What becomes of a field.
enum Value {
    /// It has this value.
    Whole(TokenStream),
    /// Statements put something into it.
    Later(Vec<TokenStream>),
}

fn loaded(field: &Move<'_>, target: &TokenStream, base: u32) -> Value {
    match &field.held {
        Held::Plain(stored, len) => scalars(field.slot, (*stored, *len), target, base + field.at),
        Held::Messages(rows) => match (rows.as_slice(), field.slot.len) {
            ([row], None) => {
                let nested = message(row.ident, target, &row.fields, (base + row.at, row.is_whole));
                let literal = nested.literal;
                if nested.statements.is_empty() {
                    return Value::Whole(literal);
                }
                let begun = std::iter::once(quote!(#target = #literal;));
                Value::Later(begun.chain(nested.statements).collect())
            }
            ([row], Some(len)) if row.count == len && is_total(&row.fields) => Value::Whole(each(row, base)),
            (rows, _) => Value::Later(rows.iter().map(|row| self::row(row, field.slot, target, base)).collect()),
        },
    }
}

/// Whether reading a message is one literal that cannot fail.
fn is_total(fields: &[Move<'_>]) -> bool {
    fields.iter().all(|field| match &field.held {
        Held::Plain(stored, len) => *stored != Plain::Bool && *len == field.slot.len,
        Held::Messages(rows) => match (rows.as_slice(), field.slot.len) {
            ([row], None) => is_total(&row.fields),
            ([row], Some(len)) => row.count == len && is_total(&row.fields),
            _ => false,
        },
    })
}

/// `wire::generated::each(p, 16, 40, |p: &[u8; 35]| EscReport { … })`: made in its place, not over an array of what is not
/// known.
fn each(row: &Row<'_>, base: u32) -> TokenStream {
    let Row { at, stride, len, .. } = row;
    let literal = message(row.ident, &quote!(one), &row.fields, (0, row.is_whole)).literal;
    let (at, stride, len) = (decimal(base + at), decimal(*stride), decimal(*len));
    quote!(wire::generated::each(p, #at, #stride, |p: &[u8; #len]| #literal))
}

/// `for (one, p) in read.esc.iter_mut().zip(wire::generated::elements::<35>(p, 16, 40)) { … }`
fn row(row: &Row<'_>, slot: TopicSlot<'_>, target: &TokenStream, base: u32) -> TokenStream {
    let Row { at, stride, len, .. } = row;
    let nested = message(row.ident, &quote!(one), &row.fields, (0, row.is_whole));
    let (literal, statements) = (nested.literal, nested.statements);
    let (at, stride, len, part) = (decimal(base + at), decimal(*stride), decimal(*len), part(row, slot));
    quote! {
        for (one, p) in #target.iter_mut() #part .zip(wire::generated::elements::<#len>(p, #at, #stride)) {
            *one = #literal;
            #(#statements)*
        }
    }
}

/// `.skip(1).take(7)`: which elements of an array a row has.
pub(super) fn part(row: &Row<'_>, slot: TopicSlot<'_>) -> TokenStream {
    let (first, count) = (decimal(row.first), decimal(row.count));
    let skip = (row.first > 0).then(|| quote!(.skip(#first)));
    let is_cut = slot.len.is_some_and(|len| row.first + row.count < len);
    let take = is_cut.then(|| quote!(.take(#count)));
    quote!(#skip #take)
}

/// What a definition has as these scalars.
fn scalars(slot: TopicSlot<'_>, (stored, len): (Plain, Option<u16>), target: &TokenStream, at: u32) -> Value {
    let is_all = slot.len.unwrap_or(1) == len.unwrap_or(1);
    let values = match slot.ty {
        TopicType::Plain(Plain::Char) if is_all => return Value::Whole(get(at)),
        TopicType::Plain(Plain::Char) => {
            let (len, at) = (Literal::u16_unsuffixed(len.unwrap_or(1)), decimal(at));
            return Value::Later(vec![quote!(wire::generated::fill(&mut #target.0, &get::<[u8; #len]>(p, #at));)]);
        }
        _ if slot.ty.plain() == Some(stored) => same(slot, len, is_all, at),
        _ => widened(slot, (stored, len), at),
    };
    if is_all {
        return Value::Whole(values);
    }
    Value::Later(vec![quote!(wire::generated::fill(&mut #target, &#values);)])
}

fn get(at: u32) -> TokenStream {
    let at = decimal(at);
    quote!(get(p, #at))
}

/// What has the field's own type.
fn same(slot: TopicSlot<'_>, len: Option<u16>, is_all: bool, at: u32) -> TokenStream {
    if slot.ty.plain() == Some(Plain::Bool) {
        return booleans(slot, len, at);
    }
    match len {
        Some(len) if !is_all => {
            let (len, at, element) = (Literal::u16_unsuffixed(len), decimal(at), element(slot.ty));
            quote!(get::<[#element; #len]>(p, #at))
        }
        _ => get(at),
    }
}

/// `wire::generated::boolean(p, 9, "armed")?`
fn booleans(slot: TopicSlot<'_>, len: Option<u16>, at: u32) -> TokenStream {
    let (name, at) = (slot.ident, decimal(at));
    match len.map(Literal::u16_unsuffixed) {
        Some(len) => quote!(wire::generated::booleans::<#len>(p, #at, #name)?),
        None => quote!(wire::generated::boolean(p, #at, #name)?),
    }
}

/// What has a narrower type: `get::<u8>(p, 12).into()`.
fn widened(slot: TopicSlot<'_>, (stored, len): (Plain, Option<u16>), at: u32) -> TokenStream {
    let raw = match (stored, len.map(Literal::u16_unsuffixed)) {
        (Plain::Bool, _) => booleans(slot, len, at),
        (_, Some(len)) => {
            let (of, at) = (plain(stored), decimal(at));
            quote!(get::<[#of; #len]>(p, #at))
        }
        (_, None) => {
            let (of, at) = (plain(stored), decimal(at));
            quote!(get::<#of>(p, #at))
        }
    };
    let made = match slot.ty {
        TopicType::Enum(one) => Some(maker(one)),
        _ => None,
    };
    match (made, len) {
        (None, None) => quote!(#raw.into()),
        (None, Some(_)) => quote!(#raw.map(Into::into)),
        (Some(maker), None) => quote!(#maker(#raw.into())),
        (Some(maker), Some(_)) => quote!(#raw.map(|n| #maker(n.into()))),
    }
}
