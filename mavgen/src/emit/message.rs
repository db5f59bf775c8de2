//! A message: its struct, and how it becomes bytes and back.
//!
//! ```text
//! /// Distance to an obstacle.
//! /// …
//! #[derive(Clone, Copy, Debug, PartialEq)]
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

use proc_macro2::TokenStream;
use quote::quote;

use crate::docs::line;
use crate::emit::field::{FieldTokens, field, xml_type};
use crate::emit::method::method;
use crate::emit::token::{decimal, ident};
use crate::emit::{Context, accessor, doc, rivals, secret};
use crate::ir::{Field, Message};
use crate::lower::Internal;

/// The items of a message's file.
pub(crate) fn message(context: &Context<'_>, message: &Message) -> Result<TokenStream, Internal> {
    let imports = imports(context, message);
    let fields: Vec<FieldTokens> = message.fields.iter().map(|one| field(context, message, one)).collect();
    let declaration = declaration(context, message, &fields);
    let message_impl = message_impl(message, &fields);
    let targeted = targeted(message);
    let accessors = accessor::accessors(context, message);
    let bindings = bindings(context, message)?;
    let name = ident(&message.name.rust);
    Ok(quote! {
        #imports
        #declaration
        #accessors
        #bindings
        #message_impl
        #targeted
        wire::message!(#name);
    })
}

/// The `impl` with the enums that overlays bind to fields; nothing if there are none.
fn bindings(context: &Context<'_>, message: &Message) -> Result<TokenStream, Internal> {
    let methods = context.items().bindings(message)?;
    if methods.is_empty() {
        return Ok(TokenStream::new());
    }
    let (name, methods) = (ident(&message.name.rust), methods.iter().map(method));
    Ok(quote!(impl #name { #(#methods)* }))
}

fn imports(context: &Context<'_>, message: &Message) -> TokenStream {
    let fields = message.fields.iter().filter_map(|field| Some(field.values?.id()));
    let bound = message.bindings.iter().map(|binding| binding.values);
    let (enums, runtime) = (context.use_enums(fields.chain(bound)), context.use_runtime());
    let wire = (!message.fields.is_empty()).then(|| {
        quote!(
            use wire::generated::{get, put};
        )
    });
    quote!(#enums #runtime #wire)
}

/// The struct, in the order of the XML.
fn declaration(context: &Context<'_>, message: &Message, fields: &[FieldTokens]) -> TokenStream {
    let docs = doc::attributes(&documentation(context, message));
    let deprecated = doc::deprecated(context, &message.origin);
    let (name, alias) = (ident(&message.name.rust), doc::alias(&message.name));
    let fields = fields.iter().map(|field| &field.declaration);
    let secretive = secret::debug(message);
    let debug = if secretive.is_some() { None } else { Some(quote!(Debug,)) };
    quote! {
        #docs
        #alias
        #deprecated
        #[derive(Clone, Copy, #debug PartialEq)]
        pub struct #name { #(#fields)* }
        #secretive
    }
}

/// The description, the facts of the frame and the wire table.
fn documentation(context: &Context<'_>, message: &Message) -> Vec<String> {
    let file = context.dialect.file(message.origin.file).map_or("", |file| file.name.as_str());
    let Message { id, name, crc_extra, len_v1, len_v2, .. } = message;
    let length = match (len_v1 == len_v2, *id > 255) {
        (true, _) if *len_v2 == 1 => "1 byte".to_owned(),
        (true, _) => format!("{len_v2} bytes"),
        (false, true) => format!("{len_v2} bytes, {len_v1} without extensions"),
        (false, false) => format!("{len_v2} bytes, {len_v1} in MAVLink 1"),
    };
    let reach = if *id > 255 { "; MAVLink 2 only" } else { "" };
    let facts = format!("`{}`, message {id} of `{file}`: {length}, CRC_EXTRA {crc_extra}{reach}.", name.text);
    let facts = match doc::reference(file, &name.text) {
        Some(link) => vec![facts, format!("See the {link}.")],
        None => vec![facts],
    };
    doc::join([doc::description(&message.origin), facts, rivals::of_message(context, message), wire_table(message)])
}

/// What lies where in the payload.
fn wire_table(message: &Message) -> Vec<String> {
    let row = |field: &Field| {
        let extension = if field.extension { " (extension)" } else { "" };
        let units = field.units.as_deref().map(line).unwrap_or_default();
        vec![
            field.offset.to_string(),
            format!("`{}`{extension}", field.name.text),
            format!("`{}`", xml_type(field)),
            units,
        ]
    };
    let rows: Vec<_> = message.wire_order().into_iter().map(row).collect();
    doc::table(&["offset", "field", "type", "units"], &rows)
}

/// The implementation of `wire::Message`: the facts, the loads in the order of the XML, the stores in wire order.
fn message_impl(message: &Message, fields: &[FieldTokens]) -> TokenStream {
    let (name, length, info) = (ident(&message.name.rust), decimal(message.len_v2), info(message));
    let infos = fields.iter().map(|field| &field.info);
    let defaults = fields.iter().map(|field| &field.default);
    let loads = fields.iter().map(|field| &field.decode);
    let mut by_offset: Vec<&FieldTokens> = fields.iter().collect();
    by_offset.sort_by_key(|field| field.offset);
    let stores = by_offset.into_iter().map(|field| &field.encode);
    let target_mut = target_mut(message);
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
fn info(message: &Message) -> TokenStream {
    let Message { id, name, crc_extra, len_v1, len_v2, .. } = message;
    let (id, name, crc_extra, length) = (decimal(*id), &name.text, decimal(*crc_extra), decimal(*len_v2));
    let shorter = decimal(*len_v1);
    let len_v1 = (len_v1 != len_v2).then(|| quote!(.len_v1(#shorter)));
    let target_system =
        message.target_system().map(|field| decimal(field.offset)).map(|at| quote!(.target_system(#at)));
    let target_component =
        message.target_component().map(|field| decimal(field.offset)).map(|at| quote!(.target_component(#at)));
    quote!(&wire::MessageInfo::new(#id, #name, #crc_extra, #length) #len_v1 #target_system #target_component)
}

/// `target_mut`, for a message that names a system or a component it is meant for.
fn target_mut(message: &Message) -> TokenStream {
    let targets = (message.target_system(), message.target_component());
    if targets.0.is_none() && targets.1.is_none() {
        return TokenStream::new();
    }
    let reference = |field: Option<&Field>| match field.map(|field| ident(&field.name.rust)) {
        Some(field) => quote!(Some(&mut self.#field)),
        None => quote!(None),
    };
    let (system, component) = (reference(targets.0), reference(targets.1));
    quote! {
        #[inline]
        fn target_mut(&mut self) -> (Option<&mut u8>, Option<&mut u8>) {
            (#system, #component)
        }
    }
}

/// `.to(system, component)`, for a message that names whom it is meant for.
fn targeted(message: &Message) -> TokenStream {
    if message.target_system().is_none() || message.target_component().is_none() {
        return TokenStream::new();
    }
    let name = ident(&message.name.rust);
    quote!(impl wire::Targeted for #name {})
}
