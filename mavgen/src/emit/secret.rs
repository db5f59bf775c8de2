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

use crate::emit::token::ident;
use crate::ir::{Field, Message};

/// Nothing for the other messages, whose `Debug` is derived.
pub(super) fn debug(message: &Message) -> Option<TokenStream> {
    let secret = message.secret()?.offset;
    let field = |field: &Field| {
        let (shown, name) = (&field.name.rust, ident(&field.name.rust));
        if field.offset == secret { quote!(.field(#shown, &"secret")) } else { quote!(.field(#shown, &self.#name)) }
    };
    let (name, shown) = (ident(&message.name.rust), &message.name.rust);
    let fields = message.fields.iter().map(field);
    Some(quote! {
        impl core::fmt::Debug for #name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.debug_struct(#shown) #(#fields)* .finish()
            }
        }
    })
}
