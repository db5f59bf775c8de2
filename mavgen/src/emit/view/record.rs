//! The type of a slot, or of values: a struct of public fields.

use crate::emit::doc;
use crate::emit::token::ident;
use crate::emit::ty::ty;
use crate::rust::{RecordField, RecordType};
use crate::tokens::{TokenStream, quote};

/// `pub struct Esc { … }`
pub(super) fn declaration(record: &RecordType<'_>) -> TokenStream {
    let (docs, name) = (doc::documentation(&record.docs), ident(record.ident));
    let fields = record.fields.iter().map(|RecordField { ident: name, ty: of, docs }| {
        let (docs, name, of) = (doc::documentation(docs), ident(name), ty(of));
        quote!(#docs pub #name: #of,)
    });
    let names = record.fields.iter().map(|field| ident(field.ident));
    let eq = record.fields.iter().all(|field| field.ty.is_eq()).then(|| quote!(, Eq, Hash));
    quote! {
        #docs
        #[derive(Clone, Copy, Debug, Default, PartialEq #eq)]
        pub struct #name { #(#fields)* }
        wire::record!(#name { #(#names),* });
    }
}
