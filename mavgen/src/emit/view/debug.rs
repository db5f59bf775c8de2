//! `Debug` of a view: values with their units, as a person reads them.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::token::ident;
use crate::ir::{Meaning, Member, Presence, View};

pub(super) fn debug(view: &View) -> TokenStream {
    let (name, shown) = (ident(&view.name.rust), &view.name.rust);
    let fields = view.members.iter().map(field);
    quote! {
        impl core::fmt::Debug for #name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                let mut shown = f.debug_struct(#shown);
                #(#fields)*
                shown.finish()
            }
        }
    }
}

/// Digits behind the point that show every value of a fraction, or two where no number of them does.
fn decimals(divisor: i64) -> usize {
    let ends = |digits: &u32| 10_i64.checked_pow(*digits).is_some_and(|power| power % divisor == 0);
    (0..=6).find(ends).map_or(2, |digits| digits as usize)
}

fn field(member: &Member) -> TokenStream {
    let (name, getter) = (&member.name.rust(), ident(&member.name.rust()));
    let units = match &member.meaning {
        Meaning::Number { units } => units.as_deref(),
        Meaning::Scaled(scaled) => scaled.units.as_deref(),
        Meaning::Flag | Meaning::Values(_) => None,
    };
    let digits = match &member.meaning {
        Meaning::Scaled(scaled) => format!(":.{}", decimals(scaled.divisor)),
        _ => String::new(),
    };
    // Braces would be taken for placeholders.
    let format = units.map(|units| format!("{{value{digits}}} {}", units.replace('{', "{{").replace('}', "}}")));
    let value = format.map_or_else(|| quote!(&value), |format| quote!(&format_args!(#format)));
    if let Some(repeat) = member.repeat {
        let count = Literal::u8_unsuffixed(repeat.count);
        return quote! {
            let value: [_; #count] = core::array::from_fn(|index| self.#getter(index).unwrap_or_default());
            shown.field(#name, &value);
        };
    }
    match member.presence {
        Presence::Always => quote! {
            let value = self.#getter();
            shown.field(#name, #value);
        },
        Presence::When(_) => quote! {
            if let Some(value) = self.#getter() {
                shown.field(#name, #value);
            }
        },
    }
}
