//! A view of each slot of arrays that lie side by side: an iterator, and setters for simulators. And a record of values, which
//! are read from fields of a message in the same way.

use super::source::{array, assign, if_all_hold, joined, store_word, value_at, view_of_bits};
use crate::emit::token::ident;
use crate::emit::ty::{number_in, value_of};
use crate::rust::{Count, Key, Place, Record, Slot, Switch, Test};
use crate::tokens::{TokenStream, quote};

/// `(0..4).map_while(|index| self.esc(index))`
pub(in crate::emit) fn all(get: &str, length: u8) -> TokenStream {
    quote!((0..#length).map_while(|index| self.#{ident(get)}(index)))
}

/// The slot of an index, if it is in use.
pub(in crate::emit) fn get(slot: &Slot<'_>) -> TokenStream {
    let Slot { ident: name, source, count, elements, keys, .. } = slot;
    quote! {
        #(if let Some(count) = count => if index >= #{used(*count)} { return None; })
        #(for element in elements => let #{ident(&element.local)} = *#{array(element)}.get(index)?;)*
        let bits = #{joined(source)};
        let status = #{if_all_hold(&source.when, &view_of_bits(source))};
        Some(#{ident(name)} { #(for one in keys => #{key(one)},)* status })
    }
}

/// `id: escid`, `age_ms: Some(status_age).filter(|&v| v != 65535)`
fn key(key: &Key<'_>) -> TokenStream {
    let (name, value) = (ident(key.ident), value_at(&key.place));
    match (key.invalid, &key.place) {
        (Some(invalid), _) => quote!(#name: Some(#value).filter(|&v| v != #invalid)),
        (None, Place::Element(element)) if element.local == key.ident => name,
        (None, _) => quote!(#name: #value),
    }
}

/// Sets a slot that is in use.
pub(in crate::emit) fn set(get: &str, store: &str) -> TokenStream {
    quote! {
        if self.#{ident(get)}(index).is_none() {
            return Err(wire::ViewError::NoSuchSlot);
        }
        self.#{ident(store)}(index, slot).ok_or(wire::ViewError::NoSuchSlot)
    }
}

/// Adds a slot behind those in use.
pub(in crate::emit) fn push(count: Count<'_>, length: u8, store: &str) -> TokenStream {
    let own = count.element.int();
    quote! {
        let index = #{used(count)};
        if index >= #length {
            return Err(wire::ViewError::Full);
        }
        self.#{ident(store)}(index, slot).ok_or(wire::ViewError::Full)?;
        self.#{ident(count.field)} = #{value_of(count.element, &quote!(index as #own + 1))};
        Ok(())
    }
}

/// A count as an index.
fn used(count: Count<'_>) -> TokenStream {
    let number = number_in(count.element, &quote!(self.#{ident(count.field)}));
    if count.element.int().bits() <= 16 { quote!(usize::from(#number)) } else { quote!(#number as usize) }
}

/// The assignments that put a slot into the arrays.
pub(in crate::emit) fn store(slot: &Slot<'_>) -> TokenStream {
    let Slot { source, keys, .. } = slot;
    let (view, optional) = (ident(source.view), !source.when.is_empty());
    let (sentinel, mark) = match source.sentinel() {
        Some(Test::WordsAreNot(value)) => (*value, None),
        // A field has to say so, whatever the key and the switch have put into it.
        Some(Test::IsNot(place, value)) => (0, Some(assign(place, &quote!(#value)))),
        Some(Test::Is(..)) | None => (0, None),
    };
    let switch = source.switch.as_ref().map(|Switch { place, element, get }| {
        let get = ident(get);
        let number = if optional { quote!(slot.status.map_or(0, #view::#get)) } else { quote!(slot.status.#get()) };
        assign(place, &value_of(*element, &number))
    });
    // A scalar belongs to all slots: the first to be set would decide, so none does.
    let own = keys.iter().filter(|key| matches!(key.place, Place::Element(_)));
    let bits = if optional { quote!(slot.status.map_or(#sentinel, #view::bits)) } else { quote!(slot.status.bits()) };
    quote! {
        let bits = #bits;
        #(for key in own => #{stored(key, &quote!(slot))})*
        #(for word in &source.words => #{store_word(source, word)})*
        #switch
        #(if let Some(mark) = mark => if slot.status.is_none() { #mark })
        Some(())
    }
}

/// `self.value1 = value.pdop;`
fn stored(key: &Key<'_>, record: &TokenStream) -> TokenStream {
    let unwrap = key.invalid.map(|invalid| quote!(.unwrap_or(#invalid)));
    assign(&key.place, &quote!(#record.#{ident(key.ident)} #unwrap))
}

/// The values of a record, if the condition holds: `if self.index == 4 { Some(AqGps { pdop: self.value1 }) } else { None }`.
pub(in crate::emit) fn get_record(Record { ident: name, values, when }: &Record<'_>) -> TokenStream {
    if_all_hold(when.as_slice(), &quote!(#{ident(name)} { #(for value in values => #{key(value)}),* }))
}

/// Puts the values of a record into their fields, and makes the condition hold.
pub(in crate::emit) fn set_record(Record { values, when, .. }: &Record<'_>) -> TokenStream {
    quote! {
        #(if let Some(Test::Is(place, value)) = when => #{assign(place, &quote!(#value))})
        #(for value in values => #{stored(value, &quote!(value))})*
    }
}
