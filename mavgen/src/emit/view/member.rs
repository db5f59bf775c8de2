//! Getters and setters of named bits.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::bits::{At, Present, mask_of, present, raw_type, read, write};
use super::scaled::scaled_number;
use crate::docs::prose_with;
use crate::emit::token::{ident, repr};
use crate::emit::{Context, doc};
use crate::ir::{Meaning, Member, Repeat, View};

/// Everything that one member contributes to its view.
pub(super) fn member(context: &Context<'_>, view: &View, member: &Member) -> TokenStream {
    match &member.meaning {
        Meaning::Scaled(scaled) => scaled_number(context, view, member, scaled),
        _ => getter_and_setter(context, view, member, documentation(member)),
    }
}

/// A getter and a setter of what the bits hold, without scaling.
pub(super) fn getter_and_setter(context: &Context<'_>, view: &View, member: &Member, docs: Docs) -> TokenStream {
    match member.repeat {
        Some(repeat) => repeated(context, view, member, (repeat, docs)),
        None => plain(context, view, member, docs),
    }
}

/// The documentation of a getter and of its setter.
pub(super) struct Docs {
    pub(super) get: TokenStream,
    pub(super) set: TokenStream,
}

/// How raw numbers become values of the member's type, and back.
struct Shape {
    /// `Esc32State`, `bool`, `u16`
    ty: Ident,
    /// From the raw expression to the value.
    value: fn(&Ident, &TokenStream) -> TokenStream,
    /// From `value` to the raw number.
    raw: TokenStream,
    /// The type of `raw`, and of the raw expression.
    raw_type: Ident,
}

fn shape(context: &Context<'_>, member: &Member) -> Shape {
    let raw_type = raw_type(member);
    match member.meaning {
        Meaning::Flag => number(ident("bool")),
        Meaning::Values(id) => match context.dialect.enum_by_id(id) {
            Some(values) => Shape {
                ty: ident(&values.name.rust),
                value: if values.bitmask {
                    |ty, raw| quote!(#ty::from_bits_retain(#raw))
                } else {
                    |ty, raw| quote!(#ty(#raw))
                },
                raw: if values.bitmask { quote!(value.bits()) } else { quote!(value.0) },
                raw_type: repr(values.repr),
            },
            None => number(raw_type),
        },
        Meaning::Number { .. } | Meaning::Scaled(_) => number(raw_type),
    }
}

fn number(raw_type: Ident) -> Shape {
    Shape { ty: raw_type.clone(), value: |_, raw| raw.clone(), raw: quote!(value), raw_type }
}

/// The raw number, in the type that the value is made of.
fn raw_as(view: &View, member: &Member, at: &At, wanted: &Ident) -> TokenStream {
    let own = raw_type(member);
    let raw = read(view, at, member.width, &own, member.signed);
    if own == *wanted { raw } else { quote!((#raw) as #wanted) }
}

/// The value: `MavState((self.bits & 7) as u8)`, `self.bits & (1 << 4) != 0`.
fn value(view: &View, member: &Member, at: &At, shape: &Shape) -> TokenStream {
    if matches!(member.meaning, Meaning::Flag) {
        let bit = at.left(&quote!(1));
        return quote!(self.bits & #bit != 0);
    }
    (shape.value)(&shape.ty, &raw_as(view, member, at, &shape.raw_type))
}

/// A flag, an enum or a number: getter and setter.
fn plain(context: &Context<'_>, view: &View, member: &Member, docs: Docs) -> TokenStream {
    let shape = shape(context, member);
    let (name, setter, ty) = (ident(&member.name.rust()), format_ident!("set_{}", member.name.rust()), &shape.ty);
    let value = value(view, member, &At::Bit(member.at), &shape);
    let store = store(view, member, &At::Bit(member.at), &shape);
    let Docs { get: docs, set: set_docs } = docs;
    let (result, body) = optional(present(view, member).as_ref(), &quote!(#ty), &value);
    let guard = guard(view, member);
    quote! {
        #docs
        #[inline]
        pub const fn #name(self) -> #result {
            #body
        }
        #set_docs
        #[inline]
        pub const fn #setter(&mut self, value: #ty) -> Result<(), wire::ViewError> {
            #guard
            #store
        }
    }
}

/// `T` as it is, or `Option<T>` where only some layouts have it.
fn optional(present: Option<&Present>, ty: &TokenStream, value: &TokenStream) -> (TokenStream, TokenStream) {
    match present {
        None => (quote!(#ty), value.clone()),
        Some(Present { value: switch, patterns }) => {
            let body = quote! {
                match #switch {
                    #patterns => Some(#value),
                    _ => None,
                }
            };
            (quote!(Option<#ty>), body)
        }
    }
}

/// What a setter does first where only some layouts have the bits.
fn guard(view: &View, member: &Member) -> Option<TokenStream> {
    let Present { value, patterns } = present(view, member)?;
    Some(quote! {
        match #value {
            #patterns => {}
            _ => return Err(wire::ViewError::Absent),
        }
    })
}

/// Puts `value` into the bits if it fits.
fn store(view: &View, member: &Member, at: &At, shape: &Shape) -> TokenStream {
    if matches!(member.meaning, Meaning::Flag) {
        let bit = at.left(&quote!(1));
        return quote! {
            self.bits = if value { self.bits | #bit } else { self.bits & !#bit };
            Ok(())
        };
    }
    let (raw, bits) = (&shape.raw, write(view, at, member.width, &quote!(raw), &shape.raw_type));
    match accepted(member, &shape.raw_type) {
        None => {
            let bits = write(view, at, member.width, raw, &shape.raw_type);
            quote! {
                self.bits = #bits;
                Ok(())
            }
        }
        Some(range) => quote! {
            match #raw {
                raw @ #range => {
                    self.bits = #bits;
                    Ok(())
                }
                _ => Err(wire::ViewError::OutOfRange),
            }
        },
    }
}

/// The pattern of raw numbers that fit; `None` where every number of the type does.
fn accepted(member: &Member, raw_type: &Ident) -> Option<TokenStream> {
    let all = raw_type.to_string().get(1..).and_then(|width| width.parse().ok()) == Some(member.width);
    if all { None } else { Some(raw_range(member)) }
}

/// `0..=0xfff`, `-256..=255`
pub(super) fn raw_range(member: &Member) -> TokenStream {
    if !member.signed {
        let mask = mask_of(member.width);
        return quote!(0..=#mask);
    }
    let end = 1_i128.checked_shl(u32::from(member.width) - 1).unwrap_or_default();
    let (start, last) = (Literal::i128_unsuffixed(end), Literal::i128_unsuffixed(end - 1));
    quote!(-#start..=#last)
}

/// Several alike: an index, and `None` beyond the last.
fn repeated(context: &Context<'_>, view: &View, member: &Member, (repeat, docs): (Repeat, Docs)) -> TokenStream {
    let shape = shape(context, member);
    let (name, setter, ty) = (ident(&member.name.rust()), format_ident!("set_{}", member.name.rust()), &shape.ty);
    let count = Literal::u8_unsuffixed(repeat.count);
    let at = At::Computed(position(member.at, repeat.stride));
    let value = value(view, member, &at, &shape);
    let store = store(view, member, &at, &shape);
    let Docs { get: docs, set: set_docs } = docs;
    let (there, guard) = (present(view, member), guard(view, member));
    let (_, there_value) = optional(there.as_ref(), &quote!(#ty), &value);
    let body = match there {
        None => quote!(if index < #count { Some(#there_value) } else { None }),
        Some(_) => quote!(if index < #count { #there_value } else { None }),
    };
    quote! {
        #docs
        ///
        /// `None` where there is no such one.
        #[inline]
        pub const fn #name(self, index: usize) -> Option<#ty> {
            #body
        }
        #set_docs
        #[inline]
        pub const fn #setter(&mut self, index: usize, value: #ty) -> Result<(), wire::ViewError> {
            #guard
            if index >= #count {
                return Err(wire::ViewError::OutOfRange);
            }
            #store
        }
    }
}

/// `3 + index * 2`
fn position(at: u8, stride: u8) -> TokenStream {
    let (start, step) = (Literal::u8_unsuffixed(at), Literal::u8_unsuffixed(stride));
    match (at, stride) {
        (0, 1) => quote!(index),
        (0, _) => quote!(index * #step),
        (_, 1) => quote!(#start + index),
        _ => quote!(#start + index * #step),
    }
}

/// What the overlay says of the bits, and the unit; and the line of the setter.
pub(super) fn documentation(member: &Member) -> Docs {
    let units = match &member.meaning {
        Meaning::Number { units } => units.as_deref(),
        Meaning::Scaled(scaled) => scaled.units.as_deref(),
        Meaning::Flag | Meaning::Values(_) => None,
    };
    let mut sentences: Vec<String> = Vec::new();
    if member.description.trim().is_empty() {
        sentences.push(format!("`{}`.", member.name));
    }
    sentences.extend(units.map(|units| format!("In {units}.")));
    let words = sentences.iter().flat_map(|sentence| sentence.split(' ')).map(str::to_owned).collect();
    let get = doc::attributes(&prose_with(&member.description, words));
    let set = doc::attributes(&[format!("Sets [`Self::{}`]. An error if the value does not fit.", member.name.rust())]);
    Docs { get, set }
}
