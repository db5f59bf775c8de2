//! A topic: its struct, its definitions, and how it is read and written, as CDR and as a record of a log.
//!
//! Of several definitions, each is read and written by functions of its own: `read_main`, `store_main`.

mod field;
mod load;
mod store;

use super::doc;
use super::token::{ident, integer, mask};
use crate::rust::{Definition, SameDefinition, Topic, TopicConstant};
use crate::tokens::{TokenStream, quote};

/// The items of a topic's file, without its imports.
pub(super) fn topic(topic: &Topic<'_>) -> TokenStream {
    let Topic { alias, docs, fields, constants, definitions, also, methods, by_length, .. } = topic;
    let (name, alias) = (ident(topic.ident), doc::alias(*alias));
    let several = definitions.get(1).map(|_| definitions);
    quote! {
        #docs
        #alias
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct #name { #(for field in fields => #{field::declaration(field)})* }
        impl #name {
            #(for TopicConstant { ident: name, docs, int, value } in constants =>
                #docs pub const #{ident(name)}: #int = #{integer(*value)};)*
            #[doc = " A value of which nothing is known."]
            pub const UNKNOWN: Self = Self { #(for field in fields => #{field::unknown(field)}),* };
            #(for definition in definitions => #{constant(topic, definition)})*
            #(for SameDefinition { constant, docs, of } in also =>
                #docs pub const #{ident(constant)}: uorb::Definition = Self::#{ident(of)};)*
            #(#methods)*
        }
        #{of_trait(topic)}
        #(if *by_length => impl uorb::TopicByLength for #name {})
        #(for definition in several.into_iter().flatten() => #{functions(topic, definition)})*
        wire::topic!(#name { #(for field in fields => #{field::bound(field)}),* });
    }
}

/// `pub const MAIN: uorb::Definition = …;`
fn constant(topic: &Topic<'_>, definition: &Definition<'_>) -> TokenStream {
    let Definition { constant, docs, name, message_hash, type_hash, cdr_len, record_len, formats, .. } = definition;
    quote! {
        #docs
        pub const #{ident(constant)}: uorb::Definition = uorb::Definition::new(#{topic.name}, #name)
            .hashes(#{mask((*message_hash).into())}, #type_hash)
            .lengths(#cdr_len, #record_len)
            .formats(&[#(#formats),*]);
    }
}

fn of_trait(topic: &Topic<'_>) -> TokenStream {
    let Topic { ident: name, name: message, topics, version, queue, definitions, record, .. } = topic;
    let record_len = definitions.first().map_or(0, |newest| newest.record_len);
    quote! {
        impl uorb::Topic for #{ident(name)} {
            const NAME: &'static str = #message;
            const TOPICS: &'static [&'static str] = &[#(for topic in *topics => #topic),*];
            #(if let Some(version) = version => const VERSION: Option<u32> = Some(#version);)
            #(if let Some(queue) = queue => const QUEUE: u32 = #queue;)
            const DEFINITIONS: &'static [uorb::Definition] = &[#(for one in definitions => Self::#{ident(one.constant)}),*];
            fn read_cdr(definition: usize, body: &[u8]) -> Result<Self, uorb::CdrError> {
                #{read_cdr(definitions)}
            }
            fn store_cdr(&self, definition: usize, body: &mut [u8]) -> Result<(), uorb::CdrError> {
                #{store_cdr(definitions)}
            }
            fn store_record(&self, record: &mut [u8]) -> Result<(), uorb::CdrError> {
                let p = wire::generated::record_mut::<#record_len>(record)?;
                #{store::all(record, &quote!(self))}
                Ok(())
            }
        }
    }
}

fn read_cdr(definitions: &[Definition<'_>]) -> TokenStream {
    if let [Definition { cdr_len, cdr, .. }] = definitions {
        return quote! {
            let p = wire::generated::body::<#cdr_len>(Self::DEFINITIONS, definition, body)?;
            #{load::body(cdr)}
        };
    }
    let body = quote!(wire::generated::body(Self::DEFINITIONS, definition, body)?);
    by_definition(definitions, |of| quote!(#{function("read", of)}(#body)))
}

fn store_cdr(definitions: &[Definition<'_>]) -> TokenStream {
    if let [Definition { cdr_len, cdr, .. }] = definitions {
        return quote! {
            let p = wire::generated::body_mut::<#cdr_len>(Self::DEFINITIONS, definition, body)?;
            #{store::all(cdr, &quote!(self))}
            Ok(())
        };
    }
    let body = quote!(wire::generated::body_mut(Self::DEFINITIONS, definition, body)?);
    by_definition(definitions, |of| quote!(#{function("store", of)}(self, #body)))
}

fn by_definition(definitions: &[Definition<'_>], call: impl Fn(&Definition<'_>) -> TokenStream) -> TokenStream {
    quote! {
        match definition {
            #(for (definition, at) in definitions.iter().zip(0_u32..) => #at => #{call(definition)},)*
            _ => Err(uorb::CdrError::Definition),
        }
    }
}

/// How a body of one of several definitions is read and written.
fn functions(topic: &Topic<'_>, definition: &Definition<'_>) -> TokenStream {
    let (name, Definition { cdr_len, cdr, .. }) = (ident(topic.ident), definition);
    quote! {
        fn #{function("read", definition)}(p: &[u8; #cdr_len]) -> Result<#name, uorb::CdrError> {
            #{load::body(cdr)}
        }
        fn #{function("store", definition)}(topic: &#name, p: &mut [u8; #cdr_len]) -> Result<(), uorb::CdrError> {
            #{store::all(cdr, &quote!(topic))}
            Ok(())
        }
    }
}

/// `read_main`
fn function(verb: &str, definition: &Definition<'_>) -> TokenStream {
    ident(&format!("{verb}_{}", definition.suffix))
}
