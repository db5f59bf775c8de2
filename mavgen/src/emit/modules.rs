//! Modules, what they export, and what files import.

use proc_macro2::TokenStream;
use quote::quote;

use super::doc;
use super::token::ident;
use crate::internal::Internal;
use crate::rust::{Alias, Child, ChildAccess, Export, Use};

/// `mod heartbeat; …`, then `pub use heartbeat::Heartbeat; …`, and what is deprecated by an alias.
pub(super) fn module(children: &[Child], exports: &[Export], aliases: &[Alias<'_>]) -> Result<TokenStream, Internal> {
    let children = children.iter().map(|Child { ident: name, access, expect }| {
        let (name, expect) = (ident(name), expect_deprecated(*expect));
        match access {
            ChildAccess::Private => quote!(#expect mod #name;),
            ChildAccess::Hidden => quote!(#expect #[doc(hidden)] pub mod #name;),
            ChildAccess::Public => quote!(#expect pub mod #name;),
        }
    });
    let exports = exports.iter().map(|Export { of, expect }| {
        let (of, expect) = (used(of)?, expect_deprecated(*expect));
        Ok(quote!(#expect pub use #of;))
    });
    let exports = exports.collect::<Result<Vec<_>, Internal>>()?;
    let aliases = aliases.iter().map(alias);
    Ok(quote!(#(#children)* #(#exports)* #(#aliases)*))
}

/// `#[deprecated(…)] pub type HilControls = hil_controls::HilControls;`
fn alias(alias: &Alias<'_>) -> TokenStream {
    let Alias { ident: name, alias, docs, deprecated, module } = alias;
    let (docs, alias, deprecated) = (doc::documentation(docs), doc::alias(*alias), doc::deprecated(Some(deprecated)));
    let (name, module) = (ident(name), ident(module));
    quote!(#docs #alias #deprecated pub type #name = #module::#name;)
}

/// `use super::super::enums::{MavState, MavType};`
pub(super) fn import(import: &Use) -> Result<TokenStream, Internal> {
    let used = used(import)?;
    Ok(quote!(use #used;))
}

fn used(of: &Use) -> Result<TokenStream, Internal> {
    Ok(match of {
        Use::Names(module, names) => {
            let (module, names) = (path(module)?, names.iter().map(|name| ident(name)));
            quote!(#module::{#(#names),*})
        }
        Use::All(module) => {
            let module = path(module)?;
            quote!(#module::*)
        }
        Use::Runtime(crate_path) => {
            let runtime = path(crate_path)?;
            quote!(#runtime as wire)
        }
        Use::Generated(functions) => {
            let functions = functions.iter().map(|name| ident(name));
            quote!(wire::generated::{#(#functions),*})
        }
    })
}

/// A path as tokens.
pub(super) fn path(text: &str) -> Result<TokenStream, Internal> {
    text.parse().map_err(|error| Internal::new(format!("`{text}` is no path: {error}")))
}

fn expect_deprecated(needed: bool) -> Option<TokenStream> {
    needed.then(|| quote!(#[expect(deprecated, reason = "what is deprecated is still on the wire")]))
}
