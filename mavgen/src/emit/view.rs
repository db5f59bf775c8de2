//! A view: a small type over packed bits, with getters, setters, a `Debug` with units, and how a message gives it.
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
//! ```

mod debug;

use proc_macro2::TokenStream;
use quote::quote;

use super::body::slots;
use super::doc;
use super::method::method;
use super::token::ident;
use super::ty::int;
use crate::rust::View;

/// The items of a view's file, without its imports.
pub(super) fn view(view: &View<'_>) -> TokenStream {
    let View { ident: name, docs, storage, switch, methods, debug, slot, message, message_methods } = view;
    let (docs, debug) = (doc::documentation(docs), debug::debug(name, debug));
    let (name, message, storage) = (ident(name), ident(message), int(*storage));
    let switch = switch.map(|(name, of)| {
        let (name, of) = (ident(name), int(of));
        quote!(#name: #of,)
    });
    let (methods, message_methods) = (methods.iter().map(method), message_methods.iter().map(method));
    let slot = slot.as_ref().map(slots::declaration);
    quote! {
        #docs
        #[derive(Clone, Copy, PartialEq, Eq, Hash)]
        pub struct #name { bits: #storage, #switch }
        impl #name { #(#methods)* }
        #debug
        #slot
        impl #message { #(#message_methods)* }
    }
}
