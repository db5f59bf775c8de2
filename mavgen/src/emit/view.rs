//! A view: a small type over packed bits, with getters, setters and a `Debug` with units, or a record of values; and how a
//! message gives it.

use super::token::ident;
use crate::rust::{Debugged, Docs, Packed, RecordField, RecordType, View};
use crate::tokens::{TokenStream, quote};

/// The items of a view's file, without its imports.
pub(super) fn view(view: &View<'_>) -> TokenStream {
    let View { packed, record, message, message_methods: methods } = view;
    quote! {
        #(if let Some(packed) = packed => #{self::packed(packed)})
        #(if let Some(record) = record => #{self::record(record)})
        impl #{ident(message)} { #(#methods)* }
    }
}

/// The type over the bits.
fn packed(packed: &Packed<'_>) -> TokenStream {
    let Packed { ident: text, docs, storage, switch, methods, debug: members } = packed;
    let (name, switch) = (ident(text), switch.as_ref().map(|(name, of)| (ident(name), of)));
    let empty = Docs::line("All bits zero.");
    quote! {
        #docs
        #[derive(Clone, Copy, PartialEq, Eq, Hash)]
        pub struct #name { bits: #storage, #(if let Some((switch, of)) = &switch => #switch: #of,) }
        impl #name {
            #empty
            pub const EMPTY: Self = Self { bits: 0 #(if let Some((switch, _)) = &switch => , #switch: 0) };
            #(#methods)*
        }
        impl core::fmt::Debug for #name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                let mut shown = f.debug_struct(#text);
                #(for member in members => #{shown(member)})*
                shown.finish()
            }
        }
        wire::view!(#name { bits #(if let Some((switch, _)) = &switch => , #switch) } [
            #(for Debugged { ident: name, count, .. } in members =>
                #{ident(name)} #(if let Some(count) = count => [#count])),*
        ]);
    }
}

/// Shows a member with its unit, as a person reads it.
fn shown(Debugged { ident: name, units, decimals, count, optional }: &Debugged<'_>) -> TokenStream {
    let getter = ident(name);
    let value = match units {
        Some(units) => quote!(&format_args!(#{with_units(units, *decimals)})),
        None => quote!(&value),
    };
    match count {
        Some(count) => quote! {
            let value: [_; #count] = core::array::from_fn(|index| self.#getter(index).unwrap_or_default());
            shown.field(#name, &value);
        },
        None if *optional => quote! {
            if let Some(value) = self.#getter() {
                shown.field(#name, #value);
            }
        },
        None => quote! {
            let value = self.#getter();
            shown.field(#name, #value);
        },
    }
}

/// `{value:.2} degC`; braces in a unit would be taken for placeholders.
fn with_units(units: &str, decimals: Option<usize>) -> String {
    let digits = decimals.map_or_else(String::new, |decimals| format!(":.{decimals}"));
    format!("{{value{digits}}} {}", units.replace('{', "{{").replace('}', "}}"))
}

/// The type of a slot, or of values: `pub struct Esc { … }`.
fn record(RecordType { ident: name, docs, fields }: &RecordType<'_>) -> TokenStream {
    let name = ident(name);
    let is_eq = fields.iter().all(|field| field.ty.is_eq());
    quote! {
        #docs
        #[derive(Clone, Copy, Debug, Default, PartialEq #(if is_eq => , Eq, Hash))]
        pub struct #name { #(for RecordField { ident: name, ty, docs } in fields => #docs pub #{ident(name)}: #ty,)* }
        wire::record!(#name { #(for field in fields => #{ident(field.ident)}),* });
    }
}
