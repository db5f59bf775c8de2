//! A typed command: a struct of the params that have a name, and which param each field is.

use super::token::{double, ident, integer, single};
use super::ty::value_of;
use crate::rust::{CARRIERS, Carriers, Command, CommandField, Element, ParamTy};
use crate::tokens::{TokenStream, quote};

/// The items of a command's file.
pub(super) fn command(command: &Command<'_>) -> TokenStream {
    let Command { ident: name, alias, docs, id, fields, fixed, .. } = command;
    let (name, carriers) = (ident(name), ident(CARRIERS));
    let members =
        quote!(#(for CommandField { ident: name, ty, docs, .. } in fields => #docs pub #{ident(name)}: #{ty.ty()}),*);
    let params = ident(if fields.is_empty() && fixed.is_empty() { "_p" } else { "p" });
    quote! {
        #docs
        #[doc(alias = #alias)]
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct #name #(if fields.is_empty() => ;) #(if !fields.is_empty() => { #members })
        impl wire::Command for #name {
            type Carriers = super::#carriers;
            const ID: u16 = #id;
            const DEFAULT: Self = Self { #(for field in fields => #{ident(field.ident)}: #{default(field)}),* };
            #[inline]
            fn params(&mut self, #params: &mut wire::Params) {
                #(for CommandField { ident: name, index, ty, .. } in fields => p.#{method(*ty)}(#index, &mut self.#{ident(name)});)*
                #(for (index, value) in fixed => p.fixed(#index, #{double(*value)});)*
            }
        }
        wire::command!(#name);
    }
}

/// The type that says which messages carry the commands of a module.
pub(super) fn carriers(Carriers { long, int }: &Carriers) -> TokenStream {
    let (name, path) = (ident(CARRIERS), TokenStream::of_path);
    quote! {
        /// The messages that carry the commands.
        #[derive(Clone, Copy, Debug)]
        pub enum #name {}
        #(if let Some(long) = long => impl wire::CarriesLong for #name { type Long = #{path(long)}; })
        #(if let Some((int, frame)) = int =>
            impl wire::CarriesInt for #name { type Int = #{path(int)}; type Frame = #{path(frame)}; })
    }
}

/// `f32::NAN`
fn default(field: &CommandField<'_>) -> TokenStream {
    match field.ty {
        ParamTy::Float => single(field.default as f32),
        ParamTy::Number | ParamTy::Place => double(field.default),
        ParamTy::Enum(one) => value_of(Element::Enum(one), &integer(field.default as i128)),
    }
}

/// What of `wire::Params` takes or gives a param.
fn method(ty: ParamTy<'_>) -> TokenStream {
    ident(match ty {
        ParamTy::Float => "float",
        ParamTy::Number => "number",
        ParamTy::Place => "place",
        ParamTy::Enum(_) => "entry",
    })
}
