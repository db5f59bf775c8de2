//! A view of each slot of arrays that lie side by side: an iterator, and setters for simulators.
//!
//! ```text
//! impl AqEscTelemetry {
//!     pub fn escs(&self) -> impl Iterator<Item = Esc> + '_ { … }
//!     pub fn esc(&self, index: usize) -> Option<Esc> { … }
//!     pub fn set_esc(&mut self, index: usize, slot: Esc) -> Result<(), wire::ViewError> { … }
//!     pub fn push_esc(&mut self, slot: Esc) -> Result<(), wire::ViewError> { … }
//!     fn store_esc(&mut self, index: usize, slot: Esc) -> Option<()> { … }
//! }
//! ```

use super::source::{all_hold, array, assign, joined, store_word, value_at, view_of_bits};
use crate::emit::token::ident;
use crate::emit::ty::{int, literal, number_in, value_of};
use crate::rust::{Count, Key, Place, Slot, Stored, Switch};
use crate::tokens::{Literal, TokenStream, quote};

/// `(0..4).map_while(|index| self.esc(index))`
pub(in crate::emit) fn all(get: &str, length: u8) -> TokenStream {
    let (get, length) = (ident(get), Literal::of(length));
    quote!((0..#length).map_while(|index| self.#get(index)))
}

/// The slot of an index, if it is in use.
pub(in crate::emit) fn get(slot: &Slot<'_>) -> TokenStream {
    let Slot { ident: name, source, count, elements, keys, .. } = slot;
    let in_use = count.map(|count| {
        let used = used(count);
        quote!(if index >= #used { return None; })
    });
    let locals = elements.iter().map(|element| {
        let (local, array) = (ident(&element.local), array(element));
        quote!(let #local = *#array.get(index)?;)
    });
    let (name, bits, view) = (ident(name), joined(source), view_of_bits(source));
    let status = match source.when.as_slice() {
        [] => view,
        when => {
            let all = all_hold(when);
            quote!(if #all { Some(#view) } else { None })
        }
    };
    let keys = keys.iter().map(key);
    quote! {
        #in_use
        #(#locals)*
        let bits = #bits;
        let status = #status;
        Some(#name { #(#keys,)* status })
    }
}

/// `id: escid`, `age_ms: Some(status_age).filter(|&v| v != 65535)`
pub(super) fn key(key: &Key<'_>) -> TokenStream {
    let (name, value) = (ident(key.ident), value_at(&key.place));
    match (key.invalid, &key.place) {
        (Some(invalid), _) => {
            let invalid = literal(invalid);
            quote!(#name: Some(#value).filter(|&v| v != #invalid))
        }
        (None, Place::Element(element)) if element.local == key.ident => quote!(#name),
        (None, _) => quote!(#name: #value),
    }
}

/// Sets a slot that is in use.
pub(in crate::emit) fn set(get: &str, store: &str) -> TokenStream {
    let (get, store) = (ident(get), ident(store));
    quote! {
        if self.#get(index).is_none() {
            return Err(wire::ViewError::NoSuchSlot);
        }
        self.#store(index, slot).ok_or(wire::ViewError::NoSuchSlot)
    }
}

/// Adds a slot behind those in use.
pub(in crate::emit) fn push(count: Count<'_>, length: u8, store: &str) -> TokenStream {
    let (field, store, own) = (ident(count.field), ident(store), int(count.as_int.int));
    let (used, length) = (used(count), Literal::of(length));
    let more = value_of(count.as_int, &quote!(index as #own + 1));
    quote! {
        let index = #used;
        if index >= #length {
            return Err(wire::ViewError::Full);
        }
        self.#store(index, slot).ok_or(wire::ViewError::Full)?;
        self.#field = #more;
        Ok(())
    }
}

/// A count as an index.
fn used(count: Count<'_>) -> TokenStream {
    let field = ident(count.field);
    let number = number_in(count.as_int, &quote!(self.#field));
    if count.as_int.int.bits() <= 16 { quote!(usize::from(#number)) } else { quote!(#number as usize) }
}

/// The assignments that put a slot into the arrays.
pub(in crate::emit) fn store(slot: &Slot<'_>) -> TokenStream {
    let Slot { source, keys, sentinel, .. } = slot;
    let (view, optional) = (ident(source.view), !source.when.is_empty());
    let (sentinel, mark) = match sentinel {
        Stored::Words(value) => (Literal::of(*value), None),
        // A field has to say so, whatever the key and the switch have put into it.
        Stored::Field(place, value) => {
            let assign = assign(place, &literal(*value));
            (Literal::of(0), Some(quote!(if slot.status.is_none() { #assign })))
        }
    };
    let keys = keys.iter().filter_map(store_key);
    let words = source.words.iter().map(|word| store_word(source, word));
    let switch = source.switch.as_ref().map(|Switch { place, as_int, get }| {
        let get = ident(get);
        let number = if optional { quote!(slot.status.map_or(0, #view::#get)) } else { quote!(slot.status.#get()) };
        assign(place, &value_of(*as_int, &number))
    });
    let bits = if optional { quote!(slot.status.map_or(#sentinel, #view::bits)) } else { quote!(slot.status.bits()) };
    quote! {
        let bits = #bits;
        #(#keys)*
        #(#words)*
        #switch
        #mark
        Some(())
    }
}

/// Nothing for a scalar, which belongs to all slots: the first to be set would decide, so none does.
fn store_key(key: &Key<'_>) -> Option<TokenStream> {
    matches!(key.place, Place::Element(_)).then(|| stored(key, &quote!(slot)))
}

/// `self.value1 = value.pdop;`
pub(super) fn stored(key: &Key<'_>, record: &TokenStream) -> TokenStream {
    let name = ident(key.ident);
    let value = match key.invalid {
        Some(invalid) => {
            let invalid = literal(invalid);
            quote!(#record.#name.unwrap_or(#invalid))
        }
        None => quote!(#record.#name),
    };
    assign(&key.place, &value)
}
