//! Where a message has a view: its words joined and stored, the value of its switch, and what must hold.

use crate::emit::token::ident;
use crate::emit::ty::{int, literal, number_in, value_of};
use crate::rust::{Place, SlotElement, Source, Switch, Test, Word};
use crate::tokens::{Literal, TokenStream, quote};

/// The view, if the bits mean something.
pub(in crate::emit) fn get(source: &Source<'_>) -> TokenStream {
    let (bits, value) = (joined(source), view_of_bits(source));
    let value = if_all_hold(&source.when, &value);
    quote! {
        let bits = #bits;
        #value
    }
}

/// Puts the bits, and the value of the switch, where they belong.
pub(in crate::emit) fn set(source: &Source<'_>) -> TokenStream {
    let words = source.words.iter().map(|word| store_word(source, word));
    let switch = source.switch.as_ref().map(|Switch { place, element, get }| {
        let get = ident(get);
        assign(place, &value_of(*element, &quote!(value.#get())))
    });
    quote! {
        let bits = value.bits();
        #(#words)*
        #switch
    }
}

/// `u64::from(self.data0) | (u64::from(self.data1) << 32)`
pub(super) fn joined(source: &Source<'_>) -> TokenStream {
    let storage = int(source.storage);
    let words = source.words.iter().map(|word| {
        let number = number_in(word.element, &value_at(&word.place));
        let number = if word.element.int() == source.storage { number } else { quote!(#storage::from(#number)) };
        let at = Literal::of(word.at);
        if word.at == 0 { number } else { quote!((#number << #at)) }
    });
    quote!(#(#words)|*)
}

/// `self.data1 = (bits >> 32) as u32;`
pub(super) fn store_word(source: &Source<'_>, word: &Word<'_>) -> TokenStream {
    let (own, at) = (int(word.element.int()), Literal::of(word.at));
    let bits = if word.at == 0 { quote!(bits) } else { quote!((bits >> #at)) };
    let number = if word.element.int() == source.storage { bits } else { quote!(#bits as #own) };
    assign(&word.place, &value_of(word.element, &number))
}

/// `EscStatus::from_bits(bits, self.data_version)`
pub(super) fn view_of_bits(source: &Source<'_>) -> TokenStream {
    let view = ident(source.view);
    let switch = source.switch.iter().map(|switch| number_in(switch.element, &value_at(&switch.place)));
    quote!(#view::from_bits(bits #(, #switch)*))
}

/// The value as it is where nothing must hold, else in an `Option`.
pub(in crate::emit) fn if_all_hold(when: &[Test<'_>], value: &TokenStream) -> TokenStream {
    if when.is_empty() {
        return value.clone();
    }
    let all = all_hold(when);
    quote!(if #all { Some(#value) } else { None })
}

/// `self.autopilot == MavAutopilot::AUTOQUAD && bits != 0`
pub(super) fn all_hold(when: &[Test<'_>]) -> TokenStream {
    let tests = when.iter().map(|test| match test {
        Test::Is(place, value) => {
            let (left, right) = (value_at(place), literal(*value));
            quote!(#left == #right)
        }
        Test::IsNot(place, value) => {
            let (left, right) = (value_at(place), literal(*value));
            quote!(#left != #right)
        }
        Test::WordsAreNot(value) => {
            let value = Literal::of(*value);
            quote!(bits != #value)
        }
    });
    quote!(#(#tests)&&*)
}

/// `self.count`, `self.data[1]`, `status_age`
pub(super) fn value_at(place: &Place<'_>) -> TokenStream {
    match place {
        Place::Field(field) => {
            let field = ident(field);
            quote!(self.#field)
        }
        Place::At(field, index) => {
            let (field, index) = (ident(field), Literal::of(*index));
            quote!(self.#field[#index])
        }
        Place::Element(element) => {
            let local = ident(&element.local);
            quote!(#local)
        }
    }
}

pub(super) fn assign(place: &Place<'_>, value: &TokenStream) -> TokenStream {
    match place {
        Place::Field(_) | Place::At(..) => {
            let place = value_at(place);
            quote!(#place = #value;)
        }
        Place::Element(element) => {
            let array = array(element);
            quote!(*#array.get_mut(index)? = #value;)
        }
    }
}

/// `self.data0`, and of a text its characters.
pub(super) fn array(element: &SlotElement<'_>) -> TokenStream {
    let field = ident(element.field);
    if element.chars { quote!(self.#field.0) } else { quote!(self.#field) }
}
