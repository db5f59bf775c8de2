//! `Debug` of a message that carries a secret key, which it does not show.
//!
//! ```text
//! impl core::fmt::Debug for SetupSigning {
//!     fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
//!         f.debug_struct("SetupSigning")
//!             .field("target_system", &self.target_system)
//!             .field("secret_key", &"secret")
//!             …
//!             .finish()
//!     }
//! }
//! ```

use proc_macro2::TokenStream;
use quote::quote;

use super::token::ident;
use crate::rust::{Field, Struct};

pub(super) fn debug(message: &Struct<'_>) -> TokenStream {
    let field = |field: &Field<'_>| {
        let (shown, name) = (field.ident, ident(field.ident));
        if field.secret { quote!(.field(#shown, &"secret")) } else { quote!(.field(#shown, &self.#name)) }
    };
    let (name, shown) = (ident(message.ident), message.ident);
    let fields = message.fields.iter().map(field);
    quote! {
        impl core::fmt::Debug for #name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.debug_struct(#shown) #(#fields)* .finish()
            }
        }
    }
}
