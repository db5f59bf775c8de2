//! Getters and setters beside the plain fields: for sentinels ("not known"), and for enums in fields of another width.
//!
//! ```text
//! /// `temperature`, or `None` where the sender does not know it.
//! #[inline]
//! pub fn temperature(&self) -> Option<i16> {
//!     if self.temperature == 32767 { None } else { Some(self.temperature) }
//! }
//! /// Sets `temperature`; `None` says that it is not known.
//! #[inline]
//! pub fn set_temperature(&mut self, value: Option<i16>) {
//!     self.temperature = value.unwrap_or(32767);
//! }
//! ```
//!
//! All of them are inlined: there are hundreds, of which a program uses a few, and code that is not made costs no build time.
//!
//! Which fields have them is decided where methods are named: [`crate::lower`].

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::field::{converted_enum, element_type, typed_enum};
use crate::emit::token::{decimal, float, ident, integer, repr, scalar};
use crate::emit::{Context, doc};
use crate::ir::{Enum, Field, Invalid, Message, Repr, Scalar, Scope, Sentinel};

/// The `impl` with a message's accessors; nothing if it has none.
pub(crate) fn accessors(context: &Context<'_>, message: &Message) -> TokenStream {
    let decided = context.names_of(message).map(|names| names.accessors.as_slice()).unwrap_or_default();
    let fields = decided.iter().filter_map(|index| message.fields.get(index.0));
    let accessors: Vec<TokenStream> = fields.filter_map(|field| accessor(context, field)).collect();
    if accessors.is_empty() {
        return TokenStream::new();
    }
    let name = ident(&message.name.rust);
    quote!(impl #name { #(#accessors)* })
}

fn accessor(context: &Context<'_>, field: &Field) -> Option<TokenStream> {
    let is_text = field.ty.scalar == Scalar::Char && field.ty.array.is_some();
    let shown = Shown::new(context, field);
    match (&field.invalid, converted_enum(context, field)) {
        (_, Some(values)) => Some(converted(&shown, field, values)),
        (None, None) => None,
        (Some(_), None) if is_text => None,
        (Some(invalid), None) => Some(match (invalid.scope, field.ty.array) {
            (_, None) => optional(&shown, invalid),
            (Scope::Each, Some(_)) => optional_element(&shown, invalid, &quote!()),
            (Scope::First, Some(_)) => optional_element(&shown, invalid, &quote!(index != 0 ||)),
            (Scope::Whole, Some(n)) => optional_array(&shown, invalid, n.get()),
        }),
    }
}

/// The names and the element type that the templates share.
struct Shown {
    field: Ident,
    setter: Ident,
    element: Ident,
    typed: Option<bool>,
}

impl Shown {
    fn new(context: &Context<'_>, field: &Field) -> Self {
        let typed = typed_enum(context, field);
        Self {
            field: ident(&field.name.rust),
            setter: format_ident!("set_{}", field.name.rust),
            element: element_type(field, typed),
            typed: typed.map(|values| values.bitmask),
        }
    }

    /// Whether a value is the sentinel: `v == 65535`, `v.is_nan()`.
    fn is_unknown(&self, invalid: &Invalid, value: &TokenStream) -> TokenStream {
        let sentinel = self.sentinel(invalid);
        match invalid.sentinel {
            Sentinel::NotANumber => quote!(#value.is_nan()),
            Sentinel::Float(_) | Sentinel::Integer(_) => quote!(#value == #sentinel),
        }
    }

    /// `v != 65535`, `!v.is_nan()`
    fn is_known(&self, invalid: &Invalid) -> TokenStream {
        let sentinel = self.sentinel(invalid);
        match invalid.sentinel {
            Sentinel::NotANumber => quote!(!v.is_nan()),
            Sentinel::Float(_) | Sentinel::Integer(_) => quote!(v != #sentinel),
        }
    }

    /// The sentinel as a value of the element type.
    fn sentinel(&self, invalid: &Invalid) -> TokenStream {
        let element = &self.element;
        match (invalid.sentinel, self.typed) {
            (Sentinel::NotANumber, _) => quote!(#element::NAN),
            (Sentinel::Float(value), _) => float(value),
            (Sentinel::Integer(value), None) => integer(value),
            (Sentinel::Integer(value), Some(false)) => {
                let value = integer(value);
                quote!(#element(#value))
            }
            (Sentinel::Integer(value), Some(true)) => {
                let value = integer(value);
                quote!(#element::from_bits_retain(#value))
            }
        }
    }

    /// `self.temperature`
    fn read(&self) -> TokenStream {
        let field = &self.field;
        quote!(self.#field)
    }

    fn docs(&self, get: &str, set: &str) -> (TokenStream, TokenStream) {
        (self.doc(get), self.doc(set))
    }

    /// A line of documentation with the field's name for `#`.
    fn doc(&self, text: &str) -> TokenStream {
        doc::attributes(&[text.replace('#', &format!("`{}`", self.field))])
    }
}

/// A scalar: `Option<u16>`.
fn optional(shown: &Shown, invalid: &Invalid) -> TokenStream {
    let (unknown, sentinel) = (shown.is_unknown(invalid, &shown.read()), shown.sentinel(invalid));
    let (get, set) =
        shown.docs("#, or `None` where the sender does not know it.", "Sets #; `None` says that it is not known.");
    let Shown { field, setter, element, .. } = shown;
    quote! {
        #get
        #[inline]
        pub fn #field(&self) -> Option<#element> {
            if #unknown { None } else { Some(self.#field) }
        }
        #set
        #[inline]
        pub fn #setter(&mut self, value: Option<#element>) {
            self.#field = value.unwrap_or(#sentinel);
        }
    }
}

/// An element of an array, by index.
fn optional_element(shown: &Shown, invalid: &Invalid, always: &TokenStream) -> TokenStream {
    let (known, sentinel) = (shown.is_known(invalid), shown.sentinel(invalid));
    let (get, set) = shown.docs(
        "Element `index` of #, or `None` where the sender does not know it, or there is no such element.",
        "Sets element `index` of #; `None` says that it is not known. An error if there is no such element.",
    );
    let Shown { field, setter, element, .. } = shown;
    quote! {
        #get
        #[inline]
        pub fn #field(&self, index: usize) -> Option<#element> {
            self.#field.get(index).copied().filter(|&v| #always #known)
        }
        #set
        #[inline]
        pub fn #setter(&mut self, index: usize, value: Option<#element>) -> Result<(), wire::OutOfRange> {
            let element = self.#field.get_mut(index).ok_or(wire::OutOfRange)?;
            *element = value.unwrap_or(#sentinel);
            Ok(())
        }
    }
}

/// An array that is known as a whole, or not at all.
fn optional_array(shown: &Shown, invalid: &Invalid, length: u8) -> TokenStream {
    let (sentinel, n) = (shown.sentinel(invalid), decimal(length));
    let value = shown.read();
    let unknown = shown.is_unknown(invalid, &quote!(#value[0]));
    let (get, set) =
        shown.docs("#, or `None` where the sender does not know it.", "Sets #; `None` says that it is not known.");
    let Shown { field, setter, element, .. } = shown;
    quote! {
        #get
        #[inline]
        pub fn #field(&self) -> Option<[#element; #n]> {
            if #unknown { None } else { Some(self.#field) }
        }
        #set
        #[inline]
        pub fn #setter(&mut self, value: Option<[#element; #n]>) {
            self.#field = value.unwrap_or([#sentinel; #n]);
        }
    }
}

/// An enum in a field of another width or sign: scalars without, arrays with an index.
fn converted(shown: &Shown, field: &Field, values: &Enum) -> TokenStream {
    let (getter, setter) = (converted_getter(shown, field, values), converted_setter(shown, field, values));
    quote!(#getter #setter)
}

fn converted_getter(shown: &Shown, field: &Field, values: &Enum) -> TokenStream {
    let (name, target, enum_int) = (&shown.field, ident(&values.name.rust), repr(values.repr));
    let fits = Range::of(field.ty.scalar).is_within(Range::from(values.repr));
    let known = field.invalid.as_ref().map(|invalid| shown.is_known(invalid));
    if fits && known.is_none() && field.ty.array.is_none() {
        let docs = shown.doc("# as its enum.");
        return quote!(#docs #[inline] pub fn #name(&self) -> #target { #target::from(#enum_int::from(self.#name)) });
    }
    let filter = known.map(|known| quote!(.filter(|&v| #known)));
    let number = match field.ty.array {
        None => quote!(Some(self.#name)),
        Some(_) => quote!(self.#name.get(index).copied()),
    };
    let value = match fits {
        true => quote!(map(|v| #target::from(#enum_int::from(v)))),
        false => quote!(and_then(|v| #enum_int::try_from(v).ok()).map(#target::from)),
    };
    let (docs, index) = match field.ty.array {
        None => (shown.doc("# as its enum; `None` where the number cannot be one, or is not known."), quote!()),
        Some(_) => (
            shown.doc("Element `index` of # as its enum; `None` where the number cannot be one, is not known, or is not there."),
            quote!(, index: usize),
        ),
    };
    quote!(#docs #[inline] pub fn #name(&self #index) -> Option<#target> { #number #filter.#value })
}

fn converted_setter(shown: &Shown, field: &Field, values: &Enum) -> TokenStream {
    let (name, setter, target) = (&shown.field, &shown.setter, ident(&values.name.rust));
    let (int, enum_int) = (scalar(field.ty.scalar), repr(values.repr));
    let fits = Range::from(values.repr).is_within(Range::of(field.ty.scalar));
    let number = match fits {
        true => quote!(#int::from(#enum_int::from(value))),
        false => quote!(#int::try_from(#enum_int::from(value)).map_err(|_| wire::OutOfRange)?),
    };
    match (field.ty.array, fits) {
        (None, true) => {
            let docs = shown.doc("Sets # from its enum.");
            quote!(#docs #[inline] pub fn #setter(&mut self, value: #target) { self.#name = #number; })
        }
        (None, false) => {
            let docs = shown.doc("Sets # from its enum. An error if the value does not fit the field.");
            quote! {
                #docs
                #[inline]
                pub fn #setter(&mut self, value: #target) -> Result<(), wire::OutOfRange> {
                    self.#name = #number;
                    Ok(())
                }
            }
        }
        (Some(_), _) => {
            let docs = shown.doc("Sets element `index` of # from its enum. An error if the value does not fit, or there is no such element.");
            quote! {
                #docs
                #[inline]
                pub fn #setter(&mut self, index: usize, value: #target) -> Result<(), wire::OutOfRange> {
                    let element = self.#name.get_mut(index).ok_or(wire::OutOfRange)?;
                    *element = #number;
                    Ok(())
                }
            }
        }
    }
}

/// The numbers that an integer can be.
#[derive(Clone, Copy)]
struct Range {
    size: usize,
    signed: bool,
}

impl Range {
    fn of(field: Scalar) -> Self {
        let signed = matches!(field, Scalar::I8 | Scalar::I16 | Scalar::I32 | Scalar::I64);
        Self { size: field.size(), signed }
    }

    fn is_within(self, other: Self) -> bool {
        match (self.signed, other.signed) {
            (false, false) | (true, true) => self.size <= other.size,
            (false, true) => self.size < other.size,
            (true, false) => false,
        }
    }
}

impl From<Repr> for Range {
    fn from(repr: Repr) -> Self {
        Self { size: repr.size(), signed: repr.is_signed() }
    }
}
