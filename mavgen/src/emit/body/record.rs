//! A record of values: read from fields of a message, and written to them.
//!
//! ```text
//! impl AqTelemetryF {
//!     pub fn gps(&self) -> Option<AqGps> {
//!         if self.index == 4 { Some(AqGps { pdop: self.value1, … }) } else { None }
//!     }
//!     pub fn set_gps(&mut self, value: AqGps) {
//!         self.index = 4;
//!         self.value1 = value.pdop;
//!         …
//!     }
//! }
//! ```

use super::slots::{key, stored};
use super::source::{assign, if_all_hold};
use crate::emit::token::ident;
use crate::rust::{Record, Test};
use crate::tokens::{TokenStream, quote};

/// The values, if the condition holds.
pub(in crate::emit) fn get(Record { ident: name, values, when }: &Record<'_>) -> TokenStream {
    if_all_hold(when.as_slice(), &quote!(#{ident(name)} { #(for value in values => #{key(value)}),* }))
}

/// Puts the values into their fields, and makes the condition hold.
pub(in crate::emit) fn set(Record { values, when, .. }: &Record<'_>) -> TokenStream {
    quote! {
        #(if let Some(Test::Is(place, value)) = when => #{assign(place, &quote!(#value))})
        #(for value in values => #{stored(value, &quote!(value))})*
    }
}
