//! A message: its struct, and how it becomes bytes and back.
//!
//! ```text
//! /// Distance to an obstacle.
//! /// …
//! #[derive(Clone, Copy, PartialEq)]
//! pub struct Sonar {
//!     /// In cm; 65535 means not known.
//!     pub distance: u16,
//! }
//!
//! impl wire::Message for Sonar {
//!     type Payload = [u8; 2];
//!
//!     const INFO: &'static wire::MessageInfo = &wire::MessageInfo::new(4711, "SONAR", 113, 2);
//!     const FIELDS: &'static [wire::FieldInfo] = &[wire::FieldInfo::new("distance", wire::Kind::U16, 0).units("cm")];
//!     const DEFAULT: Self = Self { distance: 0 };
//!
//!     #[inline(always)]
//!     fn read(p: &[u8; 2]) -> Self {
//!         Self { distance: get(p, 0) }
//!     }
//!
//!     #[inline]
//!     fn store(&self, p: &mut [u8; 2]) {
//!         put(p, 0, self.distance);
//!     }
//! }
//!
//! wire::message!(Sonar);
//! ```

use super::method::method;
use super::token::{decimal, ident};
use super::{doc, field};
use crate::ir;
use crate::rust::{Frame, Gives, Seen, Struct};
use crate::tokens::{TokenStream, quote};

/// The items of a message's file, without its imports.
pub(super) fn message(message: &Struct<'_>) -> TokenStream {
    let (name, methods) = (ident(message.ident), message.methods.iter().map(method));
    let declaration = declaration(message);
    let methods = (!message.methods.is_empty()).then(|| quote!(impl #name { #(#methods)* }));
    let message_impl = message_impl(message);
    let Frame { target_system, target_component, .. } = message.frame;
    let targeted = target_system.and(target_component).map(|_| quote!(impl wire::Targeted for #name {}));
    let seen = seen(&message.seen);
    quote! {
        #declaration
        #methods
        #message_impl
        #targeted
        wire::message!(#name #seen);
    }
}

/// `{ each escs, maybe mode }`: what overlays see in the message; nothing for most.
fn seen(all: &[Seen<'_>]) -> Option<TokenStream> {
    let seen = all.iter().map(|Seen { getter, gives }| {
        let getter = ident(getter);
        match gives {
            Gives::One => quote!(one #getter),
            Gives::Maybe => quote!(maybe #getter),
            Gives::Each => quote!(each #getter),
        }
    });
    (!all.is_empty()).then(|| quote!({ #(#seen),* }))
}

/// The struct, in the order of the XML.
fn declaration(message: &Struct<'_>) -> TokenStream {
    let Struct { ident: name, alias, docs, fields, .. } = message;
    let (docs, alias) = (doc::documentation(docs), doc::alias(*alias));
    let (name, fields) = (ident(name), fields.iter().map(field::declaration));
    quote! {
        #docs
        #alias
        #[derive(Clone, Copy, PartialEq)]
        pub struct #name { #(#fields)* }
    }
}

/// The implementation of `wire::Message`: the facts, the loads in the order of the XML, the stores in wire order.
fn message_impl(message: &Struct<'_>) -> TokenStream {
    let Struct { ident: name, fields, frame, .. } = message;
    let (name, length, info) = (ident(name), decimal(frame.wire.len_v2), info(frame.wire));
    let (infos, defaults) = (fields.iter().map(field::info), fields.iter().map(field::default));
    let (loads, stores) = (fields.iter().map(field::load), message.wire_order().into_iter().map(field::store));
    let target_mut = target_mut(frame);
    quote! {
        impl wire::Message for #name {
            type Payload = [u8; #length];
            const INFO: &'static wire::MessageInfo = #info;
            const FIELDS: &'static [wire::FieldInfo] = &[#(#infos)*];
            const DEFAULT: Self = Self { #(#defaults)* };
            #[inline(always)]
            fn read(p: &[u8; #length]) -> Self {
                Self { #(#loads)* }
            }
            #[inline]
            fn store(&self, p: &mut [u8; #length]) {
                #(#stores)*
            }
            #target_mut
        }
    }
}

/// `&wire::MessageInfo::new(24, "GPS_RAW_INT", 24, 52).len_v1(30)`
fn info(wire: &ir::Message) -> TokenStream {
    let ir::Message { id, name, crc_extra, len_v1, len_v2, .. } = wire;
    let (id, name, crc_extra, length) = (decimal(*id), &name.text, decimal(*crc_extra), decimal(*len_v2));
    let shorter = decimal(*len_v1);
    let len_v1 = (len_v1 != len_v2).then(|| quote!(.len_v1(#shorter)));
    let offset = |target: Option<&ir::Field>| target.map(|target| decimal(target.offset));
    let target_system = offset(wire.target_system()).map(|at| quote!(.target_system(#at)));
    let target_component = offset(wire.target_component()).map(|at| quote!(.target_component(#at)));
    quote!(&wire::MessageInfo::new(#id, #name, #crc_extra, #length) #len_v1 #target_system #target_component)
}

/// `target_mut`, for a message that names a system or a component it is meant for.
fn target_mut(frame: &Frame<'_>) -> Option<TokenStream> {
    frame.target_system.or(frame.target_component)?;
    let reference = |target: Option<&str>| match target.map(ident) {
        Some(field) => quote!(Some(&mut self.#field)),
        None => quote!(None),
    };
    let (system, component) = (reference(frame.target_system), reference(frame.target_component));
    Some(quote! {
        #[inline]
        fn target_mut(&mut self) -> (Option<&mut u8>, Option<&mut u8>) {
            (#system, #component)
        }
    })
}
