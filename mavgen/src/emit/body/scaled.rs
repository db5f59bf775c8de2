//! Getters and setters of scaled numbers: as a float, and exactly in a smaller unit; beside those of the raw number.

use super::bits::raw_range;
use crate::emit::token::ident;
use crate::rust::{Int, Scale};
use crate::tokens::{TokenStream, quote};

/// `f32::from(self.voltage_raw()) / 100.0`, through the `Option` of the raw number if there is one.
pub(in crate::emit) fn get(scale: &Scale<'_>) -> TokenStream {
    let raw = raw(scale);
    match scale.bits.is_optional() {
        true => quote!(#raw.map(|raw| #{to_float(scale, &quote!(raw))})),
        false => to_float(scale, &raw),
    }
}

/// The nearest raw number, if it fits.
pub(in crate::emit) fn set(scale: &Scale<'_>) -> TokenStream {
    let [factor, bias, divisor] = [scale.factor, scale.bias, scale.divisor].map(TokenStream::of);
    let (setter, index) = (ident(&scale.set_raw), scale.bits.repeat.map(|_| quote!(index,)));
    // The pattern is one of `i64`, which holds every raw number that a float can name exactly.
    let [unsigned, signed] = [false, true].map(|signed| scale.bits.raw == Int::of_bits(64, signed));
    let range = if unsigned { quote!(0..=i64::MAX) } else { raw_range(&scale.bits) };
    let set = quote!(self.#setter(#index raw #(if !signed => as #{scale.bits.raw})));
    let set = if scale.bits.always_sets() { quote!({ #set; Ok(()) }) } else { quote!(#set,) };
    quote! {
        match wire::generated::raw_of(value, #factor, #bias, #divisor) {
            Some(raw @ #range) => #set
            _ => Err(wire::ViewError::OutOfRange),
        }
    }
}

/// `self.voltage_raw() as i32 * 10`; a `match` through an `Option`, because `Option::map` is no `const fn`.
pub(in crate::emit) fn exact(scale: &Scale<'_>) -> TokenStream {
    let raw = raw(scale);
    match scale.bits.is_optional() {
        true => quote!(match #raw { Some(raw) => Some(#{to_whole(scale, &quote!(raw))}), None => None }),
        false => to_whole(scale, &raw),
    }
}

/// `self.voltage_raw()`
fn raw(scale: &Scale<'_>) -> TokenStream {
    quote!(self.#{ident(&scale.get_raw)}(#(if scale.bits.repeat.is_some() => index)))
}

/// `(f32::from(raw) - 128.0) / 4.0`: one division of exact numbers, so that the result is the nearest float.
fn to_float(scale: &Scale<'_>, raw: &TokenStream) -> TokenStream {
    let Scale { factor, bias, divisor, .. } = *scale;
    let is_narrow = scale.bits.raw.bits() <= 16;
    if (factor, bias, divisor) == (1, 0, 1) {
        return if is_narrow { quote!(f32::from(#raw)) } else { quote!(#raw as f32) };
    }
    let float = if scale.in_f32 { quote!(f32) } else { quote!(f64) };
    let number = if is_narrow { quote!(#float::from(#raw)) } else { quote!((#raw as #float)) };
    let literal = |value: i64| TokenStream::of(format_args!("{}.0", value.unsigned_abs() as f64));
    let product = quote!(#number #(if factor.unsigned_abs() != 1 => * #{literal(factor)}));
    let offset = literal(bias);
    // `-x` would make a negative zero of zero.
    let sum = match (factor < 0, bias) {
        (false, 0) => product,
        (false, 1..) => quote!(#product + #offset),
        (false, _) => quote!(#product - #offset),
        (true, 0..) => quote!(#offset - #product),
        (true, _) => quote!(-#offset - #product),
    };
    let value = match (factor < 0 || bias != 0, divisor) {
        (_, 1) => sum,
        (false, _) => quote!(#sum / #{literal(divisor)}),
        (true, _) => quote!((#sum) / #{literal(divisor)}),
    };
    if scale.in_f32 { value } else { quote!((#value) as f32) }
}

/// `raw as i32 * 10`
fn to_whole(scale: &Scale<'_>, raw: &TokenStream) -> TokenStream {
    let Some((exact, of)) = scale.exact else { return quote!() };
    let is_cast = of != scale.bits.raw;
    let number = quote!(#raw #(if is_cast => as #of));
    let product = match exact.factor {
        1 => number,
        -1 if is_cast => quote!(-(#number)),
        -1 => quote!(-#number),
        factor => quote!(#number * #{TokenStream::of(factor)}),
    };
    let bias = exact.bias.unsigned_abs();
    match exact.bias {
        0 => product,
        ..0 => quote!(#product - #bias),
        1.. => quote!(#product + #bias),
    }
}
