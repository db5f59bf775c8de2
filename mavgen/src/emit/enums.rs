//! An enum or a set of flags: an open newtype, its constants, the table of its names, and the parameters of commands.
//!
//! ```text
//! /// State of a system.
//! #[derive(Clone, Copy, PartialEq)]
//! pub struct MavState(pub u8);
//!
//! impl MavState {
//!     /// Booting.
//!     pub const BOOT: Self = Self(1);
//! }
//!
//! static INFO: wire::EnumInfo = wire::EnumInfo::new("MAV_STATE", &[(1, "MAV_STATE_BOOT")]);
//!
//! wire::open_enum!(MavState, u8, INFO);
//! ```

use super::doc;
use super::method::method;
use super::token::{bits, decimal, float, ident, integer, mask};
use super::ty::int;
use crate::ir::{Limits, Param};
use crate::rust::{Constant, Enum, Int, ParamInfo};
use crate::tokens::{ToTokens, TokenStream, quote};

/// The items of an enum's file.
pub(super) fn enum_(one: &Enum<'_>) -> TokenStream {
    let Enum { ident: name, int: of, flags, constants, methods, .. } = one;
    let (declaration, params, info) = (declaration(one), params(one), info(one));
    let (name, of, kind) = (ident(name), int(*of), ident(if *flags { "flags" } else { "open_enum" }));
    let constants = constants.iter().map(|constant| self::constant(constant, (*flags, one.int)));
    let methods = (!methods.is_empty()).then(|| {
        let methods = methods.iter().map(method);
        quote!(impl #name { #(#methods)* })
    });
    quote! {
        #declaration
        impl #name { #(#constants)* }
        #methods
        #params
        #info
        wire::#kind!(#name, #of, INFO);
    }
}

fn declaration(one: &Enum<'_>) -> TokenStream {
    let Enum { ident: name, alias, docs, deprecated, int: of, flags, .. } = one;
    let (docs, alias, deprecated) =
        (doc::documentation(docs), doc::alias(*alias), doc::deprecated(deprecated.as_ref()));
    let (name, of) = (ident(name), int(*of));
    let inner = if *flags { quote!(#of) } else { quote!(pub #of) };
    quote! {
        #docs
        #alias
        #deprecated
        #[derive(Clone, Copy, PartialEq)]
        pub struct #name(#inner);
    }
}

/// `pub const BOOT: Self = Self(1);` with its documentation.
fn constant(constant: &Constant<'_>, (flags, int): (bool, Int)) -> TokenStream {
    let Constant { ident: name, docs, deprecated, value } = constant;
    let (docs, deprecated) = (doc::documentation(docs), doc::deprecated(deprecated.as_ref()));
    let value = if int.is_signed() { integer(value.cast_signed().into()) } else { number(*value, flags) };
    let name = ident(name);
    quote! {
        #docs
        #deprecated
        pub const #name: Self = Self(#value);
    }
}

/// `4`, `1 << 2`
fn number(value: u64, flags: bool) -> TokenStream {
    match (flags, i64::try_from(value)) {
        (true, _) => bits(value),
        (false, Ok(_)) => decimal(value).to_token_stream(),
        // A negative one of a signed integer, or one that is as long as that.
        (false, Err(_)) => mask(value),
    }
}

fn info(one: &Enum<'_>) -> TokenStream {
    let Enum { name, flags, entries, .. } = one;
    let entries = entries.iter().map(|(value, name)| {
        let value = number(*value, *flags);
        quote!((#value, #name))
    });
    let kind = ident(if *flags { "bitmask" } else { "new" });
    quote!(static INFO: wire::EnumInfo = wire::EnumInfo::#kind(#name, &[#(#entries),*]);)
}

/// `static PARAMS: [(u16, &[wire::ParamInfo]); 1] = [(16, &[wire::ParamInfo::new(1).label("Hold").units("s").min(0.0)])];`
fn params(one: &Enum<'_>) -> Option<TokenStream> {
    let rows = one.params.iter().map(|(value, params)| {
        let (value, params) = (decimal(*value), params.iter().map(param));
        quote!((#value, &[#(#params),*]))
    });
    let (of, count) = (int(one.int), decimal(one.params.len() as u64));
    (!one.params.is_empty()).then(|| quote!(static PARAMS: [(#of, &[wire::ParamInfo]); #count] = [#(#rows),*];))
}

/// `wire::ParamInfo::new(1).label("Hold").units("s").min(0.0)`
fn param(info: &ParamInfo<'_>) -> TokenStream {
    let ParamInfo { param: Param { index, label, units, limits, default, reserved, .. }, carries } = info;
    let Limits { min, max, increment } = *limits;
    let index = decimal(*index);
    let label = label.as_ref().map(|label| quote!(.label(#label)));
    let units = units.as_ref().map(|units| quote!(.units(#units)));
    let values = carries.map(|name| quote!(.values(#name)));
    let number = |name: &str, value: Option<f64>| {
        let (name, value) = (ident(name), float(value?));
        Some(quote!(.#name(#value)))
    };
    let (min, max, increment) = (number("min", min), number("max", max), number("increment", increment));
    let (default, reserved) = (number("default", *default), reserved.then(|| quote!(.reserved())));
    quote!(wire::ParamInfo::new(#index) #label #units #values #min #max #increment #default #reserved)
}
