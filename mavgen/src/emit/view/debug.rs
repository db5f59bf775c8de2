//! `Debug` of a view: values with their units, as a person reads them.

use crate::emit::token::ident;
use crate::rust::Debugged;
use crate::tokens::{Literal, TokenStream, quote};

pub(super) fn debug(name: &str, members: &[Debugged<'_>]) -> TokenStream {
    let (ident, members) = (ident(name), members.iter().map(member));
    quote! {
        impl core::fmt::Debug for #ident {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                let mut shown = f.debug_struct(#name);
                #(#members)*
                shown.finish()
            }
        }
    }
}

fn member(member: &Debugged<'_>) -> TokenStream {
    let Debugged { ident: name, units, decimals, count, optional } = member;
    let getter = ident(name);
    let value = match units {
        Some(units) => {
            let format = with_units(units, *decimals);
            quote!(&format_args!(#format))
        }
        None => quote!(&value),
    };
    match count.map(Literal::of) {
        Some(count) => quote! {
            let value: [_; #count] = core::array::from_fn(|index| self.#getter(index).unwrap_or_default());
            shown.field(#name, &value);
        },
        None if *optional => quote! {
            if let Some(value) = self.#getter() {
                shown.field(#name, #value);
            }
        },
        None => quote! {
            let value = self.#getter();
            shown.field(#name, #value);
        },
    }
}

/// `{value:.2} degC`; braces in a unit would be taken for placeholders.
fn with_units(units: &str, decimals: Option<usize>) -> String {
    let digits = decimals.map_or_else(String::new, |decimals| format!(":.{decimals}"));
    format!("{{value{digits}}} {}", units.replace('{', "{{").replace('}', "}}"))
}
