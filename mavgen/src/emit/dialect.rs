//! The dialect: an enum over all messages, and the table that a parser checks frames with.
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
//! static MESSAGES: [&wire::MessageInfo; 1] = [<Heartbeat as wire::Message>::INFO];
//! static INDEX: [u16; 1] = wire::generated::index(&MESSAGES);
//! static TABLE: wire::Table<'static> = wire::Table::indexed(&MESSAGES, &INDEX);
//!
//! impl wire::Dialect for Acme {
//!     const TABLE: &'static wire::Table<'static> = &TABLE;
//!     const FIELDS: &'static [&'static [wire::FieldInfo]] = &[<Heartbeat as wire::Message>::FIELDS];
//!     const DEFAULT: Self = Self::Heartbeat(<Heartbeat as wire::Message>::DEFAULT);
//!     fn decode_into(&mut self, id: u32, payload: &[u8]) -> bool {
//!         match id {
//!             0 => *self = Self::Heartbeat(wire::Message::decode(payload)),
//!             _ => return false,
//!         }
//!         true
//!     }
//! }
//!
//! wire::dialect!(Acme { Heartbeat });
//! ```

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::emit::folder::Titled;
use crate::emit::token::{decimal, ident};
use crate::emit::{Context, doc};
use crate::ir::Message;

/// Ids below this are looked up directly; above, by a short search.
const DIRECT_IDS: u32 = 512;

/// The items of `dialect.rs`; nothing for a dialect without messages.
pub(crate) fn dialect(context: &Context<'_>, dialect: Titled<'_>, messages: &[&Message]) -> TokenStream {
    let (name, runtime) = (ident(dialect.type_name), context.use_runtime());
    let names: Vec<Ident> = messages.iter().map(|message| ident(&message.name.rust)).collect();
    let Some(first) = names.first() else { return TokenStream::new() };
    let ids: Vec<_> = messages.iter().map(|message| decimal(message.id)).collect();
    let (declaration, table) = (declaration(dialect, messages), table(messages, &names));
    quote! {
        use super::messages::*;
        #runtime
        #declaration
        #table
        impl wire::Dialect for #name {
            const TABLE: &'static wire::Table<'static> = &TABLE;
            const FIELDS: &'static [&'static [wire::FieldInfo]] = &[#(<#names as wire::Message>::FIELDS),*];
            const DEFAULT: Self = Self::#first(<#first as wire::Message>::DEFAULT);
            fn decode_into(&mut self, id: u32, payload: &[u8]) -> bool {
                match id {
                    #(#ids => *self = Self::#names(wire::Message::decode(payload)),)*
                    _ => return false,
                }
                true
            }
        }
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

fn table(messages: &[&Message], names: &[Ident]) -> TokenStream {
    let count = decimal(names.len() as u64);
    let highest = messages.iter().map(|message| message.id).filter(|&id| id < DIRECT_IDS).max();
    let direct = decimal(highest.map_or(0, |id| id + 1));
    quote! {
        static MESSAGES: [&wire::MessageInfo; #count] = [#(<#names as wire::Message>::INFO),*];
        static INDEX: [u16; #direct] = wire::generated::index(&MESSAGES);
        static TABLE: wire::Table<'static> = wire::Table::indexed(&MESSAGES, &INDEX);
    }
}
