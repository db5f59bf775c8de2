//! Modules, what they export, and what files import.

use super::doc;
use super::token::ident;
use crate::rust::{Alias, Child, ChildAccess, Export, Use};
use crate::tokens::{TokenStream, quote};

/// `mod heartbeat; …`, then `pub use heartbeat::Heartbeat; …`, and what is deprecated by an alias.
pub(super) fn module(children: &[Child], exports: &[Export], aliases: &[Alias<'_>]) -> TokenStream {
    let children = children.iter().map(|Child { ident: name, access, expect }| {
        let (name, expect) = (ident(name), expect_deprecated(*expect));
        match access {
            ChildAccess::Private => quote!(#expect mod #name;),
            ChildAccess::Hidden => quote!(#expect #[doc(hidden)] pub mod #name;),
            ChildAccess::Public => quote!(#expect pub mod #name;),
        }
    });
    let exports = exports.iter().map(|Export { of, expect }| {
        let (of, expect) = (used(of), expect_deprecated(*expect));
        quote!(#expect pub use #of;)
    });
    let aliases = aliases.iter().map(alias);
    quote!(#(#children)* #(#exports)* #(#aliases)*)
}

/// `#[deprecated(…)] pub type HilControls = hil_controls::HilControls;`
fn alias(alias: &Alias<'_>) -> TokenStream {
    let Alias { ident: name, alias, docs, deprecated, module } = alias;
    let (docs, alias, deprecated) = (doc::documentation(docs), doc::alias(*alias), doc::deprecated(Some(deprecated)));
    let (name, module) = (ident(name), ident(module));
    quote!(#docs #alias #deprecated pub type #name = #module::#name;)
}

/// `use super::super::enums::{MavState, MavType};`
pub(super) fn import(import: &Use) -> TokenStream {
    let used = used(import);
    quote!(use #used;)
}

fn used(of: &Use) -> TokenStream {
    match of {
        Use::Names(module, names) => {
            let (module, names) = (TokenStream::of_path(module), names.iter().map(|name| ident(name)));
            quote!(#module::{#(#names),*})
        }
        Use::All(module) => {
            let module = TokenStream::of_path(module);
            quote!(#module::*)
        }
        Use::Runtime(crate_path) => {
            let runtime = TokenStream::of_path(crate_path);
            quote!(#runtime as wire)
        }
        Use::Generated(functions) => {
            let functions = functions.iter().map(|name| ident(name));
            quote!(wire::generated::{#(#functions),*})
        }
    }
}

fn expect_deprecated(needed: bool) -> Option<TokenStream> {
    needed.then(|| quote!(#[expect(deprecated, reason = "what is deprecated is still on the wire")]))
}
