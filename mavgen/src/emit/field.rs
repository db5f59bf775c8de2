//! A field: its declaration, its value in `DEFAULT`, how it is read and written, and what the reflection says of it.

use std::num::NonZeroU8;

use super::token::{float, ident, integer};
use super::ty::{number_in, value_of, zero};
use crate::ir::{self, Invalid, Scalar, Scope, Sentinel};
use crate::rust::{Element, Field, Shape};
use crate::tokens::{TokenStream, quote};

/// `pub cog: u16,` with its documentation.
pub(super) fn declaration(field: &Field<'_>) -> TokenStream {
    let ty = shaped(field.shape, &quote!(#{field.element.ty()}), |n| quote!(wire::Chars<#n>));
    quote!(#{&field.docs} pub #{ident(field.ident)}: #ty,)
}

/// `cog: 0,`
pub(super) fn default(field: &Field<'_>) -> TokenStream {
    let element = match (field.version, field.element) {
        (Some(version), _) => quote!(#version),
        (None, Element::Int(_)) => quote!(0),
        (None, Element::F32 | Element::F64) => quote!(0.0),
        (None, Element::Enum(one)) => zero(one),
    };
    let value = shaped(field.shape, &element, |n| quote!(wire::Chars([0; #n])));
    quote!(#{ident(field.ident)}: #value,)
}

/// One element, or an array of it: as a type, or as a value.
fn shaped(shape: Shape, element: &TokenStream, chars: fn(u8) -> TokenStream) -> TokenStream {
    match shape {
        Shape::One => element.clone(),
        Shape::Array(n) => quote!([#element; #n]),
        Shape::Chars(n) => chars(n),
    }
}

/// `cog: get(p, 26),`, `fix_type: GpsFixType(get(p, 28)),`
pub(super) fn load(field: &Field<'_>) -> TokenStream {
    let value = quote!(get(p, #{field.wire.offset}));
    let value = if is_single_enum(field) { value_of(field.element, &value) } else { value };
    quote!(#{ident(field.ident)}: #value,)
}

/// `put(p, 26, self.cog);`, `put(p, 28, self.fix_type.0);`
pub(super) fn store(field: &Field<'_>) -> TokenStream {
    let value = quote!(self.#{ident(field.ident)});
    let value = if is_single_enum(field) { number_in(field.element, &value) } else { value };
    quote!(put(p, #{field.wire.offset}, #value);)
}

/// Whether it is an enum and no array: its integer is read and written, since functions for each enum take time to compile.
fn is_single_enum(field: &Field<'_>) -> bool {
    field.shape == Shape::One && matches!(field.element, Element::Enum(_))
}

/// `wire::FieldInfo::array("voltages", wire::Kind::U16, 10, 10).units("mV").invalid(…),`
pub(super) fn info(field: &Field<'_>) -> TokenStream {
    let ir::Field { name, ty, offset, extension, units, invalid, .. } = field.wire;
    let (name, kind, length) = (&name.text, kind(ty.scalar), ty.array.map(NonZeroU8::get));
    let new = ident(if length.is_some() { "array" } else { "new" });
    quote! {
        wire::FieldInfo::#new(#name, wire::Kind::#kind, #(if let Some(length) = length => #length,) #offset)
            #(if *extension => .extension())
            #(if let Some(units) = units => .units(#units))
            #(if let Some(carried) = field.carries => .values(<#carried as wire::Enum>::INFO))
            #(if let Some(invalid) = invalid => .invalid(#{invalid_info(invalid, ty.scalar)}))
            #(if field.secret => .secret()),
    }
}

/// The variant of `wire::Kind`.
fn kind(scalar: Scalar) -> TokenStream {
    ident(match scalar {
        Scalar::Char => "Char",
        Scalar::U8 => "U8",
        Scalar::Version(_) => "Version",
        Scalar::I8 => "I8",
        Scalar::U16 => "U16",
        Scalar::I16 => "I16",
        Scalar::U32 => "U32",
        Scalar::I32 => "I32",
        Scalar::U64 => "U64",
        Scalar::I64 => "I64",
        Scalar::F32 => "F32",
        Scalar::F64 => "F64",
    })
}

/// `wire::Invalid::Each(wire::Sentinel::Unsigned(65535))`
fn invalid_info(invalid: &Invalid, scalar: Scalar) -> TokenStream {
    let signed = matches!(scalar, Scalar::I8 | Scalar::I16 | Scalar::I32 | Scalar::I64);
    let sentinel = match invalid.sentinel {
        Sentinel::Integer(value) if signed => quote!(Signed(#{integer(value)})),
        Sentinel::Integer(value) => quote!(Unsigned(#{integer(value)})),
        Sentinel::Float(value) => quote!(Float(#{float(value)})),
        Sentinel::NotANumber => quote!(NotANumber),
    };
    let scope = ident(match invalid.scope {
        Scope::Each => "Each",
        Scope::Whole => "All",
        Scope::First => "First",
    });
    quote!(wire::Invalid::#scope(wire::Sentinel::#sentinel))
}
