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
use crate::emit::ty::literal;
use crate::rust::{Record, Test};
use crate::tokens::{TokenStream, quote};

/// The values, if the condition holds.
pub(in crate::emit) fn get(record: &Record<'_>) -> TokenStream {
    let (name, values) = (ident(record.ident), record.values.iter().map(key));
    if_all_hold(record.when.as_slice(), &quote!(#name { #(#values),* }))
}

/// Puts the values into their fields, and makes the condition hold.
pub(in crate::emit) fn set(record: &Record<'_>) -> TokenStream {
    let condition = record.when.iter().filter_map(|test| match test {
        Test::Is(place, value) => Some(assign(place, &literal(*value))),
        Test::IsNot(..) | Test::WordsAreNot(_) => None,
    });
    let values = record.values.iter().map(|value| stored(value, &quote!(value)));
    quote!(#(#condition)* #(#values)*)
}
