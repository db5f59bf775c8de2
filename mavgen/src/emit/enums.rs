//! An enum or a set of flags: an open newtype, its constants, the table of its names, and the parameters of commands.

use super::doc;
use super::token::{bits, float, ident, integer, mask};
use crate::ir::{Limits, Param};
use crate::rust::{Constant, Enum, ParamInfo};
use crate::tokens::{TokenStream, quote};

/// The items of an enum's file.
pub(super) fn enum_(one: &Enum<'_>) -> TokenStream {
    let Enum { ident: name, alias, docs, deprecated, int, flags, constants, methods, params, .. } = one;
    let (name, kind) = (ident(name), ident(if *flags { "flags" } else { "open_enum" }));
    quote! {
        #docs
        #{doc::alias(*alias)}
        #{doc::deprecated(deprecated.as_ref())}
        #[derive(Clone, Copy, PartialEq)]
        pub struct #name(#(if !flags => pub) #int);
        impl #name { #(for constant in constants => #{self::constant(one, constant)})* }
        #(if !methods.is_empty() => impl #name { #(#methods)* })
        #(if !params.is_empty() =>
            static PARAMS: [(#int, &[wire::ParamInfo]); #{params.len() as u64}] = [
                #(for (value, params) in params => (#value, &[#(for one in params => #{param(one)}),*])),*
            ];)
        #{info(one)}
        wire::#kind!(#name, #int, INFO);
    }
}

/// `pub const BOOT: Self = Self(1);` with its documentation.
fn constant(one: &Enum<'_>, Constant { ident: name, docs, deprecated, value }: &Constant<'_>) -> TokenStream {
    let value = if one.int.is_signed() { integer(value.cast_signed().into()) } else { number(*value, one.flags) };
    quote! {
        #docs
        #{doc::deprecated(deprecated.as_ref())}
        pub const #{ident(name)}: Self = Self(#value);
    }
}

/// `4`, `1 << 2`
fn number(value: u64, flags: bool) -> TokenStream {
    match (flags, i64::try_from(value)) {
        (true, _) => bits(value),
        (false, Ok(_)) => quote!(#value),
        // A negative one of a signed integer, or one that is as long as that.
        (false, Err(_)) => mask(value.into()),
    }
}

fn info(one: &Enum<'_>) -> TokenStream {
    let Enum { name, flags, entries, .. } = one;
    let kind = ident(if *flags { "bitmask" } else { "new" });
    quote! {
        static INFO: wire::EnumInfo = wire::EnumInfo::#kind(#name, &[
            #(for (value, name) in entries => (#{number(*value, *flags)}, #name)),*
        ]);
    }
}

/// `wire::ParamInfo::new(1).label("Hold").units("s").min(0.0)`
fn param(info: &ParamInfo<'_>) -> TokenStream {
    let ParamInfo { param: Param { index, label, units, limits, default, reserved, .. }, carries } = info;
    let Limits { min, max, increment } = *limits;
    let numbers = [("min", min), ("max", max), ("increment", increment), ("default", *default)];
    quote! {
        wire::ParamInfo::new(#index)
            #(if let Some(label) = label => .label(#label))
            #(if let Some(units) = units => .units(#units))
            #(if let Some(name) = carries => .values(#name))
            #(for (name, value) in numbers => #(if let Some(value) = value => .#{ident(name)}(#{float(value)})))*
            #(if *reserved => .reserved())
    }
}
