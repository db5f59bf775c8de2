//! A method: what its signature says, around the body of its kind.

use super::body::{accessor, bits, scaled, slots, source};
use super::token::ident;
use super::ty::{number_in, value_of};
use crate::rust::{Bind, Element, Kind, Method, Param, Receiver, Sig, Ty};
use crate::tokens::{ToTokens, TokenStream, quote};

impl ToTokens for Method<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        let Self { ident: name, sig, docs, kind } = self;
        let is_chained = sig.receiver == Receiver::MutValue && sig.result == Ty::Own;
        quote! {
            #docs
            #(if self.is_inline() => #[inline])
            #(if is_chained => #[must_use])
            #(if sig.public => pub) #(if sig.is_const => const) fn #{ident(name)} #sig {
                #{body(kind)}
            }
        }
        .to_tokens(tokens);
    }
}

/// `(&self, index: usize) -> u8`
impl ToTokens for Sig<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        let Self { public: _, is_const: _, receiver, params, result } = self;
        let receiver = match receiver {
            Receiver::None => None,
            Receiver::Value => Some(quote!(self)),
            Receiver::Ref => Some(quote!(&self)),
            Receiver::Mut => Some(quote!(&mut self)),
            Receiver::MutValue => Some(quote!(mut self)),
        };
        let params = params.iter().map(|Param { ident: name, ty }| quote!(#{ident(name)}: #ty));
        let params = receiver.into_iter().chain(params);
        quote!((#(#params),*) #(if *result != Ty::Unit => -> #result)).to_tokens(tokens);
    }
}

fn body(kind: &Kind<'_>) -> TokenStream {
    match kind {
        Kind::FromBits { switch } => quote!(Self { bits #(if let Some(switch) = switch => , #{ident(switch)}) }),
        Kind::Bits => quote!(self.bits),
        Kind::SwitchGet(name) => quote!(self.#{ident(name)}),
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
        Kind::RecordGet(of) => slots::get_record(of),
        Kind::RecordSet(of) => slots::set_record(of),
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
    let set = quote!(self.#{ident(set)}(#(if indexed => index,) value));
    match fallible {
        true => quote!(match #set { Ok(()) => Ok(self), Err(error) => Err(error), }),
        false => quote!(#set; self),
    }
}

/// `MavState(self.state)`, if the condition holds.
fn bind_get(bind: &Bind<'_>) -> TokenStream {
    let value = value_of(Element::Enum(bind.bound), &quote!(self.#{ident(bind.field)}));
    source::if_all_hold(bind.when.as_slice(), &value)
}

/// `self.state = value.0;`
fn bind_set(bind: &Bind<'_>) -> TokenStream {
    quote!(self.#{ident(bind.field)} = #{number_in(Element::Enum(bind.bound), &quote!(value))};)
}

/// The row of the command in `PARAMS`, if it has one.
fn params() -> TokenStream {
    quote! {
        let found = PARAMS.binary_search_by_key(&self.0, |&(command, _)| command);
        found.ok().and_then(|at| PARAMS.get(at)).map_or(&[], |&(_, params)| params)
    }
}
