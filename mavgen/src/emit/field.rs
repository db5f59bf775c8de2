//! A field: its Rust type, its documentation, and how it is read and written.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use crate::docs::prose_with;
use crate::emit::token::{decimal, float, ident, integer, scalar};
use crate::emit::{Context, doc};
use crate::ir::{Enum, Field, FieldType, Invalid, Message, Scalar, Scope, Sentinel, Values};

/// The tokens of one field, by where they go.
pub(crate) struct FieldTokens {
    /// Where it lies in the payload, which is the order of the stores.
    pub(crate) offset: u8,
    /// `pub cog: u16,` with its documentation.
    pub(crate) declaration: TokenStream,
    /// `cog: 0,`
    pub(crate) default: TokenStream,
    /// `cog: get(p, 26),`
    pub(crate) decode: TokenStream,
    /// `put(p, 26, self.cog);`
    pub(crate) encode: TokenStream,
    /// `wire::FieldInfo::new("cog", wire::Kind::U16, 26).units("cdeg"),`
    pub(crate) info: TokenStream,
}

/// Everything that one field contributes to its message.
pub(crate) fn field(context: &Context<'_>, message: &Message, field: &Field) -> FieldTokens {
    let name = ident(&field.name.rust);
    let secret = message.secret().is_some_and(|secret| secret.offset == field.offset);
    let typed = typed_enum(context, field);
    let (ty, zero) = (rust_type(field, typed), zero(field, typed));
    let offset = decimal(field.offset);
    let docs = doc::attributes(&documentation(context, field, secret));
    FieldTokens {
        offset: field.offset,
        declaration: quote!(#docs pub #name: #ty,),
        default: quote!(#name: #zero,),
        decode: quote!(#name: get(p, #offset),),
        encode: quote!(put(p, #offset, self.#name);),
        info: info(context, field, secret),
    }
}

/// The enum that is the Rust type of the field.
pub(crate) fn typed_enum<'a>(context: &Context<'a>, field: &Field) -> Option<&'a Enum> {
    match field.values {
        Some(Values::Typed(id)) => context.dialect.enum_by_id(id),
        _ => None,
    }
}

/// The enum that the field carries as a plain integer.
pub(crate) fn converted_enum<'a>(context: &Context<'a>, field: &Field) -> Option<&'a Enum> {
    match field.values {
        Some(Values::Converted(id)) => context.dialect.enum_by_id(id),
        _ => None,
    }
}

/// The Rust type of one element.
pub(crate) fn element_type(field: &Field, typed: Option<&Enum>) -> Ident {
    typed.map_or_else(|| scalar(field.ty.scalar), |values| ident(&values.name.rust))
}

/// `u16`, `[MavCmd; 5]`, `wire::Chars<16>`.
fn rust_type(field: &Field, typed: Option<&Enum>) -> TokenStream {
    let element = element_type(field, typed);
    match field.ty {
        FieldType { array: None, .. } => quote!(#element),
        FieldType { scalar: Scalar::Char, array: Some(n) } => {
            let n = decimal(n.get());
            quote!(wire::Chars<#n>)
        }
        FieldType { array: Some(n), .. } => {
            let n = decimal(n.get());
            quote!([#element; #n])
        }
    }
}

/// The value in `DEFAULT`: zero, but for the version constant.
fn zero(field: &Field, typed: Option<&Enum>) -> TokenStream {
    let element = match (typed, field.ty.scalar) {
        (Some(values), _) => {
            let name = ident(&values.name.rust);
            if values.bitmask { quote!(#name::empty()) } else { quote!(#name(0)) }
        }
        (None, Scalar::Version(version)) => decimal(version).into_token_stream(),
        (None, Scalar::F32 | Scalar::F64) => quote!(0.0),
        (None, _) => quote!(0),
    };
    match field.ty {
        FieldType { array: None, .. } => element,
        FieldType { scalar: Scalar::Char, array: Some(n) } => {
            let n = decimal(n.get());
            quote!(wire::Chars([0; #n]))
        }
        FieldType { array: Some(n), .. } => {
            let n = decimal(n.get());
            quote!([#element; #n])
        }
    }
}

/// The type in the spelling of the XML: `uint16_t[4]`.
pub(crate) fn xml_type(field: &Field) -> String {
    let scalar = match field.ty.scalar {
        Scalar::Version(_) => "uint8_t_mavlink_version",
        other => other.wire_name(),
    };
    field.ty.array.map_or_else(|| scalar.to_owned(), |n| format!("{scalar}[{n}]"))
}

/// The description; then units, range, enum, sentinel, whether MAVLink 1 has it and whether it is a secret.
fn documentation(context: &Context<'_>, field: &Field, secret: bool) -> Vec<String> {
    let mut facts = doc::quantity(field.units.as_deref(), field.multiplier.as_deref(), &field.limits);
    facts.extend(field.invalid.as_ref().map(|invalid| sentinel_sentence(invalid, field)));
    let mut sentences = Vec::new();
    if !facts.is_empty() {
        sentences.push(doc::capitalised(&format!("{}.", facts.join("; "))));
    }
    if let Some(values) = converted_enum(context, field) {
        sentences.push(format!("A number: [`{}`] gives it as [`{}`].", accessor_link(field), values.name.rust));
    }
    if field.extension {
        sentences.push("Extension: MAVLink 1 does not carry it.".to_owned());
    }
    if field.instance {
        sentences.push("Tells apart the instances that one sender reports.".to_owned());
    }
    if secret {
        sentences.push("Secret: `Debug`, reflection and `defmt` do not show it.".to_owned());
    }
    if field.origin.description.trim().is_empty() && sentences.is_empty() {
        sentences.push(format!("`{}`, a `{}`.", field.name.text, xml_type(field)));
    }
    let words = sentences.iter().flat_map(|sentence| sentence.split(' ')).map(str::to_owned);
    prose_with(&field.origin.description, words.collect())
}

fn accessor_link(field: &Field) -> String {
    format!("Self::{}()", field.name.rust)
}

/// `65535 means not known`.
fn sentinel_sentence(invalid: &Invalid, field: &Field) -> String {
    let value = match invalid.sentinel {
        Sentinel::Integer(value) => value.to_string(),
        Sentinel::Float(value) => value.to_string(),
        Sentinel::NotANumber => "NaN".to_owned(),
    };
    match (invalid.scope, field.ty.array) {
        (Scope::Each, None) => format!("{value} means not known"),
        (Scope::Each, Some(_)) => format!("{value} means that an element is not known"),
        (Scope::Whole, _) => format!("{value} in the first element means that none is known"),
        (Scope::First, _) => format!("{value} means that the first element is not known"),
    }
}

/// `wire::FieldInfo::array("voltages", wire::Kind::U16, 10, 10).units("mV").invalid(…),`
fn info(context: &Context<'_>, field: &Field, secret: bool) -> TokenStream {
    let (name, kind, offset) = (&field.name.text, kind(field.ty.scalar), decimal(field.offset));
    let mut info = match field.ty.array {
        None => quote!(wire::FieldInfo::new(#name, wire::Kind::#kind, #offset)),
        Some(n) => {
            let n = decimal(n.get());
            quote!(wire::FieldInfo::array(#name, wire::Kind::#kind, #n, #offset))
        }
    };
    if field.extension {
        info.extend(quote!(.extension()));
    }
    if let Some(units) = &field.units {
        info.extend(quote!(.units(#units)));
    }
    if let Some(values) = field.values.and_then(|values| context.dialect.enum_by_id(values.id())) {
        let name = ident(&values.name.rust);
        info.extend(quote!(.values(<#name as wire::Enum>::INFO)));
    }
    if let Some(invalid) = &field.invalid {
        let invalid = invalid_info(invalid, field.ty.scalar);
        info.extend(quote!(.invalid(#invalid)));
    }
    if secret {
        info.extend(quote!(.secret()));
    }
    quote!(#info,)
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
