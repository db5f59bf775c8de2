//! A typed command: a struct of the params that have a name, and which param each field is.
//!
//! ```text
//! /// Take off, and climb.
//! #[derive(Clone, Copy, Debug, PartialEq)]
//! pub struct NavTakeoff {
//!     /// Param 1, Pitch; in deg.
//!     pub pitch: f32,
//!     pub latitude: f64,
//! }
//!
//! impl wire::Command for NavTakeoff {
//!     type Carriers = super::Carriers;
//!
//!     const ID: u16 = 22;
//!     const DEFAULT: Self = Self { pitch: 0.0, latitude: f64::NAN };
//!
//!     #[inline]
//!     fn params(&mut self, p: &mut wire::Params) {
//!         p.float(1, &mut self.pitch);
//!         p.place(5, &mut self.latitude);
//!     }
//! }
//!
//! wire::command!(NavTakeoff);
//! ```

use super::token::{decimal, double, ident, integer, single};
use super::ty::value_of;
use super::{doc, ty};
use crate::rust::{CARRIERS, Carriers, Command, CommandField, Fixed, ParamTy};
use crate::tokens::{TokenStream, quote};

/// The items of a command's file.
pub(super) fn command(command: &Command<'_>) -> TokenStream {
    let (declaration, body, name) = (declaration(command), body(command), ident(command.ident));
    quote! {
        #declaration
        #body
        wire::command!(#name);
    }
}

/// The type that says which messages carry the commands of a module.
pub(super) fn carriers(Carriers { long, int }: &Carriers) -> TokenStream {
    let name = ident(CARRIERS);
    let long = long.as_deref().map(TokenStream::of_path);
    let long = long.map(|long| quote!(impl wire::CarriesLong for #name { type Long = #long; }));
    let int = int.as_ref().map(|(int, frame)| (TokenStream::of_path(int), TokenStream::of_path(frame)));
    let int = int.map(|(int, frame)| quote!(impl wire::CarriesInt for #name { type Int = #int; type Frame = #frame; }));
    quote! {
        /// The messages that carry the commands.
        #[derive(Clone, Copy, Debug)]
        pub enum #name {}
        #long
        #int
    }
}

fn declaration(command: &Command<'_>) -> TokenStream {
    let Command { ident: name, alias, docs, fields, .. } = command;
    let (docs, alias, name) = (doc::documentation(docs), doc::alias(Some(alias)), ident(name));
    let members = fields.iter().map(|CommandField { ident: name, ty, docs, .. }| {
        let (docs, name, ty) = (doc::documentation(docs), ident(name), ty::ty(&ty.ty()));
        quote!(#docs pub #name: #ty)
    });
    let members = if fields.is_empty() { quote!(;) } else { quote!({ #(#members),* }) };
    quote! {
        #docs
        #alias
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct #name #members
    }
}

/// The implementation of `wire::Command`.
fn body(command: &Command<'_>) -> TokenStream {
    let Command { ident: name, id, fields, fixed, .. } = command;
    let (name, id, carriers) = (ident(name), decimal(*id), ident(CARRIERS));
    let defaults = fields.iter().map(default);
    let each = fields.iter().map(param).chain(fixed.iter().map(self::fixed));
    let params = ident(if fields.is_empty() && fixed.is_empty() { "_p" } else { "p" });
    quote! {
        impl wire::Command for #name {
            type Carriers = super::#carriers;
            const ID: u16 = #id;
            const DEFAULT: Self = Self { #(#defaults),* };
            #[inline]
            fn params(&mut self, #params: &mut wire::Params) {
                #(#each)*
            }
        }
    }
}

/// `yaw: f32::NAN`
fn default(field: &CommandField<'_>) -> TokenStream {
    let (name, value) = (ident(field.ident), field.default);
    let value = match field.ty {
        ParamTy::Float => single(value as f32),
        ParamTy::Number | ParamTy::Place => double(value),
        ParamTy::Enum(one) => value_of(one.as_int(), &integer(value as i128)),
    };
    quote!(#name: #value)
}

/// `p.float(1, &mut self.pitch);`
fn param(field: &CommandField<'_>) -> TokenStream {
    let (name, index) = (ident(field.ident), decimal(field.index));
    let method = ident(match field.ty {
        ParamTy::Float => "float",
        ParamTy::Number => "number",
        ParamTy::Place => "place",
        ParamTy::Enum(_) => "entry",
    });
    quote!(p.#method(#index, &mut self.#name);)
}

/// `p.fixed(4, f64::NAN);`
fn fixed(fixed: &Fixed) -> TokenStream {
    let (index, value) = (decimal(fixed.index), double(fixed.value));
    quote!(p.fixed(#index, #value);)
}
