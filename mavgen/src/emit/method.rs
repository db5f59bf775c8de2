//! A method: what its signature says, around the body of its kind.

use super::body::{accessor, bits, record, scaled, slots, source};
use super::doc;
use super::token::ident;
use super::ty::{number_in, ty, value_of};
use crate::rust::{Bind, Kind, Method, Receiver, Sig, Ty};
use crate::tokens::{TokenStream, quote};

pub(super) fn method(method: &Method<'_>) -> TokenStream {
    let Method { ident: name, sig, docs, inline, kind } = method;
    let Sig { public, is_const, receiver, params, result } = sig;
    let (docs, name, body) = (doc::documentation(docs), ident(name), body(kind));
    let inline = inline.then(|| quote!(#[inline]));
    let must_use = (*receiver == Receiver::MutValue && *result == Ty::Own).then(|| quote!(#[must_use]));
    let public = public.then(|| quote!(pub));
    let is_const = is_const.then(|| quote!(const));
    let receiver = match receiver {
        Receiver::None => None,
        Receiver::Value => Some(quote!(self)),
        Receiver::Ref => Some(quote!(&self)),
        Receiver::Mut => Some(quote!(&mut self)),
        Receiver::MutValue => Some(quote!(mut self)),
    };
    let params = params.iter().map(|param| {
        let (name, ty) = (ident(param.ident), ty(&param.ty));
        quote!(#name: #ty)
    });
    let params = receiver.into_iter().chain(params);
    let result = match result {
        Ty::Unit => quote!(),
        other => {
            let other = ty(other);
            quote!(-> #other)
        }
    };
    quote! {
        #docs
        #inline
        #must_use
        #public #is_const fn #name(#(#params),*) #result {
            #body
        }
    }
}

fn body(kind: &Kind<'_>) -> TokenStream {
    match kind {
        Kind::FromBits { switch } => {
            let switch = switch.iter().map(|name| ident(name));
            quote!(Self { bits #(, #switch)* })
        }
        Kind::Bits => quote!(self.bits),
        Kind::SwitchGet(name) => {
            let name = ident(name);
            quote!(self.#name)
        }
        Kind::MemberGet(of) => bits::get(of),
        Kind::MemberSet(of) => bits::set(of),
        Kind::With { set, indexed, fallible } => with(set, *indexed, *fallible),
        Kind::ScaledGet(scale) => scaled::get(scale),
        Kind::ScaledSet(scale) => scaled::set(scale),
        Kind::ExactGet(scale) => scaled::exact(scale),
        Kind::ViewGet(of) => source::get(of),
        Kind::ViewSet(of) => source::set(of),
        Kind::Slots { get, length } => slots::all(get, *length),
        Kind::SlotGet(slot) => slots::get(slot),
        Kind::SlotSet { get, store } => slots::set(get, store),
        Kind::SlotPush { count, length, store } => slots::push(*count, *length, store),
        Kind::SlotStore(slot) => slots::store(slot),
        Kind::RecordGet(of) => record::get(of),
        Kind::RecordSet(of) => record::set(of),
        Kind::Params => params(),
        Kind::SentinelGet(sentinel) => accessor::get(sentinel),
        Kind::SentinelSet(sentinel) => accessor::set(sentinel),
        Kind::SentinelIter(sentinel) => accessor::iter(sentinel),
        Kind::EnumGet(convert) => accessor::get_enum(convert),
        Kind::EnumSet(convert) => accessor::set_enum(convert),
        Kind::BindGet(bind) => bind_get(bind),
        Kind::BindSet(bind) => bind_set(bind),
    }
}

/// `self.set_rpm(value)`, and then `self`; a `match`, because `?` is for no `const fn`.
fn with(set: &str, indexed: bool, fallible: bool) -> TokenStream {
    let (set, index) = (ident(set), indexed.then(|| quote!(index,)));
    if !fallible {
        return quote! {
            self.#set(#index value);
            self
        };
    }
    quote! {
        match self.#set(#index value) {
            Ok(()) => Ok(self),
            Err(error) => Err(error),
        }
    }
}

/// `MavState(self.state)`, if the condition holds.
fn bind_get(bind: &Bind<'_>) -> TokenStream {
    let field = ident(bind.field);
    let value = value_of(bind.bound.as_int(), &quote!(self.#field));
    source::if_all_hold(bind.when.as_slice(), &value)
}

/// `self.state = value.0;`
fn bind_set(bind: &Bind<'_>) -> TokenStream {
    let (field, number) = (ident(bind.field), number_in(bind.bound.as_int(), &quote!(value)));
    quote!(self.#field = #number;)
}

/// The row of the command in `PARAMS`, if it has one.
fn params() -> TokenStream {
    quote! {
        let found = PARAMS.binary_search_by_key(&self.0, |&(command, _)| command);
        found.ok().and_then(|at| PARAMS.get(at)).map_or(&[], |&(_, params)| params)
    }
}
