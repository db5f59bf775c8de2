//! A view of each slot of arrays that lie side by side: the slot's type, an iterator, and setters for simulators.
//!
//! ```text
//! pub struct Esc { pub id: u8, pub age_ms: Option<u16>, pub status: Option<EscStatus> }
//!
//! impl AqEscTelemetry {
//!     pub fn escs(&self) -> impl Iterator<Item = Esc> + '_ { … }
//!     pub fn esc(&self, index: usize) -> Option<Esc> { … }
//!     pub fn set_esc(&mut self, index: usize, esc: Esc) -> Result<(), wire::ViewError> { … }
//!     pub fn push_esc(&mut self, esc: Esc) -> Result<(), wire::ViewError> { … }
//! }
//! ```

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::access::{element_bits, field, holds, shifted, word_as, word_of};
use super::{storage, summary};
use crate::docs::prose_with;
use crate::emit::field::{element_type, typed_enum};
use crate::emit::token::{ident, integer};
use crate::emit::{Context, doc};
use crate::ir::{Blank, Field, FieldIndex, Key, Message, Place, Slots, SwitchOn, View, Word};
use crate::names::field_name;

pub(super) fn slots(context: &Context<'_>, message: &Message, view: &View, slots: &Slots) -> TokenStream {
    let site = Site { context, message, view, slots };
    let (item, methods) = (site.item(), site.methods());
    quote!(#item #methods)
}

/// What the templates of one view's slots share.
struct Site<'a> {
    context: &'a Context<'a>,
    message: &'a Message,
    view: &'a View,
    slots: &'a Slots,
}

/// A word that slots have an element of, and where it begins in the view.
struct WordPart<'a> {
    place: Place,
    field: &'a Field,
    at: u8,
}

impl<'a> Site<'a> {
    /// `pub struct Esc { … }`
    fn item(&self) -> TokenStream {
        let (name, view, items) = (ident(&self.slots.item.rust), ident(&self.view.name.rust), &self.slots.items);
        let keys = self.slots.keys.iter().filter_map(|key| {
            let (name, ty) = (ident(&key.name.rust()), self.key_type(key)?);
            let docs = doc::attributes(&key_documentation(key));
            Some(quote!(#docs pub #name: #ty,))
        });
        let docs = doc::attributes(&[format!("One slot of [`{}::{items}`].", self.message.name.rust)]);
        quote! {
            #docs
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct #name {
                #(#keys)*
                /// What the bits say; `None` where they say nothing.
                pub status: Option<#view>,
            }
        }
    }

    fn key_type(&self, key: &Key) -> Option<TokenStream> {
        let field = field(self.message, key.place.field)?;
        let element = element_type(field, typed_enum(self.context, field));
        Some(if key.invalid.is_some() { quote!(Option<#element>) } else { quote!(#element) })
    }

    fn methods(&self) -> TokenStream {
        let (message, item) = (ident(&self.message.name.rust), ident(&self.slots.item.rust));
        let one = field_name(&self.slots.item.text);
        let (getter, items) = (ident(&one), ident(&self.slots.items.rust()));
        let length = Literal::u8_unsuffixed(self.slots.length.get());
        let (read, write) = (self.read(&getter), self.write(&one));
        let docs = summary(self.view);
        quote! {
            impl #message {
                #docs
                ///
                /// Every slot that is in use, also those whose bits say nothing.
                #[inline]
                pub fn #items(&self) -> impl Iterator<Item = #item> + '_ {
                    (0..#length).map_while(|index| self.#getter(index))
                }
                #read
                #write
            }
        }
    }

    /// `pub fn esc(&self, index: usize) -> Option<Esc>`
    fn read(&self, getter: &Ident) -> TokenStream {
        let (item, view) = (ident(&self.slots.item.rust), ident(&self.view.name.rust));
        let in_use = self.slots.count.and_then(|count| field(self.message, count)).map(|count| {
            let name = ident(&count.name.rust);
            let used = as_index(count, &quote!(self.#name));
            quote!(if index >= #used { return None; })
        });
        let locals = self.elements().into_iter().map(|(field, local)| {
            let name = ident(&field.name.rust);
            quote!(let #local = *self.#name.get(index)?;)
        });
        let bits = self.joined();
        let keys = self.slots.keys.iter().filter_map(|key| self.key_value(key));
        let switch = self.switch().map(|(place, _)| self.value(place)).map(|value| quote!(, #value));
        let mut means: Vec<TokenStream> =
            self.view.condition.iter().map(|condition| holds(self.context, self.message, condition)).collect();
        means.extend(self.view.invalid.iter().filter_map(|blank| self.is_not(blank)));
        let view_of = quote!(#view::from_bits(bits #switch));
        let status = match means.split_first() {
            None => quote!(Some(#view_of)),
            Some((first, rest)) => quote!(if #first #(&& #rest)* { Some(#view_of) } else { None }),
        };
        quote! {
            /// The slot with this index; `None` where it is not in use.
            #[inline]
            pub fn #getter(&self, index: usize) -> Option<#item> {
                #in_use
                #(#locals)*
                let bits = #bits;
                let status = #status;
                Some(#item { #(#keys,)* status })
            }
        }
    }

    /// `set_esc`, `push_esc`, and what they share.
    fn write(&self, one: &str) -> TokenStream {
        let (item, getter) = (ident(&self.slots.item.rust), ident(one));
        let [set, push, store] = ["set", "push", "store"].map(|verb| format_ident!("{verb}_{one}"));
        let push = self.slots.count.and_then(|count| field(self.message, count)).map(|count| {
            let (name, ty) = (ident(&count.name.rust), crate::emit::token::scalar(count.ty.scalar));
            let used = as_index(count, &quote!(self.#name));
            let length = Literal::u8_unsuffixed(self.slots.length.get());
            quote! {
                /// Adds a slot behind those in use. An error if all are.
                #[inline]
                pub fn #push(&mut self, slot: #item) -> Result<(), wire::ViewError> {
                    let index = #used;
                    if index >= #length {
                        return Err(wire::ViewError::Full);
                    }
                    self.#store(index, slot).ok_or(wire::ViewError::Full)?;
                    self.#name = index as #ty + 1;
                    Ok(())
                }
            }
        });
        let body = self.store();
        quote! {
            /// Sets a slot that is in use. What is `None` in it is written as the value that says so.
            #[inline]
            pub fn #set(&mut self, index: usize, slot: #item) -> Result<(), wire::ViewError> {
                if self.#getter(index).is_none() {
                    return Err(wire::ViewError::NoSuchSlot);
                }
                self.#store(index, slot).ok_or(wire::ViewError::NoSuchSlot)
            }
            #push
            fn #store(&mut self, index: usize, slot: #item) -> Option<()> {
                #body
                Some(())
            }
        }
    }

    /// The assignments that put a slot into the arrays.
    fn store(&self) -> TokenStream {
        let (view, storage) = (ident(&self.view.name.rust), storage(self.view));
        let blank_words = self.view.invalid.iter().find_map(|blank| match blank {
            Blank::Words(value) => Some(*value),
            Blank::Field(..) => None,
        });
        let blank = Literal::u128_unsuffixed(blank_words.unwrap_or_default());
        let mut stores: Vec<TokenStream> = self.slots.keys.iter().filter_map(|key| self.store_key(key)).collect();
        stores.extend(self.words().iter().map(|word| {
            let bits = if word.at == 0 { quote!(bits) } else { right(word.at) };
            let value = word_of(self.context, word.field, &bits, &storage);
            self.assign(word.place, &value)
        }));
        if let Some((place, getter)) = self.switch() {
            stores.push(self.assign(place, &quote!(slot.status.map_or(0, #view::#getter))));
        }
        // Without bits that mean nothing, a field has to say so.
        if let (None, Some(Blank::Field(place, value))) = (blank_words, self.view.invalid.first()) {
            let value = integer(*value);
            let assign = self.assign(*place, &value);
            stores.push(quote!(if slot.status.is_none() { #assign }));
        }
        quote! {
            let bits = slot.status.map_or(#blank, #view::bits);
            #(#stores)*
        }
    }

    fn store_key(&self, key: &Key) -> Option<TokenStream> {
        let (name, field) = (ident(&key.name.rust()), field(self.message, key.place.field)?);
        let value = match (key.invalid, typed_enum(self.context, field)) {
            (None, _) => quote!(slot.#name),
            (Some(invalid), None) => {
                let invalid = integer(invalid);
                quote!(slot.#name.unwrap_or(#invalid))
            }
            (Some(invalid), Some(values)) => {
                let (invalid, ty) = (integer(invalid), ident(&values.name.rust));
                quote!(slot.#name.unwrap_or(#ty::from(#invalid)))
            }
        };
        // A scalar belongs to all slots: the first to be set decides, so none does.
        key.place.element.then(|| self.assign(key.place, &value))
    }

    fn assign(&self, place: Place, value: &TokenStream) -> TokenStream {
        let name = field(self.message, place.field).map(|field| ident(&field.name.rust));
        if place.element { quote!(*self.#name.get_mut(index)? = #value;) } else { quote!(self.#name = #value;) }
    }

    fn key_value(&self, key: &Key) -> Option<TokenStream> {
        let (name, value) = (ident(&key.name.rust()), self.value(key.place));
        let field = field(self.message, key.place.field)?;
        Some(match (key.invalid, typed_enum(self.context, field)) {
            (None, _) if name == value.to_string() => quote!(#name),
            (None, _) => quote!(#name: #value),
            (Some(invalid), None) => {
                let invalid = integer(invalid);
                quote!(#name: Some(#value).filter(|&v| v != #invalid))
            }
            (Some(invalid), Some(values)) => {
                let (invalid, ty) = (integer(invalid), ident(&values.name.rust));
                quote!(#name: Some(#value).filter(|&v| v != #ty::from(#invalid)))
            }
        })
    }

    /// `status_age != 65535`, `bits != 0`
    fn is_not(&self, blank: &Blank) -> Option<TokenStream> {
        Some(match blank {
            Blank::Words(value) => {
                let value = Literal::u128_unsuffixed(*value);
                quote!(bits != #value)
            }
            Blank::Field(place, value) => {
                let (left, right) = (self.value(*place), integer(*value));
                let typed = typed_enum(self.context, field(self.message, place.field)?);
                let ty = typed.map(|values| ident(&values.name.rust));
                let right = ty.map_or_else(|| right.clone(), |ty| quote!(#ty::from(#right)));
                quote!(#left != #right)
            }
        })
    }

    /// The words in order, each with the bit at which it begins.
    fn words(&self) -> Vec<WordPart<'a>> {
        let mut at = 0;
        let mut words = Vec::new();
        for word in &self.view.words {
            let Word::One(place) = *word else { continue };
            let Some(field) = field(self.message, place.field) else { continue };
            words.push(WordPart { place, field, at });
            at += element_bits(field);
        }
        words
    }

    /// `u64::from(data0) | (u64::from(data1) << 32)`
    fn joined(&self) -> TokenStream {
        let storage = storage(self.view);
        let parts = self.words().into_iter().map(|word| {
            let value = word_as(self.context, word.field, &self.value(word.place), &storage);
            shifted(&value, word.at)
        });
        quote!(#(#parts)|*)
    }

    /// The field that selects the layout, and the view's getter of it.
    fn switch(&self) -> Option<(Place, Ident)> {
        let switch = self.view.switch.as_ref()?;
        let SwitchOn::Field(place, _) = switch.on else { return None };
        Some((place, ident(&switch.name.rust())))
    }

    /// Every array that slots have elements of, once, with the local variable for its element.
    fn elements(&self) -> Vec<(&'a Field, Ident)> {
        let mut places: Vec<Place> = self.slots.keys.iter().map(|key| key.place).collect();
        places.extend(self.words().iter().map(|word| word.place));
        places.extend(self.view.invalid.iter().filter_map(|blank| match blank {
            Blank::Field(place, _) => Some(*place),
            Blank::Words(_) => None,
        }));
        places.extend(self.switch().map(|(place, _)| place));
        let mut indices: Vec<FieldIndex> =
            places.iter().filter(|place| place.element).map(|place| place.field).collect();
        indices.sort_by_key(|index| index.0);
        indices.dedup();
        let fields = indices.into_iter().filter_map(|index| field(self.message, index));
        fields.map(|field| (field, local(field))).collect()
    }

    /// The value at a place: the local variable of an element, or the field.
    fn value(&self, place: Place) -> TokenStream {
        let Some(field) = field(self.message, place.field) else { return quote!(0) };
        let (name, local) = (ident(&field.name.rust), local(field));
        if place.element { quote!(#local) } else { quote!(self.#name) }
    }
}

/// The local variable for an element of a field, different from those that the templates use.
fn local(field: &Field) -> Ident {
    let taken = ["index", "bits", "status", "slot"].contains(&field.name.rust.as_str());
    ident(&if taken { format!("{}_", field.name.rust) } else { field.name.rust.clone() })
}

fn right(at: u8) -> TokenStream {
    let at = Literal::u8_unsuffixed(at);
    quote!((bits >> #at))
}

/// A count as an index.
fn as_index(field: &Field, value: &TokenStream) -> TokenStream {
    if field.ty.scalar.size() <= 2 { quote!(usize::from(#value)) } else { quote!(#value as usize) }
}

/// The description, the unit, and what `None` means.
fn key_documentation(key: &Key) -> Vec<String> {
    let mut sentences: Vec<String> = Vec::new();
    if key.description.trim().is_empty() {
        sentences.push(format!("`{}`.", key.name));
    }
    sentences.extend(key.units.iter().map(|units| format!("In {units}.")));
    sentences.extend(key.invalid.map(|_| "`None` where it is not known.".to_owned()));
    let words = sentences.iter().flat_map(|sentence| sentence.split(' ')).map(str::to_owned);
    prose_with(&key.description, words.collect())
}
