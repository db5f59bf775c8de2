//! The dialect: an enum over all messages. The runtime adds the table that a parser checks frames with.

use super::token::ident;
use crate::rust::{DialectEnum, Variant};
use crate::tokens::{TokenStream, quote};

/// The items of `dialect.rs`.
pub(super) fn dialect(dialect: &DialectEnum<'_>) -> TokenStream {
    let DialectEnum { ident: name, docs, variants, completed_by, derives_debug } = dialect;
    let name = ident(name);
    quote! {
        #docs
        #[derive(Clone, Copy, #(if *derives_debug => Debug,) PartialEq)]
        #[non_exhaustive]
        #[allow(clippy::large_enum_variant, reason = "there is no allocator to box the large ones")]
        pub enum #name { #(for Variant { ident: name, docs } in variants => #docs #{ident(name)}(#{ident(name)})),* }
        wire::#{ident(completed_by)}!(#name { #(for variant in variants => #{ident(variant.ident)}),* });
    }
}
