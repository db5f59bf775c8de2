//! Modules, what they export, and what files import.

use super::doc;
use super::token::ident;
use crate::rust::{Alias, Child, ChildAccess, Export, Use};
use crate::tokens::{ToTokens, TokenStream, quote};

/// `mod heartbeat; …`, then `pub use heartbeat::Heartbeat; …`, and what is deprecated by an alias.
pub(super) fn module(children: &[Child], exports: &[Export], aliases: &[Alias<'_>]) -> TokenStream {
    quote! {
        #(for Child { ident: name, access, expect, feature } in children =>
            #{gate(feature.as_ref())}
            #{expect_deprecated(*expect)}
            #(if *access == ChildAccess::Hidden => #[doc(hidden)])
            #(if *access != ChildAccess::Private => pub)
            mod #{ident(name)};
        )*
        #(for Export { of, expect, feature } in exports =>
            #{gate(feature.as_ref())}
            #{expect_deprecated(*expect)}
            pub use #of;
        )*
        #(#aliases)*
    }
}

/// `#[deprecated(…)] pub type HilControls = hil_controls::HilControls;`
impl ToTokens for Alias<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        let Self { ident: name, alias, docs, deprecated, module } = self;
        let (alias, deprecated) = (doc::alias(*alias), doc::deprecated(Some(deprecated)));
        let (name, module) = (ident(name), ident(module));
        quote!(#docs #alias #deprecated pub type #name = #module::#name;).to_tokens(tokens);
    }
}

/// `super::super::enums::{MavState, MavType}`
impl ToTokens for Use {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        let path = TokenStream::of_path;
        match self {
            Self::Names(module, names) => quote!(#{path(module)}::{#(for name in names => #{ident(name)}),*}),
            Self::All(module) => quote!(#{path(module)}::*),
            Self::Runtime(runtime) => quote!(#{path(runtime)} as wire),
            Self::Generated(functions) => quote!(wire::generated::{#(for name in functions => #{ident(name)}),*}),
        }
        .to_tokens(tokens);
    }
}

/// `#[cfg(feature = "commands")]`
fn gate(feature: Option<&String>) -> Option<TokenStream> {
    feature.map(|feature| quote!(#[cfg(feature = #feature)]))
}

fn expect_deprecated(needed: bool) -> Option<TokenStream> {
    needed.then(|| quote!(#[expect(deprecated, reason = "what is deprecated is still on the wire")]))
}
