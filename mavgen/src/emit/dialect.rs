//! The dialect: an enum over all messages. The runtime adds the table that a parser checks frames with.
//!
//! ```text
//! /// Any message of the `acme` dialect.
//! #[derive(Clone, Copy, PartialEq)]
//! #[non_exhaustive]
//! #[allow(clippy::large_enum_variant, reason = "there is no allocator to box the large ones")]
//! pub enum Acme {
//!     /// `HEARTBEAT`, message 0.
//!     Heartbeat(Heartbeat),
//! }
//!
//! wire::dialect!(Acme { Heartbeat });
//! ```

use super::doc;
use super::token::ident;
use crate::rust::{DialectEnum, Variant};
use crate::tokens::{TokenStream, quote};

/// The items of `dialect.rs`.
pub(super) fn dialect(dialect: &DialectEnum<'_>) -> TokenStream {
    let (docs, name) = (doc::documentation(&dialect.docs), ident(dialect.ident));
    let names = dialect.variants.iter().map(|variant| ident(variant.ident));
    let variants = dialect.variants.iter().map(|Variant { ident: name, docs }| {
        let (docs, name) = (doc::documentation(docs), ident(name));
        quote!(#docs #name(#name))
    });
    let (completed, debug) = (ident(dialect.completed_by), dialect.derives_debug.then(|| quote!(Debug,)));
    quote! {
        #docs
        #[derive(Clone, Copy, #debug PartialEq)]
        #[non_exhaustive]
        #[allow(clippy::large_enum_variant, reason = "there is no allocator to box the large ones")]
        pub enum #name { #(#variants),* }
        wire::#completed!(#name { #(#names),* });
    }
}
