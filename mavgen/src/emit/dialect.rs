//! The dialect: an enum over all messages. The runtime adds the table that a parser checks frames with.
//!
//! ```text
//! /// Any message of the `acme` dialect.
//! #[derive(Clone, Copy, Debug, PartialEq)]
//! #[non_exhaustive]
//! #[allow(clippy::large_enum_variant, reason = "there is no allocator to box the large ones")]
//! pub enum Acme {
//!     /// `HEARTBEAT`, message 0.
//!     Heartbeat(Heartbeat),
//! }
//!
//! wire::dialect!(Acme { Heartbeat });
//! ```

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::emit::folder::Titled;
use crate::emit::token::ident;
use crate::emit::{Context, doc};
use crate::ir::Message;

/// The items of `dialect.rs`; nothing for a dialect without messages.
pub(crate) fn dialect(context: &Context<'_>, dialect: Titled<'_>, messages: &[&Message]) -> TokenStream {
    let (name, runtime) = (ident(dialect.type_name), context.use_runtime());
    let names: Vec<Ident> = messages.iter().map(|message| ident(&message.name.rust)).collect();
    let declaration = declaration(dialect, messages);
    if names.is_empty() {
        return TokenStream::new();
    }
    quote! {
        use super::messages::*;
        #runtime
        #declaration
        wire::dialect!(#name { #(#names),* });
    }
}

fn declaration(dialect: Titled<'_>, messages: &[&Message]) -> TokenStream {
    let docs = doc::attributes(&[
        format!("Any message of the `{}` dialect.", dialect.name),
        String::new(),
        "New messages are added without a breaking release; match with a `_` arm.".to_owned(),
    ]);
    let variants = messages.iter().map(|message| {
        let docs = doc::attributes(&[format!("`{}`, message {}.", message.name.text, message.id)]);
        let name = ident(&message.name.rust);
        quote!(#docs #name(#name))
    });
    let name = ident(dialect.type_name);
    quote! {
        #docs
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[non_exhaustive]
        #[allow(clippy::large_enum_variant, reason = "there is no allocator to box the large ones")]
        pub enum #name { #(#variants),* }
    }
}
