//! A field: its declaration, its value in `DEFAULT`, how it is read and written, and what the reflection says of it.

use super::doc;
use super::token::{decimal, float, ident, integer};
use super::ty::{number_in, ty, value_of};
use crate::ir::{self, Invalid, Scalar, Scope, Sentinel};
use crate::rust::{Element, Field, Shape};
use crate::tokens::{Ident, Literal, ToTokens, TokenStream, quote};

/// `pub cog: u16,` with its documentation.
pub(super) fn declaration(field: &Field<'_>) -> TokenStream {
    let (docs, name, element) = (doc::documentation(&field.docs), ident(field.ident), ty(&field.element.ty()));
    let ty = shaped(field.shape, &element, |n| quote!(wire::Chars<#n>));
    quote!(#docs pub #name: #ty,)
}

/// `cog: 0,`
pub(super) fn default(field: &Field<'_>) -> TokenStream {
    let name = ident(field.ident);
    let element = match (field.version, field.element) {
        (Some(version), _) => Literal::of(version).to_token_stream(),
        (None, Element::Int(_)) => quote!(0),
        (None, Element::F32 | Element::F64) => quote!(0.0),
        (None, Element::Enum(one)) => {
            let ty = ident(one.ident);
            if one.flags { quote!(#ty::empty()) } else { quote!(#ty(0)) }
        }
    };
    let value = shaped(field.shape, &element, |n| quote!(wire::Chars([0; #n])));
    quote!(#name: #value,)
}

/// One element, or an array of it: as a type, or as a value.
fn shaped(shape: Shape, element: &TokenStream, chars: impl Fn(Literal) -> TokenStream) -> TokenStream {
    match shape {
        Shape::One => element.clone(),
        Shape::Array(n) => {
            let n = Literal::of(n);
            quote!([#element; #n])
        }
        Shape::Chars(n) => chars(Literal::of(n)),
    }
}

/// `cog: get(p, 26),`, `fix_type: GpsFixType(get(p, 28)),`
pub(super) fn load(field: &Field<'_>) -> TokenStream {
    let (name, offset) = (ident(field.ident), decimal(field.wire.offset));
    let value = quote!(get(p, #offset));
    let value = if is_single_enum(field) { value_of(field.element, &value) } else { value };
    quote!(#name: #value,)
}

/// `put(p, 26, self.cog);`, `put(p, 28, self.fix_type.0);`
pub(super) fn store(field: &Field<'_>) -> TokenStream {
    let (name, offset) = (ident(field.ident), decimal(field.wire.offset));
    let value = quote!(self.#name);
    let value = if is_single_enum(field) { number_in(field.element, &value) } else { value };
    quote!(put(p, #offset, #value);)
}

/// Whether it is an enum and no array: its integer is read and written, since functions for each enum take time to compile.
fn is_single_enum(field: &Field<'_>) -> bool {
    field.shape == Shape::One && matches!(field.element, Element::Enum(_))
}

/// `wire::FieldInfo::array("voltages", wire::Kind::U16, 10, 10).units("mV").invalid(…),`
pub(super) fn info(field: &Field<'_>) -> TokenStream {
    let ir::Field { name, ty, offset, extension, units, invalid, .. } = field.wire;
    let (name, kind, offset) = (&name.text, kind(ty.scalar), decimal(*offset));
    let new = match ty.array {
        None => quote!(new(#name, wire::Kind::#kind, #offset)),
        Some(n) => {
            let n = decimal(n.get());
            quote!(array(#name, wire::Kind::#kind, #n, #offset))
        }
    };
    let extension = extension.then(|| quote!(.extension()));
    let units = units.as_ref().map(|units| quote!(.units(#units)));
    let values = field.carries.map(|carried| {
        let carried = ident(carried.ident);
        quote!(.values(<#carried as wire::Enum>::INFO))
    });
    let invalid = invalid.as_ref().map(|invalid| {
        let invalid = invalid_info(invalid, ty.scalar);
        quote!(.invalid(#invalid))
    });
    let secret = field.secret.then(|| quote!(.secret()));
    quote!(wire::FieldInfo::#new #extension #units #values #invalid #secret,)
}

/// The variant of `wire::Kind`.
fn kind(scalar: Scalar) -> Ident {
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
        Sentinel::Integer(value) => {
            let value = integer(value);
            if signed { quote!(Signed(#value)) } else { quote!(Unsigned(#value)) }
        }
        Sentinel::Float(value) => {
            let value = float(value);
            quote!(Float(#value))
        }
        Sentinel::NotANumber => quote!(NotANumber),
    };
    let scope = ident(match invalid.scope {
        Scope::Each => "Each",
        Scope::Whole => "All",
        Scope::First => "First",
    });
    quote!(wire::Invalid::#scope(wire::Sentinel::#sentinel))
}
