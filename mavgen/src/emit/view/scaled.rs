//! Getters and setters of scaled numbers: as a float, exactly in a smaller unit, and raw.
//!
//! ```text
//! /// Supply voltage. In V.
//! pub fn voltage(self) -> f32 { … }
//! pub fn set_voltage(&mut self, value: f32) -> Result<(), wire::ViewError> { … }
//! /// [`Self::voltage`] exactly, in mV.
//! pub const fn voltage_mv(self) -> i32 { … }
//! /// The raw number behind [`Self::voltage`].
//! pub const fn voltage_raw(self) -> u16 { … }
//! pub const fn set_voltage_raw(&mut self, value: u16) -> Result<(), wire::ViewError> { … }
//! ```

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::bits::{present, raw_type};
use super::member::{Docs, documentation, getter_and_setter, raw_range};
use crate::emit::token::ident;
use crate::emit::{Context, doc};
use crate::ir::{Meaning, Member, Scaled, View};

/// Everything that a scaled number contributes to its view; one of several alike takes an index everywhere.
pub(super) fn scaled_number(context: &Context<'_>, view: &View, member: &Member, scaled: &Scaled) -> TokenStream {
    let raw = Raw::of(view, member);
    let float = to_float(scaled, member, &raw.ty, &raw.value);
    let (float_result, float) = raw.map(&quote!(f32), &float);
    let (name, setter) = (ident(&member.name.rust()), format_ident!("set_{}", member.name.rust()));
    let Docs { get, set } = documentation(member);
    let [factor, bias, divisor] = [scaled.factor, scaled.bias, scaled.divisor].map(Literal::i64_unsuffixed);
    // The pattern is one of `i64`, which holds every raw number that a float can name exactly.
    let range = if member.width < 63 { raw_range(member) } else { quote!(0..=i64::MAX) };
    let exact = exact(member, scaled, &raw);
    let raw_accessors = getter_and_setter(context, view, &raw.member, raw.docs());
    let (Raw { ty, index, passed, .. }, raw_setter) = (&raw, format_ident!("set_{}_raw", member.name.rust()));
    quote! {
        #get
        #[inline]
        pub fn #name(self, #index) -> #float_result {
            #float
        }
        #set
        #[inline]
        pub fn #setter(&mut self, #index value: f32) -> Result<(), wire::ViewError> {
            match wire::generated::raw_of(value, #factor, #bias, #divisor) {
                Some(raw @ #range) => self.#raw_setter(#passed raw as #ty),
                _ => Err(wire::ViewError::OutOfRange),
            }
        }
        #exact
        #raw_accessors
    }
}

/// The raw number behind a scaled one.
struct Raw {
    /// The bits as a plain number, `voltage_raw`.
    member: Member,
    /// What it stands for: `voltage`.
    behind: String,
    /// Its getter.
    getter: Ident,
    /// Its type.
    ty: Ident,
    /// An expression for it: what the getter gives, or what is in the `Option` that it gives.
    value: TokenStream,
    /// Whether the getter gives an `Option`.
    optional: bool,
    /// `index: usize,` of the parameters, if there are several.
    index: TokenStream,
    /// `index,` of the arguments.
    passed: TokenStream,
}

impl Raw {
    fn of(view: &View, member: &Member) -> Self {
        let getter = format_ident!("{}_raw", member.name.rust());
        let (index, passed) =
            if member.repeat.is_some() { (quote!(index: usize,), quote!(index,)) } else { (quote!(), quote!()) };
        let optional = member.repeat.is_some() || present(view, member).is_some();
        Self {
            member: Member {
                name: member.name.with("raw"),
                meaning: Meaning::Number { units: None },
                ..member.clone()
            },
            behind: member.name.rust(),
            ty: raw_type(member),
            value: if optional { quote!(raw) } else { quote!(self.#getter()) },
            getter,
            optional,
            index,
            passed,
        }
    }

    fn docs(&self) -> Docs {
        let line = |text: &str| doc::attributes(&[format!("{text} raw number behind [`Self::{}`].", self.behind)]);
        Docs { get: line("The"), set: line("Sets the") }
    }

    /// A type, and an expression of it made of [`Raw::value`], through the `Option` if there is one.
    fn map(&self, ty: &TokenStream, value: &TokenStream) -> (TokenStream, TokenStream) {
        let Self { getter, passed, .. } = self;
        if self.optional {
            (quote!(Option<#ty>), quote!(self.#getter(#passed).map(|raw| #value)))
        } else {
            (ty.clone(), value.clone())
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
fn exact(member: &Member, scaled: &Scaled, raw: &Raw) -> Option<TokenStream> {
    let exact = scaled.exact.as_ref()?;
    let name = format_ident!("{}_{}", member.name.rust(), exact.suffix());
    let largest = i128::from(exact.factor).abs() * (1_i128 << member.width.min(64)) + i128::from(exact.bias).abs();
    let ty = ident(if largest <= i128::from(i32::MAX) { "i32" } else { "i64" });
    let (factor, number) = (Literal::i64_unsuffixed(exact.factor), &raw.value);
    let product = match exact.factor {
        1 => quote!(#number as #ty),
        -1 => quote!(-(#number as #ty)),
        _ => quote!(#number as #ty * #factor),
    };
    let bias = Literal::u64_unsuffixed(exact.bias.unsigned_abs());
    let value = match exact.bias {
        0 => product,
        negative if negative < 0 => quote!(#product - #bias),
        _ => quote!(#product + #bias),
    };
    let docs = doc::attributes(&[format!("[`Self::{}`] exactly, in {}.", member.name.rust(), exact.units)]);
    let Raw { getter, index, passed, optional, .. } = raw;
    // A `match`, because `Option::map` is no `const fn`.
    let (result, body) = if *optional {
        let body = quote!(match self.#getter(#passed) { Some(raw) => Some(#value), None => None });
        (quote!(Option<#ty>), body)
    } else {
        (quote!(#ty), value)
    };
    Some(quote! {
        #docs
        #[inline]
        pub const fn #name(self, #index) -> #result {
            #body
        }
    })
}
