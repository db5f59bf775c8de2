//! Getters and setters of scaled numbers: as a float, and exactly in a smaller unit; beside those of the raw number.
//!
//! ```text
//! /// Supply voltage. In V.
//! pub fn voltage(self) -> f32 { … }
//! pub fn set_voltage(&mut self, value: f32) -> Result<(), wire::ViewError> { … }
//! /// [`Self::voltage`] exactly, in mV.
//! pub const fn voltage_mv(self) -> i32 { … }
//! ```

use super::bits::raw_range;
use crate::emit::token::ident;
use crate::emit::ty::int;
use crate::rust::{Int, Scale};
use crate::tokens::{Literal, TokenStream, quote};

/// `f32::from(self.voltage_raw()) / 100.0`, through the `Option` of the raw number if there is one.
pub(in crate::emit) fn get(scale: &Scale<'_>) -> TokenStream {
    if !scale.bits.is_optional() {
        return to_float(scale, &raw(scale));
    }
    let (raw, value) = (raw(scale), to_float(scale, &quote!(raw)));
    quote!(#raw.map(|raw| #value))
}

/// The nearest raw number, if it fits.
pub(in crate::emit) fn set(scale: &Scale<'_>) -> TokenStream {
    let [factor, bias, divisor] = [scale.factor, scale.bias, scale.divisor].map(Literal::of);
    let (setter, index) = (ident(&scale.set_raw), scale.bits.repeat.map(|_| quote!(index,)));
    // The pattern is one of `i64`, which holds every raw number that a float can name exactly.
    let range = if scale.bits.raw == Int::of_bits(64, false) { quote!(0..=i64::MAX) } else { raw_range(&scale.bits) };
    let ty = int(scale.bits.raw);
    let number = if scale.bits.raw == Int::of_bits(64, true) { quote!(raw) } else { quote!(raw as #ty) };
    let set = match scale.bits.always_sets() {
        true => quote!({ self.#setter(#index #number); Ok(()) }),
        false => quote!(self.#setter(#index #number),),
    };
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
    if !scale.bits.is_optional() {
        return to_whole(scale, &raw);
    }
    let value = to_whole(scale, &quote!(raw));
    quote!(match #raw { Some(raw) => Some(#value), None => None })
}

/// `self.voltage_raw()`
fn raw(scale: &Scale<'_>) -> TokenStream {
    let (getter, index) = (ident(&scale.get_raw), scale.bits.repeat.map(|_| quote!(index)));
    quote!(self.#getter(#index))
}

/// `(f32::from(raw) - 128.0) / 4.0`: one division of exact numbers, so that the result is the nearest float.
fn to_float(scale: &Scale<'_>, raw: &TokenStream) -> TokenStream {
    if (scale.factor, scale.bias, scale.divisor) == (1, 0, 1) {
        return if scale.bits.raw.bits() <= 16 { quote!(f32::from(#raw)) } else { quote!(#raw as f32) };
    }
    let float = ident(if scale.in_f32 { "f32" } else { "f64" });
    let number = if scale.bits.raw.bits() <= 16 { quote!(#float::from(#raw)) } else { quote!((#raw as #float)) };
    let literal = |value: u64| Literal::of(format_args!("{}.0", value as f64));
    let product = match (scale.factor.unsigned_abs(), literal(scale.factor.unsigned_abs())) {
        (1, _) => number,
        (_, factor) => quote!(#number * #factor),
    };
    let bias = literal(scale.bias.unsigned_abs());
    // `-x` would make a negative zero of zero.
    let sum = match (scale.factor < 0, scale.bias) {
        (false, 0) => product,
        (false, 1..) => quote!(#product + #bias),
        (false, _) => quote!(#product - #bias),
        (true, 0..) => quote!(#bias - #product),
        (true, _) => quote!(-#bias - #product),
    };
    let value = match (scale.factor < 0 || scale.bias != 0, scale.divisor, literal(scale.divisor.unsigned_abs())) {
        (_, 1, _) => sum,
        (false, _, divisor) => quote!(#sum / #divisor),
        (true, _, divisor) => quote!((#sum) / #divisor),
    };
    if scale.in_f32 { value } else { quote!((#value) as f32) }
}

/// `raw as i32 * 10`
fn to_whole(scale: &Scale<'_>, raw: &TokenStream) -> TokenStream {
    let Some((exact, of)) = scale.exact else { return quote!() };
    let (ty, factor) = (int(of), Literal::of(exact.factor));
    let is_cast = of != scale.bits.raw;
    let number = if is_cast { quote!(#raw as #ty) } else { raw.clone() };
    let product = match exact.factor {
        1 => number,
        -1 if is_cast => quote!(-(#number)),
        -1 => quote!(-#number),
        _ => quote!(#number * #factor),
    };
    let bias = Literal::of(exact.bias.unsigned_abs());
    match exact.bias {
        0 => product,
        negative if negative < 0 => quote!(#product - #bias),
        _ => quote!(#product + #bias),
    }
}
