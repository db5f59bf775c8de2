//! An enum or a set of flags: an open newtype, its constants, and the table of its names.
//!
//! ```text
//! /// State of a system.
//! #[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
//! pub struct MavState(pub u8);
//!
//! impl MavState {
//!     /// Booting.
//!     pub const BOOT: Self = Self(1);
//! }
//!
//! static INFO: wire::EnumInfo = wire::EnumInfo::new("MAV_STATE", &[(1, "MAV_STATE_BOOT")]);
//!
//! wire::open_enum!(MavState, u8, INFO);
//! ```

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::token::{bits, decimal, ident, repr};
use crate::emit::{Context, command, doc, rivals};
use crate::ir::{Entry, Enum};
use crate::lower::docs;
use crate::rust::Docs;

/// The items of an enum's file.
pub(crate) fn enum_(context: &Context<'_>, values: &Enum) -> TokenStream {
    let declaration = declaration(context, values);
    let constants = values.entries.iter().map(|entry| constant(context, values, entry));
    let commands = command::params(context, values);
    let info = info(values);
    let (name, int, runtime) = (ident(&values.name.rust), repr(values.repr), context.use_runtime());
    let kind = ident(if values.bitmask { "flags" } else { "open_enum" });
    quote! {
        #runtime
        #declaration
        impl #name { #(#constants)* }
        #commands
        #info
        wire::#kind!(#name, #int, INFO);
    }
}

fn declaration(context: &Context<'_>, values: &Enum) -> TokenStream {
    let docs = doc::attributes(&documentation(context, values));
    let deprecated = doc::deprecated(context.items().deprecation(&values.origin).as_ref());
    let (name, int, alias) =
        (ident(&values.name.rust), repr(values.repr), doc::alias(docs::alias(&values.name.text, &values.name.rust)));
    let inner = if values.bitmask { quote!(#int) } else { quote!(pub #int) };
    quote! {
        #docs
        #alias
        #deprecated
        #[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct #name(#inner);
    }
}

fn documentation(context: &Context<'_>, values: &Enum) -> Vec<String> {
    let file = context.dialect.file(values.defined_in).map_or("", |file| file.name.as_str());
    let kind = if values.bitmask { "flags in a" } else { "numbers of type" };
    let facts = vec![format!("`{}` of `{file}`: {kind} `{}`.", values.name.text, values.repr.rust_name())];
    let facts = facts.into_iter().chain(docs::reference(file, &values.name.text)).collect();
    let docs = Docs(docs::description(&values.origin));
    doc::join([doc::lines(&docs), facts, rivals::of_enum(context, values)])
}

/// `pub const BOOT: Self = Self(1);` with its documentation.
fn constant(context: &Context<'_>, values: &Enum, entry: &Entry) -> TokenStream {
    let mut docs = doc::lines(&Docs(docs::description(&entry.origin)));
    if docs.is_empty() {
        docs.push(format!("`{}`.", entry.name.text));
    }
    let params = entry.command.as_ref().map(|command| command::documentation(context, command));
    let docs = doc::attributes(&doc::join([docs, params.unwrap_or_default()]));
    let deprecated = doc::deprecated(context.items().deprecation(&entry.origin).as_ref());
    let name = ident(&entry.name.rust);
    let value = if values.bitmask { bits(entry.value) } else { quote_decimal(entry.value) };
    quote! {
        #docs
        #deprecated
        pub const #name: Self = Self(#value);
    }
}

fn quote_decimal(value: u64) -> TokenStream {
    let value = decimal(value);
    quote!(#value)
}

fn info(values: &Enum) -> TokenStream {
    let (name, bitmask) = (&values.name.text, values.bitmask);
    let entries = values.entries.iter().map(|entry| {
        let (value, name) = (if bitmask { bits(entry.value) } else { quote_decimal(entry.value) }, &entry.name.text);
        quote!((#value, #name))
    });
    let kind = ident(if bitmask { "bitmask" } else { "new" });
    quote!(static INFO: wire::EnumInfo = wire::EnumInfo::#kind(#name, &[#(#entries),*]);)
}
