//! A topic: its struct, its definitions, and how it is read and written, as CDR and as a record of a log.
//!
//! ```text
//! /// State of a pump.
//! /// …
//! #[derive(Clone, Copy, Debug, PartialEq)]
//! pub struct PumpStatus {
//!     /// In us.
//!     pub timestamp: u64,
//! }
//!
//! impl PumpStatus {
//!     /// Nothing is known.
//!     pub const UNKNOWN: Self = Self { timestamp: 0 };
//!     /// Definition `main`: …
//!     pub const MAIN: wire::uorb::Definition = wire::uorb::Definition::new("PumpStatus", "main")…;
//! }
//!
//! impl wire::uorb::Topic for PumpStatus {
//!     …
//! }
//!
//! impl wire::uorb::TopicByLength for PumpStatus {}
//!
//! fn read_main(p: &[u8; 8]) -> Result<PumpStatus, wire::uorb::CdrError> {
//!     Ok(PumpStatus { timestamp: get(p, 0) })
//! }
//!
//! fn store_main(topic: &PumpStatus, p: &mut [u8; 8]) -> Result<(), wire::uorb::CdrError> {
//!     put(p, 0, topic.timestamp);
//!     Ok(())
//! }
//!
//! wire::topic!(PumpStatus { timestamp });
//! ```

mod field;
mod load;
mod record;
mod store;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::doc;
use super::method::method;
use super::token::{decimal, ident, integer, mask};
use super::ty::int;
use crate::rust::{Definition, SameDefinition, Topic, TopicConstant};

/// The items of a topic's file, without its imports.
pub(super) fn topic(topic: &Topic<'_>) -> TokenStream {
    let name = ident(topic.ident);
    let (declaration, inherent, of_trait) = (declaration(topic), inherent(topic), of_trait(topic));
    let by_length = topic.by_length.then(|| quote!(impl wire::uorb::TopicByLength for #name {}));
    let functions = topic.definitions.iter().map(|definition| functions(topic, definition));
    let fields = topic.fields.iter().map(|field| ident(field.slot.ident));
    quote! {
        #declaration
        #inherent
        #of_trait
        #by_length
        #(#functions)*
        wire::topic!(#name { #(#fields),* });
    }
}

fn declaration(topic: &Topic<'_>) -> TokenStream {
    let (docs, alias, name) = (doc::documentation(&topic.docs), doc::alias(topic.alias), ident(topic.ident));
    let fields = topic.fields.iter().map(field::declaration);
    quote! {
        #docs
        #alias
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct #name { #(#fields)* }
    }
}

/// Constants, and methods beside the fields.
fn inherent(topic: &Topic<'_>) -> TokenStream {
    let name = ident(topic.ident);
    let constants = topic.constants.iter().map(constant);
    let unknown = topic.fields.iter().map(field::unknown);
    let definitions = topic.definitions.iter().map(|one| definition(topic, one));
    let also = topic.also.iter().map(|SameDefinition { constant, docs, of }| {
        let (docs, constant, of) = (doc::documentation(docs), ident(constant), ident(of));
        quote!(#docs pub const #constant: wire::uorb::Definition = Self::#of;)
    });
    let methods = topic.methods.iter().map(method);
    let is_blank = topic.asked_if_blank.then(|| store::is_blank(topic));
    quote! {
        impl #name {
            #(#constants)*
            #[doc = " A value of which nothing is known."]
            pub const UNKNOWN: Self = Self { #(#unknown),* };
            #(#definitions)*
            #(#also)*
            #(#methods)*
            #is_blank
        }
    }
}

/// `pub const CONNECTED_ESC_MAX: u8 = 12;`
fn constant(constant: &TopicConstant<'_>) -> TokenStream {
    let (docs, name, ty) = (doc::documentation(&constant.docs), ident(constant.ident), int(constant.int));
    let value = integer(constant.value);
    quote!(#docs pub const #name: #ty = #value;)
}

/// `pub const MAIN: wire::uorb::Definition = …;`
fn definition(topic: &Topic<'_>, definition: &Definition<'_>) -> TokenStream {
    let Definition { constant, docs, name, message_hash, type_hash, cdr_len, record_len, formats, .. } = definition;
    let (docs, constant, message) = (doc::documentation(docs), ident(constant), topic.name);
    let (message_hash, cdr_len, record_len) = (mask(*message_hash), decimal(*cdr_len), decimal(*record_len));
    quote! {
        #docs
        pub const #constant: wire::uorb::Definition = wire::uorb::Definition::new(#message, #name)
            .hashes(#message_hash, #type_hash)
            .lengths(#cdr_len, #record_len)
            .formats(&[#(#formats),*]);
    }
}

fn of_trait(topic: &Topic<'_>) -> TokenStream {
    let Topic { name: message, topics, definitions, .. } = topic;
    let (name, places) = (ident(topic.ident), decimal(topic.places() as u64));
    let version = topic.version.map(decimal).map(|of| quote!(const VERSION: Option<u32> = Some(#of);));
    let queue = topic.queue.map(decimal).map(|of| quote!(const QUEUE: u32 = #of;));
    let constants = definitions.iter().map(|definition| ident(definition.constant));
    let fields = topic.fields.iter().map(field::info);
    let (read, store) = (record::read(topic), record::store(topic));
    let (read_cdr, store_cdr) = (read_cdr(definitions), store_cdr(definitions));
    quote! {
        impl wire::uorb::Topic for #name {
            const NAME: &'static str = #message;
            const TOPICS: &'static [&'static str] = &[#(#topics),*];
            #version
            #queue
            const DEFINITIONS: &'static [wire::uorb::Definition] = &[#(Self::#constants),*];
            const FIELDS: &'static [wire::uorb::Field] = &[#(#fields),*];
            const UNKNOWN: Self = Self::UNKNOWN;
            type Places = [wire::uorb::Place; #places];
            const ABSENT: Self::Places = [wire::uorb::Place::ABSENT; #places];
            #read
            #store
            #read_cdr
            #store_cdr
        }
    }
}

fn read_cdr(definitions: &[Definition<'_>]) -> TokenStream {
    let arms = definitions.iter().zip(0_u32..).map(|(definition, at)| {
        let (at, function) = (decimal(at), format_ident!("read_{}", definition.suffix));
        quote!(#at => #function(wire::generated::body(body, <Self as wire::uorb::Topic>::DEFINITIONS)?),)
    });
    quote! {
        #[inline]
        fn read_cdr(definition: usize, body: &[u8]) -> Result<Self, wire::uorb::CdrError> {
            match definition {
                #(#arms)*
                _ => Err(wire::uorb::CdrError::Definition),
            }
        }
    }
}

fn store_cdr(definitions: &[Definition<'_>]) -> TokenStream {
    let arms = definitions.iter().zip(0_u32..).map(|(definition, at)| {
        let (at, function) = (decimal(at), format_ident!("store_{}", definition.suffix));
        quote!(#at => #function(self, wire::generated::body_mut(body)?),)
    });
    quote! {
        #[inline]
        fn store_cdr(&self, definition: usize, body: &mut [u8]) -> Result<(), wire::uorb::CdrError> {
            match definition {
                #(#arms)*
                _ => Err(wire::uorb::CdrError::Definition),
            }
        }
    }
}

/// How a body of a definition is read and written.
fn functions(topic: &Topic<'_>, definition: &Definition<'_>) -> TokenStream {
    let (name, length) = (ident(topic.ident), decimal(definition.cdr_len));
    let (read, store) = (format_ident!("read_{}", definition.suffix), format_ident!("store_{}", definition.suffix));
    let loads = load::body(topic.ident, definition);
    let stores = store::all(&quote!(topic), &definition.cdr, 0);
    quote! {
        fn #read(p: &[u8; #length]) -> Result<#name, wire::uorb::CdrError> {
            #loads
        }
        fn #store(topic: &#name, p: &mut [u8; #length]) -> Result<(), wire::uorb::CdrError> {
            #stores
            Ok(())
        }
    }
}
