//! How a message gives what overlays add to it: a view over plain fields, and enums bound to fields.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::{storage, summary};
use crate::docs::prose_with;
use crate::emit::field::typed_enum;
use crate::emit::token::{ident, integer, scalar};
use crate::emit::{Context, doc};
use crate::ir::{
    Access, Binding, Blank, Condition, EnumId, Field, FieldIndex, Message, Place, Switch, SwitchOn, Values, View, Word,
};

/// The fields that a view is read from, as the XML spells them.
pub(super) fn word_names<'m>(message: &'m Message, view: &View) -> Vec<&'m str> {
    let fields = view.words.iter().filter_map(|word| field(message, word_field(*word)));
    fields.map(|field| field.name.text.as_str()).collect()
}

fn word_field(word: Word) -> FieldIndex {
    match word {
        Word::One(place) => place.field,
        Word::Joined(field) => field,
    }
}

/// The field behind an index of this message.
pub(super) fn field(message: &Message, index: FieldIndex) -> Option<&Field> {
    message.fields.get(index.0)
}

/// The enums that are Rust types of fields which the view's file names.
pub(super) fn named_enums(message: &Message, view: &View) -> Vec<EnumId> {
    let mut fields: Vec<FieldIndex> = view.words.iter().map(|word| word_field(*word)).collect();
    fields.extend(view.condition.iter().map(|condition| condition.field));
    if let Access::Slots(slots) = &view.access {
        fields.extend(slots.keys.iter().map(|key| key.place.field));
    }
    let typed = |field: &Field| match field.values {
        Some(Values::Typed(id)) => Some(id),
        _ => None,
    };
    fields.into_iter().filter_map(|index| typed(field(message, index)?)).collect()
}

/// `self.autopilot == MavAutopilot::AUTOQUAD`
pub(super) fn holds(context: &Context<'_>, message: &Message, condition: &Condition) -> TokenStream {
    let Some(field) = field(message, condition.field) else { return quote!(true) };
    let (name, number) = (ident(&field.name.rust), Literal::u64_unsuffixed(condition.value));
    let Some(values) = typed_enum(context, field) else { return quote!(self.#name == #number) };
    let ty = ident(&values.name.rust);
    let entry = values.entries.iter().find(|entry| entry.value == condition.value);
    let entry = entry.filter(|entry| !context.is_deprecated(&entry.origin));
    match entry {
        Some(entry) => {
            let constant = ident(&entry.name.rust);
            quote!(self.#name == #ty::#constant)
        }
        None => quote!(self.#name == #ty::from(#number)),
    }
}

/// A word as an integer of the view's storage: `u64::from(self.data0)`.
pub(super) fn word_as(context: &Context<'_>, field: &Field, word: &TokenStream, storage: &Ident) -> TokenStream {
    let own = scalar(field.ty.scalar);
    let number = if typed_enum(context, field).is_some() { quote!(#own::from(#word)) } else { word.clone() };
    if own == *storage { number } else { quote!(#storage::from(#number)) }
}

/// An integer of the view's storage as a word again.
pub(super) fn word_of(context: &Context<'_>, field: &Field, bits: &TokenStream, storage: &Ident) -> TokenStream {
    let own = scalar(field.ty.scalar);
    let number = if own == *storage { bits.clone() } else { quote!(#bits as #own) };
    match typed_enum(context, field) {
        Some(values) => {
            let ty = ident(&values.name.rust);
            quote!(#ty::from(#number))
        }
        None => number,
    }
}

/// Bits of one element of a field.
pub(super) fn element_bits(field: &Field) -> u8 {
    u8::try_from(8 * field.ty.scalar.size()).unwrap_or(u8::MAX)
}

/// A view over plain fields: `flight_sw()` and `set_flight_sw()`.
pub(super) fn once(context: &Context<'_>, message: &Message, view: &View, getter: &str) -> TokenStream {
    let (name, setter) = (ident(getter), format_ident!("set_{getter}"));
    let (message_name, ty, storage) = (ident(&message.name.rust), ident(&view.name.rust), storage(view));
    let parts = once_parts(message, view);
    let joined = parts.iter().map(|part| {
        let value = word_as(context, part.field, &part.place, &storage);
        shifted(&value, part.at)
    });
    let stores = parts.iter().map(|part| {
        let (place, at) = (&part.place, Literal::u8_unsuffixed(part.at));
        let bits = if part.at == 0 { quote!(bits) } else { quote!((bits >> #at)) };
        let word = word_of(context, part.field, &bits, &storage);
        quote!(#place = #word;)
    });
    let switch = view.switch.as_ref().and_then(|switch| switch_names(message, switch));
    let (argument, store_switch) = match &switch {
        Some((field, own)) => (quote!(, self.#field), quote!(self.#field = value.#own();)),
        None => (quote!(), quote!()),
    };
    let mut means: Vec<TokenStream> = view.condition.iter().map(|one| holds(context, message, one)).collect();
    means.extend(view.invalid.iter().filter_map(|blank| is_not(message, blank, &quote!(bits))));
    let view_of = quote!(#ty::from_bits(bits #argument));
    let (result, value) = match means.split_first() {
        None => (quote!(#ty), view_of),
        Some((first, rest)) => (quote!(Option<#ty>), quote!(if #first #(&& #rest)* { Some(#view_of) } else { None })),
    };
    let docs = summary(view);
    quote! {
        impl #message_name {
            #docs
            #[inline]
            pub fn #name(&self) -> #result {
                let bits = #(#joined)|*;
                #value
            }
            /// Sets the bits.
            #[inline]
            pub fn #setter(&mut self, value: #ty) {
                let bits = value.bits();
                #(#stores)*
                #store_switch
            }
        }
    }
}

/// A word, where it is in the message and where it begins in the view.
struct Part<'m> {
    field: &'m Field,
    place: TokenStream,
    at: u8,
}

fn once_parts<'m>(message: &'m Message, view: &View) -> Vec<Part<'m>> {
    let mut parts = Vec::new();
    let mut at = 0;
    for word in &view.words {
        let Some(field) = field(message, word_field(*word)) else { continue };
        let name = ident(&field.name.rust);
        let count = match word {
            Word::One(_) => 1,
            Word::Joined(_) => field.ty.array.map_or(1, std::num::NonZeroU8::get),
        };
        for index in 0..count {
            let place = match word {
                Word::One(_) => quote!(self.#name),
                Word::Joined(_) => {
                    let index = Literal::u8_unsuffixed(index);
                    quote!(self.#name[#index])
                }
            };
            parts.push(Part { field, place, at });
            at += element_bits(field);
        }
    }
    parts
}

/// `(value << 32)`
pub(super) fn shifted(value: &TokenStream, at: u8) -> TokenStream {
    let at_bits = Literal::u8_unsuffixed(at);
    if at == 0 { quote!(#value) } else { quote!((#value << #at_bits)) }
}

/// The field that selects the layout, and the view's getter of it.
fn switch_names(message: &Message, switch: &Switch) -> Option<(Ident, Ident)> {
    let SwitchOn::Field(place, _) = switch.on else { return None };
    let field = field(message, place.field)?;
    Some((ident(&field.name.rust), ident(&switch.name.rust())))
}

/// `self.status_age != 65535`, `bits != 0`
fn is_not(message: &Message, blank: &Blank, bits: &TokenStream) -> Option<TokenStream> {
    Some(match blank {
        Blank::Words(value) => {
            let value = Literal::u128_unsuffixed(*value);
            quote!(#bits != #value)
        }
        Blank::Field(Place { field: index, .. }, value) => {
            let (name, value) = (ident(&field(message, *index)?.name.rust), integer(*value));
            quote!(self.#name != #value)
        }
    })
}

/// The `impl` with the enums that overlays bind to fields of a message; nothing if there are none.
pub(crate) fn bindings(context: &Context<'_>, message: &Message) -> TokenStream {
    if message.bindings.is_empty() {
        return TokenStream::new();
    }
    let bindings = message.bindings.iter().filter_map(|binding| bound(context, message, binding));
    let name = ident(&message.name.rust);
    quote!(impl #name { #(#bindings)* })
}

fn bound(context: &Context<'_>, message: &Message, binding: &Binding) -> Option<TokenStream> {
    let (field, values) = (field(message, binding.field)?, context.dialect.enum_by_id(binding.values)?);
    let (name, setter) = (ident(&binding.name.rust()), format_ident!("set_{}", binding.name.rust()));
    let (field_name, ty) = (ident(&field.name.rust), ident(&values.name.rust));
    let value = quote!(#ty::from(self.#field_name));
    let (result, body) = match &binding.condition {
        None => (quote!(#ty), value),
        Some(condition) => {
            let holds = holds(context, message, condition);
            (quote!(Option<#ty>), quote!(if #holds { Some(#value) } else { None }))
        }
    };
    let link = format!("[`Self::{0}`](field@Self::{0})", field.name.rust);
    let get = vec![format!("{link} as [`{}`].", values.name.rust)];
    let docs = doc::attributes(&doc::join([prose_with(&binding.description, Vec::new()), get]));
    let set_docs = doc::attributes(&[format!("Sets {link} from [`{}`].", values.name.rust)]);
    Some(quote! {
        #docs
        #[inline]
        pub fn #name(&self) -> #result {
            #body
        }
        #set_docs
        #[inline]
        pub fn #setter(&mut self, value: #ty) {
            self.#field_name = value.into();
        }
    })
}
