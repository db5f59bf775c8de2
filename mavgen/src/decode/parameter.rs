//! The value of a parameter, which is seldom of the type of the field that carries it.

use mavlink_wire::Kind;
use mavlink_wire::reflect::Number;

use super::node::{Entry, Node, number};
use crate::ir::{Field, Message, Scalar};

/// The field with the value, in PARAM_VALUE, PARAM_SET, PARAM_EXT_VALUE and their like.
const VALUE: &str = "param_value";
/// The field with the type: MAV_PARAM_TYPE, or MAV_PARAM_EXT_TYPE, which has the same numbers.
const TYPE: &str = "param_type";

/// The names that the readings of a message's parameter can have; none of a message without one.
#[must_use]
pub fn parameter_readings(message: &Message) -> &'static [&'static str] {
    match fields(message) {
        Some((value, _)) if value.ty.scalar == Scalar::F32 => &["bytewise", "cast"],
        Some(_) => &["bytewise"],
        None => &[],
    }
}

/// What the parameter in a payload can be, by its type; `None` where the field itself says it.
///
/// There are two ways to put an integer into a `float`, and the frame does not say which: byte for byte, as PX4 does
/// (MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE), or as the nearest float, as ArduPilot does
/// (MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST). A reading that the bits rule out is not there.
pub(super) fn parameter(message: &Message, payload: &[u8]) -> Option<Entry> {
    let (value, ty) = fields(message)?;
    let ty = kind(Number::read(Kind::U8, payload, ty.offset.into()))?;
    let offset = usize::from(value.offset);
    let mut readings = Vec::new();
    let mut push = |name: &str, read: Number| {
        readings.push(Entry::of(name, number(read)));
    };
    if value.ty.scalar == Scalar::Char {
        push("bytewise", Number::read(ty, payload, offset));
    } else if !matches!(ty, Kind::F32 | Kind::F64) {
        let bits = Number::read(Kind::U32, payload, offset).as_integer()? as u32;
        bytewise(bits, ty).into_iter().for_each(|read| push("bytewise", read));
        cast(f32::from_bits(bits), ty).into_iter().for_each(|read| push("cast", read));
    }
    (!readings.is_empty()).then(|| Entry::of("parameter", Node::Record(readings)))
}

/// The fields of a message with a parameter: its value, in a `float` or in bytes, and its type.
fn fields(message: &Message) -> Option<(&Field, &Field)> {
    let field = |name: &str| message.fields.iter().find(|field| field.name.text == name);
    let (value, ty) = (field(VALUE)?, field(TYPE)?);
    let carries = match value.ty.scalar {
        Scalar::F32 => value.ty.array.is_none(),
        // A `double`, the largest type.
        Scalar::Char => value.ty.size() >= 8,
        _ => false,
    };
    (carries && ty.ty.scalar == Scalar::U8 && ty.ty.array.is_none()).then_some((value, ty))
}

/// The type that a number of MAV_PARAM_TYPE stands for.
fn kind(number: Number) -> Option<Kind> {
    Some(match number.as_integer()? {
        1 => Kind::U8,
        2 => Kind::I8,
        3 => Kind::U16,
        4 => Kind::I16,
        5 => Kind::U32,
        6 => Kind::I32,
        7 => Kind::U64,
        8 => Kind::I64,
        9 => Kind::F32,
        10 => Kind::F64,
        _ => return None,
    })
}

/// The integer whose bytes are the first of the float's; the others are zeros, or copies of its sign.
fn bytewise(bits: u32, ty: Kind) -> Option<Number> {
    let number = Number::read(ty, &bits.to_le_bytes(), 0);
    let value = number.as_integer().filter(|_| ty.size() <= 4)?;
    let width = 8 * ty.size() as u32;
    let is_rest_empty = bits.checked_shr(width).unwrap_or_default() == 0;
    (is_rest_empty || value < 0 && value as u32 == bits).then_some(number)
}

/// The integer that the float is, if it is one that the type has.
fn cast(value: f32, ty: Kind) -> Option<Number> {
    // All that a `float` can hold below 2^127 is an `i128`; what is larger is no integer of 64 bits.
    let integer = (value.fract() == 0.0 && value.abs() < 2e19).then_some(value as i128)?;
    let width = 8 * ty.size() as u32;
    let signed = matches!(ty, Kind::I8 | Kind::I16 | Kind::I32 | Kind::I64);
    let half = 1_i128 << (width - 1);
    match signed {
        true => i64::try_from(integer).ok().filter(|_| (-half..half).contains(&integer)).map(Number::I64),
        false => u64::try_from(integer).ok().filter(|_| integer < 2 * half).map(Number::U64),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_in_a_float() {
        let (unsigned, signed) = (|value| Some(Number::U64(value)), |value| Some(Number::I64(value)));
        for (bits, ty, expected) in [
            (u32::MAX, Kind::I32, (signed(-1), None)),
            (7, Kind::I32, (signed(7), None)),
            (0, Kind::I32, (signed(0), signed(0))),
            (7.0_f32.to_bits(), Kind::I32, (signed(0x40e0_0000), signed(7))),
            ((-7.0_f32).to_bits(), Kind::U32, (unsigned(0xc0e0_0000), None)),
            (7.5_f32.to_bits(), Kind::I32, (signed(0x40f0_0000), None)),
            (2_147_483_648.0_f32.to_bits(), Kind::I32, (signed(0x4f00_0000), None)),
            (2_147_483_648.0_f32.to_bits(), Kind::U32, (unsigned(0x4f00_0000), unsigned(1 << 31))),
            (200, Kind::U8, (unsigned(200), None)),
            (256, Kind::U8, (None, None)),
            (1.0_f32.to_bits(), Kind::U8, (None, unsigned(1))),
            (255.0_f32.to_bits(), Kind::I8, (None, None)),
            (0xff, Kind::I8, (signed(-1), None)),
            (0xffff_ff80, Kind::I8, (signed(-128), None)),
            (0xffff_ff7f, Kind::I8, (None, None)),
            (0x8000, Kind::U16, (unsigned(0x8000), None)),
            (1e10_f32.to_bits(), Kind::I64, (None, signed(10_000_000_000))),
            (f32::MAX.to_bits(), Kind::U64, (None, None)),
            (f32::INFINITY.to_bits(), Kind::U64, (None, None)),
        ] {
            assert_eq!((bytewise(bits, ty), cast(f32::from_bits(bits), ty)), expected, "{bits:#x} as {ty}");
        }
    }
}
