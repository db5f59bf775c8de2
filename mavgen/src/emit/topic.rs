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
//!     /// A value of which nothing is known.
//!     pub const UNKNOWN: Self = Self { timestamp: 0 };
//!     /// Definition `main`: …
//!     pub const MAIN: uorb::Definition = uorb::Definition::new("PumpStatus", "main")…;
//! }
//!
//! impl uorb::Topic for PumpStatus {
//!     …
//!     fn read_cdr(definition: usize, body: &[u8]) -> Result<Self, uorb::CdrError> {
//!         let p = wire::generated::body::<8>(Self::DEFINITIONS, definition, body)?;
//!         Ok(PumpStatus { timestamp: get(p, 0) })
//!     }
//! }
//!
//! impl uorb::TopicByLength for PumpStatus {}
//!
//! wire::topic!(PumpStatus { timestamp });
//! ```
//!
//! Of several definitions, each is read and written by functions of its own: `read_main`, `store_main`.

mod field;
mod load;
mod store;

use super::doc;
use super::method::method;
use super::token::{decimal, ident, integer, mask};
use super::ty::int;
use crate::rust::{Definition, SameDefinition, Topic, TopicConstant};
use crate::tokens::{TokenStream, quote};

/// The items of a topic's file, without its imports.
pub(super) fn topic(topic: &Topic<'_>) -> TokenStream {
    let name = ident(topic.ident);
    let (declaration, inherent, of_trait) = (declaration(topic), inherent(topic), of_trait(topic));
    let by_length = topic.by_length.then(|| quote!(impl uorb::TopicByLength for #name {}));
    let functions = match topic.definitions.as_slice() {
        [_] => TokenStream::new(),
        several => several.iter().map(|definition| functions(topic, definition)).collect(),
    };
    let fields = topic.fields.iter().map(field::bound);
    quote! {
        #declaration
        #inherent
        #of_trait
        #by_length
        #functions
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
        quote!(#docs pub const #constant: uorb::Definition = Self::#of;)
    });
    let methods = topic.methods.iter().map(method);
    quote! {
        impl #name {
            #(#constants)*
            #[doc = " A value of which nothing is known."]
            pub const UNKNOWN: Self = Self { #(#unknown),* };
            #(#definitions)*
            #(#also)*
            #(#methods)*
        }
    }
}

/// `pub const CONNECTED_ESC_MAX: u8 = 12;`
fn constant(constant: &TopicConstant<'_>) -> TokenStream {
    let (docs, name, ty) = (doc::documentation(&constant.docs), ident(constant.ident), int(constant.int));
    let value = integer(constant.value);
    quote!(#docs pub const #name: #ty = #value;)
}

/// `pub const MAIN: uorb::Definition = …;`
fn definition(topic: &Topic<'_>, definition: &Definition<'_>) -> TokenStream {
    let Definition { constant, docs, name, message_hash, type_hash, cdr_len, record_len, formats, .. } = definition;
    let (docs, constant, message) = (doc::documentation(docs), ident(constant), topic.name);
    let (message_hash, cdr_len, record_len) = (mask(*message_hash), decimal(*cdr_len), decimal(*record_len));
    quote! {
        #docs
        pub const #constant: uorb::Definition = uorb::Definition::new(#message, #name)
            .hashes(#message_hash, #type_hash)
            .lengths(#cdr_len, #record_len)
            .formats(&[#(#formats),*]);
    }
}

fn of_trait(topic: &Topic<'_>) -> TokenStream {
    let Topic { name: message, topics, definitions, .. } = topic;
    let name = ident(topic.ident);
    let version = topic.version.map(decimal).map(|of| quote!(const VERSION: Option<u32> = Some(#of);));
    let queue = topic.queue.map(decimal).map(|of| quote!(const QUEUE: u32 = #of;));
    let (topics, constants) = (topics.iter(), definitions.iter().map(|definition| ident(definition.constant)));
    let (read_cdr, store_cdr, store_record) = (read_cdr(definitions), store_cdr(definitions), store_record(topic));
    quote! {
        impl uorb::Topic for #name {
            const NAME: &'static str = #message;
            const TOPICS: &'static [&'static str] = &[#(#topics),*];
            #version
            #queue
            const DEFINITIONS: &'static [uorb::Definition] = &[#(Self::#constants),*];
            fn read_cdr(definition: usize, body: &[u8]) -> Result<Self, uorb::CdrError> {
                #read_cdr
            }
            fn store_cdr(&self, definition: usize, body: &mut [u8]) -> Result<(), uorb::CdrError> {
                #store_cdr
            }
            fn store_record(&self, record: &mut [u8]) -> Result<(), uorb::CdrError> {
                #store_record
            }
        }
    }
}

fn read_cdr(definitions: &[Definition<'_>]) -> TokenStream {
    if let [one] = definitions {
        let (length, loads) = (decimal(one.cdr_len), load::body(&one.cdr));
        return quote! {
            let p = wire::generated::body::<#length>(Self::DEFINITIONS, definition, body)?;
            #loads
        };
    }
    let arms = definitions.iter().zip(0_u32..).map(|(definition, at)| {
        let (at, function) = (decimal(at), ident(&format!("read_{}", definition.suffix)));
        quote!(#at => #function(wire::generated::body(Self::DEFINITIONS, definition, body)?),)
    });
    quote! {
        match definition {
            #(#arms)*
            _ => Err(uorb::CdrError::Definition),
        }
    }
}

fn store_cdr(definitions: &[Definition<'_>]) -> TokenStream {
    if let [one] = definitions {
        let (length, stores) = (decimal(one.cdr_len), store::all(&one.cdr, &quote!(self)));
        return quote! {
            let p = wire::generated::body_mut::<#length>(Self::DEFINITIONS, definition, body)?;
            #stores
            Ok(())
        };
    }
    let arms = definitions.iter().zip(0_u32..).map(|(definition, at)| {
        let (at, function) = (decimal(at), ident(&format!("store_{}", definition.suffix)));
        quote!(#at => #function(self, wire::generated::body_mut(Self::DEFINITIONS, definition, body)?),)
    });
    quote! {
        match definition {
            #(#arms)*
            _ => Err(uorb::CdrError::Definition),
        }
    }
}

fn store_record(topic: &Topic<'_>) -> TokenStream {
    let length = decimal(topic.definitions.first().map_or(0, |newest| newest.record_len));
    let stores = store::all(&topic.record, &quote!(self));
    quote! {
        let p = wire::generated::record_mut::<#length>(record)?;
        #stores
        Ok(())
    }
}

/// How a body of one of several definitions is read and written.
fn functions(topic: &Topic<'_>, definition: &Definition<'_>) -> TokenStream {
    let (name, length) = (ident(topic.ident), decimal(definition.cdr_len));
    let (read, store) = (ident(&format!("read_{}", definition.suffix)), ident(&format!("store_{}", definition.suffix)));
    let (loads, stores) = (load::body(&definition.cdr), store::all(&definition.cdr, &quote!(topic)));
    quote! {
        fn #read(p: &[u8; #length]) -> Result<#name, uorb::CdrError> {
            #loads
        }
        fn #store(topic: &#name, p: &mut [u8; #length]) -> Result<(), uorb::CdrError> {
            #stores
            Ok(())
        }
    }
}
