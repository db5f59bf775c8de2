//! Values of parameters: every type in both encodings arrives as the same number, or not at all.

use mavlink_services::common::{MavAutopilot, MavParamType, MavProtocolCapability};
use mavlink_services::param::{Encoding, ParamValue, ValueError};

/// Numbers at the edges of every type, and of the mantissas.
fn integers() -> Vec<i128> {
    let edges =
        [0, 1, 5, 100, 1 << 7, 1 << 8, 1 << 15, 1 << 16, 1 << 23, 1 << 24, 1 << 25, 1 << 31, 1 << 32, 1 << 53, 1 << 54];
    let mut integers =
        vec![i128::from(i64::MAX), i128::from(i64::MIN), i128::from(u64::MAX), 123_456_789, -123_456_789];
    for edge in edges {
        integers.extend([edge - 1, edge, edge + 1, -edge - 1, -edge, 1 - edge]);
    }
    integers
}

/// A value of each integer type that can hold the number.
fn values(number: i128) -> Vec<ParamValue> {
    let mut values = vec![];
    values.extend(u8::try_from(number).map(ParamValue::U8));
    values.extend(i8::try_from(number).map(ParamValue::I8));
    values.extend(u16::try_from(number).map(ParamValue::U16));
    values.extend(i16::try_from(number).map(ParamValue::I16));
    values.extend(u32::try_from(number).map(ParamValue::U32));
    values.extend(i32::try_from(number).map(ParamValue::I32));
    values.extend(u64::try_from(number).map(ParamValue::U64));
    values.extend(i64::try_from(number).map(ParamValue::I64));
    values
}

#[test]
fn an_integer_arrives_as_itself_or_is_an_error() {
    for number in integers() {
        for value in values(number) {
            let cast = Encoding::Cast.encode(value);
            // What Rust's own conversion says.
            let fits = (number as f32) as i128 == number;
            assert_eq!(cast, if fits { Ok(number as f32) } else { Err(ValueError::Inexact) }, "{value:?}");
            if let Ok(field) = cast {
                assert_eq!(Encoding::Cast.decode(field, value.kind()), Ok(value));
            }
            let bytes = Encoding::Bytewise.encode(value);
            let wide = [MavParamType::UINT64, MavParamType::INT64].contains(&value.kind());
            assert_eq!(
                bytes.and_then(|field| Encoding::Bytewise.decode(field, value.kind())),
                if wide { Err(ValueError::TooWide) } else { Ok(value) }
            );
        }
    }
}

#[test]
fn a_value_of_another_type_is_the_same_number() {
    let kinds = || (1..=10).map(MavParamType);
    for number in integers() {
        for value in values(number) {
            for kind in kinds() {
                let other = value.to_kind(kind);
                let expected = match kind {
                    MavParamType::REAL32 => {
                        ((number as f32) as i128 == number).then_some(ParamValue::F32(number as f32))
                    }
                    MavParamType::REAL64 => {
                        ((number as f64) as i128 == number).then_some(ParamValue::F64(number as f64))
                    }
                    kind => values(number).into_iter().find(|value| value.kind() == kind),
                };
                assert_eq!(other.ok(), expected, "{value:?} as {kind}");
                if let Ok(other) = other {
                    assert_eq!(other.to_kind(value.kind()), Ok(value), "{value:?} as {kind} and back");
                }
            }
        }
    }
}

#[test]
fn floats_become_integers_only_if_they_are_some() {
    let floats = [0.5, -0.5, 1.5, 16_777_215.0, 4_294_967_040.0, 4_294_967_296.0, 1e10, 1e30, -1.0, 1e-40, 5e-39, -0.0];
    for float in floats {
        for kind in (1..=8).map(MavParamType) {
            let exact = float as f64;
            let expected = if exact.fract() == 0.0 {
                values(exact as i128).into_iter().find(|value| value.kind() == kind)
            } else {
                None
            };
            assert_eq!(ParamValue::F32(float).to_kind(kind).ok(), expected, "{float} as {kind}");
            assert_eq!(ParamValue::F64(exact).to_kind(kind).ok(), expected, "{float} as {kind}");
        }
    }
    for nothing in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(i32::try_from(ParamValue::F32(nothing)), Err(ValueError::NotAnInteger));
        assert_eq!(i64::try_from(ParamValue::F64(nothing.into())), Err(ValueError::NotAnInteger));
    }
    assert_eq!(f32::try_from(ParamValue::F64(0.1)), Ok(0.1));
    assert_eq!(f32::try_from(ParamValue::F64(1e300)), Err(ValueError::OutOfRange));
    assert_eq!(f32::try_from(ParamValue::F64(f64::INFINITY)), Ok(f32::INFINITY));
    assert_eq!(u64::try_from(ParamValue::F32(18_446_744_073_709_551_616.0)), Err(ValueError::OutOfRange));
    assert_eq!(i64::try_from(ParamValue::F32(-9_223_372_036_854_775_808.0)), Ok(i64::MIN));
}

#[test]
fn bytes_of_a_float_survive_whatever_they_are() {
    for bits in [0, 1, 0x7fa0_0001, 0xffff_fffe, 0xffc0_0000] {
        let field = Encoding::Bytewise.encode(ParamValue::U32(bits)).map(f32::to_bits);
        assert_eq!(field, Ok(bits));
        assert_eq!(
            Encoding::Bytewise.decode(f32::from_bits(bits), MavParamType::INT32),
            Ok(ParamValue::I32(bits.cast_signed()))
        );
    }
    for kind in [0, 11, 255].map(MavParamType) {
        for encoding in [Encoding::Bytewise, Encoding::Cast] {
            assert_eq!(encoding.decode(1.0, kind), Err(ValueError::UnknownType(kind)));
        }
    }
}

#[test]
fn the_encoding_is_what_the_capabilities_say_or_else_the_autopilot() {
    const BYTEWISE: MavProtocolCapability = MavProtocolCapability::PARAM_ENCODE_BYTEWISE;
    const CAST: MavProtocolCapability = MavProtocolCapability::PARAM_ENCODE_C_CAST;
    let both = BYTEWISE | CAST;
    let neither = MavProtocolCapability::MISSION_INT;
    for (capabilities, autopilot, expected) in [
        (Some(BYTEWISE), MavAutopilot::ARDUPILOTMEGA, Encoding::Bytewise),
        (Some(CAST), MavAutopilot::PX4, Encoding::Cast),
        (Some(both), MavAutopilot::PX4, Encoding::Bytewise),
        (Some(both), MavAutopilot::ARDUPILOTMEGA, Encoding::Cast),
        (Some(neither), MavAutopilot::ARDUPILOTMEGA, Encoding::Cast),
        (None, MavAutopilot::ARDUPILOTMEGA, Encoding::Cast),
        (None, MavAutopilot::PX4, Encoding::Bytewise),
        (None, MavAutopilot::GENERIC, Encoding::Bytewise),
    ] {
        assert_eq!(Encoding::of(capabilities, autopilot), expected, "{capabilities:?} {autopilot}");
    }
}
