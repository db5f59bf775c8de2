//! A message: its struct, and how it becomes bytes and back.

use super::token::ident;
use super::{doc, field};
use crate::ir;
use crate::rust::{Frame, Gives, Struct};
use crate::tokens::{TokenStream, quote};

/// The items of a message's file, without its imports.
pub(super) fn message(message: &Struct<'_>) -> TokenStream {
    let Struct { ident: name, alias, docs, fields, methods, seen, frame, .. } = message;
    let (name, alias) = (ident(name), doc::alias(*alias));
    let is_targeted = frame.target_system.and(frame.target_component).is_some();
    quote! {
        #docs
        #alias
        #[derive(Clone, Copy, PartialEq)]
        pub struct #name { #(for field in fields => #{field::declaration(field)})* }
        #(if !methods.is_empty() => impl #name { #(#methods)* })
        #{message_impl(message)}
        #(if is_targeted => impl wire::Targeted for #name {})
        wire::message!(#name #(if !seen.is_empty() => { #(for one in seen => #{self::seen(one)}),* }));
    }
}

/// `each escs`, `maybe mode`: the getter of something that an overlay sees in the message, and what it gives.
fn seen((getter, gives): &(&str, Gives)) -> TokenStream {
    let gives = match gives {
        Gives::One => "one",
        Gives::Maybe => "maybe",
        Gives::Each => "each",
    };
    quote!(#{ident(gives)} #{ident(getter)})
}

/// The implementation of `wire::Message`: the facts, the loads in the order of the XML, the stores in wire order.
fn message_impl(message: &Struct<'_>) -> TokenStream {
    let Struct { ident: name, fields, frame, .. } = message;
    let length = frame.wire.len_v2;
    quote! {
        impl wire::Message for #{ident(name)} {
            type Payload = [u8; #length];
            const INFO: &'static wire::MessageInfo = #{info(frame)};
            const FIELDS: &'static [wire::FieldInfo] = &[#(for field in fields => #{field::info(field)})*];
            const DEFAULT: Self = Self { #(for field in fields => #{field::default(field)})* };
            #[inline(always)]
            fn read(p: &[u8; #length]) -> Self {
                Self { #(for field in fields => #{field::load(field)})* }
            }
            #[inline]
            fn store(&self, p: &mut [u8; #length]) {
                #(for field in message.wire_order() => #{field::store(field)})*
            }
            #{target_mut(frame)}
        }
    }
}

/// `&wire::MessageInfo::new(24, "GPS_RAW_INT", 24, 52).len_v1(30)`
fn info(Frame { wire, target_system, target_component }: &Frame<'_>) -> TokenStream {
    let ir::Message { id, name, crc_extra, len_v1, len_v2, .. } = wire;
    quote! {
        &wire::MessageInfo::new(#id, #{&name.text}, #crc_extra, #len_v2)
            #(if len_v1 != len_v2 => .len_v1(#len_v1))
            #(if let Some((_, offset)) = target_system => .target_system(#offset))
            #(if let Some((_, offset)) = target_component => .target_component(#offset))
    }
}

/// `target_mut`, for a message that names a system or a component it is meant for.
fn target_mut(frame: &Frame<'_>) -> Option<TokenStream> {
    frame.target_system.or(frame.target_component)?;
    let reference = |target: Option<(&str, _)>| match target.map(|(field, _)| ident(field)) {
        Some(field) => quote!(Some(&mut self.#field)),
        None => quote!(None),
    };
    Some(quote! {
        #[inline]
        fn target_mut(&mut self) -> (Option<&mut u8>, Option<&mut u8>) {
            (#{reference(frame.target_system)}, #{reference(frame.target_component)})
        }
    })
}
