//! Getters and setters of named bits.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::bits::{At, Present, mask_of, present, raw_type, read, write};
use crate::docs::prose_with;
use crate::emit::token::{ident, repr};
use crate::emit::{Context, doc};
use crate::ir::{Meaning, Member, Repeat, Scaled, View};

/// Everything that one member contributes to its view.
pub(super) fn member(context: &Context<'_>, view: &View, member: &Member) -> TokenStream {
    if let Some(repeat) = member.repeat {
        return repeated(context, view, member, repeat);
    }
    match &member.meaning {
        Meaning::Scaled(scaled) => scaled_number(view, member, scaled),
        _ => plain(context, view, member),
    }
}

/// How raw numbers become values of the member's type, and back.
struct Shape {
    /// `Esc32State`, `bool`, `u16`
    ty: Ident,
    /// From the raw expression to the value.
    value: fn(&Ident, &TokenStream) -> TokenStream,
    /// From `value` to the raw number.
    raw: TokenStream,
    /// The type of `raw`.
    raw_type: Ident,
    /// The type that the raw expression has to be read as.
    read_as: Ident,
}

fn shape(context: &Context<'_>, member: &Member) -> Shape {
    let raw_type = raw_type(member);
    match member.meaning {
        Meaning::Flag => number(ident("bool")),
        Meaning::Values(id) => match context.dialect.enum_by_id(id) {
            Some(values) => Shape {
                ty: ident(&values.name.rust),
                value: if values.bitmask {
                    |ty, raw| quote!(#ty::from_bits_retain(#raw))
                } else {
                    |ty, raw| quote!(#ty(#raw))
                },
                raw: if values.bitmask { quote!(value.bits()) } else { quote!(value.0) },
                raw_type: repr(values.repr),
                read_as: repr(values.repr),
            },
            None => number(raw_type),
        },
        Meaning::Number { .. } | Meaning::Scaled(_) => number(raw_type),
    }
}

fn number(raw_type: Ident) -> Shape {
    Shape {
        ty: raw_type.clone(),
        value: |_, raw| raw.clone(),
        raw: quote!(value),
        raw_type: raw_type.clone(),
        read_as: raw_type,
    }
}

/// The raw number, in the type that the value is made of.
fn raw_as(view: &View, member: &Member, at: &At, wanted: &Ident) -> TokenStream {
    let own = raw_type(member);
    let raw = read(view, at, member.width, &own, member.signed);
    if own == *wanted { raw } else { quote!((#raw) as #wanted) }
}

/// The value: `MavState((self.bits & 7) as u8)`, `self.bits & (1 << 4) != 0`.
fn value(view: &View, member: &Member, at: &At, shape: &Shape) -> TokenStream {
    if matches!(member.meaning, Meaning::Flag) {
        let bit = at.left(&quote!(1));
        return quote!(self.bits & #bit != 0);
    }
    (shape.value)(&shape.ty, &raw_as(view, member, at, &shape.read_as))
}

/// A flag, an enum or a number: getter and setter.
fn plain(context: &Context<'_>, view: &View, member: &Member) -> TokenStream {
    let shape = shape(context, member);
    let (name, setter, ty) = (ident(&member.name), format_ident!("set_{}", member.name), &shape.ty);
    let value = value(view, member, &At::Bit(member.at), &shape);
    let store = store(view, member, &At::Bit(member.at), &shape);
    let (docs, set_docs) = documentation(member);
    let (result, body) = optional(present(view, member).as_ref(), &quote!(#ty), &value);
    let guard = guard(view, member);
    quote! {
        #docs
        #[inline]
        pub const fn #name(self) -> #result {
            #body
        }
        #set_docs
        #[inline]
        pub const fn #setter(&mut self, value: #ty) -> Result<(), wire::ViewError> {
            #guard
            #store
        }
    }
}

/// `T` as it is, or `Option<T>` where only some layouts have it.
fn optional(present: Option<&Present>, ty: &TokenStream, value: &TokenStream) -> (TokenStream, TokenStream) {
    match present {
        None => (quote!(#ty), value.clone()),
        Some(Present { value: switch, patterns }) => {
            let body = quote! {
                match #switch {
                    #patterns => Some(#value),
                    _ => None,
                }
            };
            (quote!(Option<#ty>), body)
        }
    }
}

/// What a setter does first where only some layouts have the bits.
fn guard(view: &View, member: &Member) -> Option<TokenStream> {
    let Present { value, patterns } = present(view, member)?;
    Some(quote! {
        match #value {
            #patterns => {}
            _ => return Err(wire::ViewError::Absent),
        }
    })
}

/// Puts `value` into the bits if it fits.
fn store(view: &View, member: &Member, at: &At, shape: &Shape) -> TokenStream {
    if matches!(member.meaning, Meaning::Flag) {
        let bit = at.left(&quote!(1));
        return quote! {
            self.bits = if value { self.bits | #bit } else { self.bits & !#bit };
            Ok(())
        };
    }
    let (raw, bits) = (&shape.raw, write(view, at, member.width, &quote!(raw), &shape.raw_type));
    match accepted(member, &shape.raw_type) {
        None => {
            let bits = write(view, at, member.width, raw, &shape.raw_type);
            quote! {
                self.bits = #bits;
                Ok(())
            }
        }
        Some(range) => quote! {
            match #raw {
                raw @ #range => {
                    self.bits = #bits;
                    Ok(())
                }
                _ => Err(wire::ViewError::OutOfRange),
            }
        },
    }
}

/// The pattern of raw numbers that fit; `None` where every number of the type does.
fn accepted(member: &Member, raw_type: &Ident) -> Option<TokenStream> {
    let all = raw_type.to_string().get(1..).and_then(|width| width.parse().ok()) == Some(member.width);
    if all { None } else { Some(raw_range(member)) }
}

/// `0..=0xfff`, `-256..=255`
fn raw_range(member: &Member) -> TokenStream {
    if !member.signed {
        let mask = mask_of(member.width);
        return quote!(0..=#mask);
    }
    let end = 1_i128.checked_shl(u32::from(member.width) - 1).unwrap_or_default();
    let (start, last) = (Literal::i128_unsuffixed(end), Literal::i128_unsuffixed(end - 1));
    quote!(-#start..=#last)
}

/// Several alike: an index, and `None` beyond the last.
fn repeated(context: &Context<'_>, view: &View, member: &Member, repeat: Repeat) -> TokenStream {
    let shape = shape(context, member);
    let (name, setter, ty) = (ident(&member.name), format_ident!("set_{}", member.name), &shape.ty);
    let count = Literal::u8_unsuffixed(repeat.count);
    let at = At::Computed(position(member.at, repeat.stride));
    let value = value(view, member, &at, &shape);
    let store = store(view, member, &at, &shape);
    let (docs, set_docs) = documentation(member);
    let (there, guard) = (present(view, member), guard(view, member));
    let (_, there_value) = optional(there.as_ref(), &quote!(#ty), &value);
    let body = match there {
        None => quote!(if index < #count { Some(#there_value) } else { None }),
        Some(_) => quote!(if index < #count { #there_value } else { None }),
    };
    quote! {
        #docs
        ///
        /// `None` where there is no such one.
        #[inline]
        pub const fn #name(self, index: usize) -> Option<#ty> {
            #body
        }
        #set_docs
        #[inline]
        pub const fn #setter(&mut self, index: usize, value: #ty) -> Result<(), wire::ViewError> {
            #guard
            if index >= #count {
                return Err(wire::ViewError::OutOfRange);
            }
            #store
        }
    }
}

/// `3 + index * 2`
fn position(at: u8, stride: u8) -> TokenStream {
    let (start, step) = (Literal::u8_unsuffixed(at), Literal::u8_unsuffixed(stride));
    match (at, stride) {
        (0, 1) => quote!(index),
        (0, _) => quote!(index * #step),
        (_, 1) => quote!(#start + index),
        _ => quote!(#start + index * #step),
    }
}

/// A scaled number: raw, as a float, and exactly in a smaller unit.
fn scaled_number(view: &View, member: &Member, scaled: &Scaled) -> TokenStream {
    let raw_member = Member { name: format!("{}_raw", member.name), ..member.clone() };
    let shape = number(raw_type(member));
    let (name, setter) = (ident(&member.name), format_ident!("set_{}", member.name));
    let (raw_name, raw_setter) = (ident(&raw_member.name), format_ident!("set_{}", raw_member.name));
    let (raw_type, raw) = (&shape.ty, raw_as(view, member, &At::Bit(member.at), &shape.read_as));
    let (raw_result, raw_body) = optional(present(view, member).as_ref(), &quote!(#raw_type), &raw);
    let (raw_store, guard) = (store(view, member, &At::Bit(member.at), &shape), guard(view, member));
    let there = present(view, member).is_some();
    let raw_value = if there { quote!(raw) } else { quote!(self.#raw_name()) };
    let float = to_float(scaled, member, raw_type, &raw_value);
    let (value_result, value) =
        if there { (quote!(Option<f32>), quote!(self.#raw_name().map(|raw| #float))) } else { (quote!(f32), float) };
    let (docs, set_docs) = documentation(member);
    let [factor, bias, divisor] = [scaled.factor, scaled.bias, scaled.divisor].map(Literal::i64_unsuffixed);
    // The pattern is one of `i64`, which holds every raw number that a float can name exactly.
    let range = if member.width < 63 { raw_range(member) } else { quote!(0..=i64::MAX) };
    let raw_docs = doc::attributes(&[format!("The raw number behind [`Self::{name}`].")]);
    let raw_set_docs = doc::attributes(&[format!("Sets the raw number behind [`Self::{name}`].")]);
    let exact = exact(member, scaled, &raw_name, there);
    quote! {
        #docs
        #[inline]
        pub fn #name(self) -> #value_result {
            #value
        }
        #set_docs
        #[inline]
        pub fn #setter(&mut self, value: f32) -> Result<(), wire::ViewError> {
            match wire::raw_of(value, #factor, #bias, #divisor) {
                Some(raw @ #range) => self.#raw_setter(raw as #raw_type),
                _ => Err(wire::ViewError::OutOfRange),
            }
        }
        #exact
        #raw_docs
        #[inline]
        pub const fn #raw_name(self) -> #raw_result {
            #raw_body
        }
        #raw_set_docs
        #[inline]
        pub const fn #raw_setter(&mut self, value: #raw_type) -> Result<(), wire::ViewError> {
            #guard
            #raw_store
        }
    }
}

/// `(f32::from(raw) - 128.0) / 4.0`: one division of exact numbers, so that the result is the nearest float.
fn to_float(scaled: &Scaled, member: &Member, raw_type: &Ident, raw: &TokenStream) -> TokenStream {
    let largest = i128::from(scaled.factor).abs() * (1_i128 << member.width.min(100)) + i128::from(scaled.bias).abs();
    let exact_in_f32 = largest < 1 << 24 && scaled.divisor < 1 << 24;
    let float = ident(if exact_in_f32 { "f32" } else { "f64" });
    let lossless = matches!(raw_type.to_string().as_str(), "u8" | "i8" | "u16" | "i16");
    let mut value = if lossless { quote!(#float::from(#raw)) } else { quote!((#raw as #float)) };
    if scaled.factor == -1 {
        value = quote!(-#value);
    } else if scaled.factor != 1 {
        let factor = Literal::f64_unsuffixed(scaled.factor as f64);
        value = quote!(#value * #factor);
    }
    if scaled.bias != 0 {
        let bias = Literal::f64_unsuffixed(scaled.bias.unsigned_abs() as f64);
        value = if scaled.bias < 0 { quote!((#value - #bias)) } else { quote!((#value + #bias)) };
    }
    if scaled.divisor != 1 {
        let divisor = Literal::f64_unsuffixed(scaled.divisor as f64);
        value = quote!(#value / #divisor);
    }
    if exact_in_f32 { value } else { quote!((#value) as f32) }
}

/// `pub const fn voltage_mv(self) -> i32`
fn exact(member: &Member, scaled: &Scaled, raw_name: &Ident, optional: bool) -> Option<TokenStream> {
    let exact = scaled.exact.as_ref()?;
    let name = format_ident!("{}_{}", member.name, exact.suffix);
    let largest = i128::from(exact.factor).abs() * (1_i128 << member.width.min(64)) + i128::from(exact.bias).abs();
    let ty = ident(if largest <= i128::from(i32::MAX) { "i32" } else { "i64" });
    let factor = Literal::i64_unsuffixed(exact.factor);
    let raw = if optional { quote!(raw) } else { quote!(self.#raw_name()) };
    let product = match exact.factor {
        1 => quote!(#raw as #ty),
        -1 => quote!(-(#raw as #ty)),
        _ => quote!(#raw as #ty * #factor),
    };
    let bias = Literal::u64_unsuffixed(exact.bias.unsigned_abs());
    let value = match exact.bias {
        0 => product,
        bias_value if bias_value < 0 => quote!(#product - #bias),
        _ => quote!(#product + #bias),
    };
    let docs = doc::attributes(&[format!("[`Self::{}`] exactly, in {}.", member.name, exact.units)]);
    let (result, body) = if optional {
        let body = quote! {
            match self.#raw_name() {
                Some(raw) => Some(#value),
                None => None,
            }
        };
        (quote!(Option<#ty>), body)
    } else {
        (quote!(#ty), value)
    };
    Some(quote! {
        #docs
        #[inline]
        pub const fn #name(self) -> #result {
            #body
        }
    })
}

/// What the overlay says of the bits, and the unit; and the line of the setter.
fn documentation(member: &Member) -> (TokenStream, TokenStream) {
    let units = match &member.meaning {
        Meaning::Number { units } => units.as_deref(),
        Meaning::Scaled(scaled) => scaled.units.as_deref(),
        Meaning::Flag | Meaning::Values(_) => None,
    };
    let mut sentences: Vec<String> = Vec::new();
    if member.description.trim().is_empty() {
        sentences.push(format!("`{}`.", member.name));
    }
    sentences.extend(units.map(|units| format!("In {units}.")));
    let words = sentences.iter().flat_map(|sentence| sentence.split(' ')).map(str::to_owned).collect();
    let get = doc::attributes(&prose_with(&member.description, words));
    let set = doc::attributes(&[format!("Sets [`Self::{}`]. An error if the value does not fit.", member.name)]);
    (get, set)
}
