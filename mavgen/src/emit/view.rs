//! A view: a small type over packed bits, with getters, setters and a `Debug` with units, or a record of values; and how a
//! message gives it.
//!
//! ```text
//! /// Status of an ESC.
//! #[derive(Clone, Copy, PartialEq, Eq, Hash)]
//! pub struct EscStatus {
//!     bits: u64,
//!     data_version: u8,
//! }
//!
//! impl EscStatus {
//!     /// The view of these bits, …
//!     pub const fn from_bits(bits: u64, data_version: u8) -> Self {
//!         Self { bits, data_version }
//!     }
//!     …
//!     /// Speed. In rpm.
//!     pub const fn rpm(self) -> u16 {
//!         ((self.bits >> 29) & 0x7fff) as u16
//!     }
//! }
//!
//! wire::view!(EscStatus { bits, data_version } [rpm, …]);
//! ```

mod debug;
mod record;

use super::doc;
use super::method::method;
use super::token::ident;
use super::ty::int;
use crate::rust::{Docs, Packed, View};
use crate::tokens::{Literal, TokenStream, quote};

/// The items of a view's file, without its imports.
pub(super) fn view(view: &View<'_>) -> TokenStream {
    let View { packed, record, message, message_methods } = view;
    let (packed, record) = (packed.as_ref().map(self::packed), record.as_ref().map(record::declaration));
    let (message, methods) = (ident(message), message_methods.iter().map(method));
    quote! {
        #packed
        #record
        impl #message { #(#methods)* }
    }
}

/// The type over the bits.
fn packed(packed: &Packed<'_>) -> TokenStream {
    let Packed { ident: name, docs, storage, switch, methods, debug: members } = packed;
    let (docs, debug) = (doc::documentation(docs), debug::debug(name, members));
    let (name, storage) = (ident(name), int(*storage));
    let layout = switch.as_ref().map(|(name, _)| ident(name));
    let carried = layout.as_ref().map(|layout| quote!(, #layout));
    let members = members.iter().map(|member| {
        let (name, count) = (ident(member.ident), member.count.map(Literal::of));
        let count = count.map(|count| quote!([#count]));
        quote!(#name #count)
    });
    let zero = layout.iter().map(|layout| quote!(#layout: 0));
    let empty = doc::documentation(&Docs::line("All bits zero."));
    let switch = switch.as_ref().map(|(_, of)| int(*of)).map(|of| quote!(#layout: #of,));
    let methods = methods.iter().map(method);
    quote! {
        #docs
        #[derive(Clone, Copy, PartialEq, Eq, Hash)]
        pub struct #name { bits: #storage, #switch }
        impl #name {
            #empty
            pub const EMPTY: Self = Self { bits: 0 #(, #zero)* };
            #(#methods)*
        }
        #debug
        wire::view!(#name { bits #carried } [#(#members),*]);
    }
}
