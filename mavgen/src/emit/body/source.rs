//! Where a message has a view: its words joined and stored, the value of its switch, and what must hold.

use crate::emit::token::ident;
use crate::emit::ty::{number_in, value_of};
use crate::rust::{Place, SlotElement, Source, Switch, Test, Word};
use crate::tokens::{TokenStream, quote};

/// The view, if the bits mean something.
pub(in crate::emit) fn get(source: &Source<'_>) -> TokenStream {
    quote! {
        let bits = #{joined(source)};
        #{if_all_hold(&source.when, &view_of_bits(source))}
    }
}

/// Puts the bits, and the value of the switch, where they belong.
pub(in crate::emit) fn set(source: &Source<'_>) -> TokenStream {
    let switch = source.switch.as_ref().map(|Switch { place, element, get }| {
        let number = quote!(value.#{ident(get)}());
        assign(place, &value_of(*element, &number))
    });
    quote! {
        let bits = value.bits();
        #(for word in &source.words => #{store_word(source, word)})*
        #switch
    }
}

/// `u64::from(self.data0) | (u64::from(self.data1) << 32)`
pub(super) fn joined(source: &Source<'_>) -> TokenStream {
    let storage = source.storage;
    let joined = |Word { place, element, at }: &Word<'_>| {
        let number = number_in(*element, &value_at(place));
        let number = if element.int() == storage { number } else { quote!(#storage::from(#number)) };
        if *at == 0 { number } else { quote!((#number << #at)) }
    };
    quote!(#(for word in &source.words => #{joined(word)})|*)
}

/// `self.data1 = (bits >> 32) as u32;`
pub(super) fn store_word(source: &Source<'_>, Word { place, element, at }: &Word<'_>) -> TokenStream {
    let bits = if *at == 0 { quote!(bits) } else { quote!((bits >> #at)) };
    let number = quote!(#bits #(if element.int() != source.storage => as #{element.int()}));
    assign(place, &value_of(*element, &number))
}

/// `EscStatus::from_bits(bits, self.data_version)`
pub(super) fn view_of_bits(source: &Source<'_>) -> TokenStream {
    let switch = source.switch.as_ref().map(|switch| number_in(switch.element, &value_at(&switch.place)));
    quote!(#{ident(source.view)}::from_bits(bits #(if let Some(switch) = switch => , #switch)))
}

/// The value as it is where nothing must hold, else in an `Option`.
pub(in crate::emit) fn if_all_hold(when: &[Test<'_>], value: &TokenStream) -> TokenStream {
    match when {
        [] => value.clone(),
        when => quote!(if #{all_hold(when)} { Some(#value) } else { None }),
    }
}

/// `self.autopilot == MavAutopilot::AUTOQUAD && bits != 0`
fn all_hold(when: &[Test<'_>]) -> TokenStream {
    let test = |test: &Test<'_>| match test {
        Test::Is(place, value) => quote!(#{value_at(place)} == #value),
        Test::IsNot(place, value) => quote!(#{value_at(place)} != #value),
        Test::WordsAreNot(value) => quote!(bits != #value),
    };
    quote!(#(for one in when => #{test(one)})&&*)
}

/// `self.count`, `self.data[1]`, `status_age`
pub(super) fn value_at(place: &Place<'_>) -> TokenStream {
    match place {
        Place::Field(field) => quote!(self.#{ident(field)}),
        Place::At(field, index) => quote!(self.#{ident(field)}[#index]),
        Place::Element(element) => ident(&element.local),
    }
}

pub(super) fn assign(place: &Place<'_>, value: &TokenStream) -> TokenStream {
    match place {
        Place::Field(_) | Place::At(..) => quote!(#{value_at(place)} = #value;),
        Place::Element(element) => quote!(*#{array(element)}.get_mut(index)? = #value;),
    }
}

/// `self.data0`, and of a text its characters.
pub(super) fn array(element: &SlotElement<'_>) -> TokenStream {
    quote!(self.#{ident(element.field)} #(if element.chars => .0))
}
