//! Numbers of any type, and whether another type can hold them.
//!
//! Works on the bits: small machines have no unit for floats, and what is said here has to be exact.

use super::{ParamValue, ValueError};

/// A number.
#[derive(Clone, Copy)]
pub(super) enum Number {
    Integer { negative: bool, magnitude: u64 },
    Single(f32),
    Double(f64),
}

impl From<ParamValue> for Number {
    fn from(value: ParamValue) -> Self {
        match value {
            ParamValue::U8(value) => Self::unsigned(value.into()),
            ParamValue::I8(value) => Self::signed(value.into()),
            ParamValue::U16(value) => Self::unsigned(value.into()),
            ParamValue::I16(value) => Self::signed(value.into()),
            ParamValue::U32(value) => Self::unsigned(value.into()),
            ParamValue::I32(value) => Self::signed(value.into()),
            ParamValue::U64(value) => Self::unsigned(value),
            ParamValue::I64(value) => Self::signed(value),
            ParamValue::F32(value) => Self::Single(value),
            ParamValue::F64(value) => Self::Double(value),
        }
    }
}

impl Number {
    fn unsigned(magnitude: u64) -> Self {
        Self::Integer { negative: false, magnitude }
    }

    fn signed(value: i64) -> Self {
        Self::Integer { negative: value < 0, magnitude: value.unsigned_abs() }
    }

    /// As an integer of some type.
    pub(super) fn integer<T: TryFrom<u64> + TryFrom<i64>>(self) -> Result<T, ValueError> {
        let (negative, magnitude) = match self {
            Self::Integer { negative, magnitude } => (negative, magnitude),
            Self::Single(value) => whole(Float::of_single(value))?,
            Self::Double(value) => whole(Float::of_double(value))?,
        };
        if negative {
            let value = 0_i64.checked_sub_unsigned(magnitude).ok_or(ValueError::OutOfRange)?;
            return T::try_from(value).map_err(|_| ValueError::OutOfRange);
        }
        T::try_from(magnitude).map_err(|_| ValueError::OutOfRange)
    }

    /// As an `f32`: the same integer, or the nearest real.
    pub(super) fn f32(self) -> Result<f32, ValueError> {
        match self {
            Self::Integer { negative, magnitude } if digits(magnitude) <= f32::MANTISSA_DIGITS => {
                let value = magnitude as f32;
                Ok(if negative { -value } else { value })
            }
            Self::Integer { .. } => Err(ValueError::Inexact),
            Self::Single(value) => Ok(value),
            Self::Double(value) => {
                let nearest = value as f32;
                if nearest.is_infinite() && value.is_finite() { Err(ValueError::OutOfRange) } else { Ok(nearest) }
            }
        }
    }

    /// As an `f64`: the same number.
    pub(super) fn f64(self) -> Result<f64, ValueError> {
        match self {
            Self::Integer { negative, magnitude } if digits(magnitude) <= f64::MANTISSA_DIGITS => {
                let value = magnitude as f64;
                Ok(if negative { -value } else { value })
            }
            Self::Integer { .. } => Err(ValueError::Inexact),
            Self::Single(value) => Ok(value.into()),
            Self::Double(value) => Ok(value),
        }
    }
}

/// Binary digits from the first to the last one that is set.
fn digits(magnitude: u64) -> u32 {
    u64::BITS.saturating_sub(magnitude.leading_zeros()).saturating_sub(magnitude.trailing_zeros())
}

/// A finite float: mantissa times two to the power of the exponent.
struct Float {
    negative: bool,
    mantissa: u64,
    exponent: i32,
}

impl Float {
    fn of_single(value: f32) -> Option<Self> {
        let bits = value.to_bits();
        Self::of(value.is_sign_negative(), u64::from(bits & 0x007f_ffff), (bits >> 23 & 0xff) as i32, (23, 0xff))
    }

    fn of_double(value: f64) -> Option<Self> {
        let bits = value.to_bits();
        Self::of(value.is_sign_negative(), bits & 0x000f_ffff_ffff_ffff, (bits >> 52 & 0x7ff) as i32, (52, 0x7ff))
    }

    /// Of the fields of an IEEE float whose mantissa has so many bits and whose exponent is at most this.
    fn of(negative: bool, mantissa: u64, exponent: i32, (bits, all): (u32, i32)) -> Option<Self> {
        if exponent == all {
            return None;
        }
        let hidden = if exponent == 0 { 0 } else { 1 << bits };
        Some(Self { negative, mantissa: mantissa | hidden, exponent: exponent.max(1) - all / 2 - bits as i32 })
    }
}

/// Sign and magnitude of a float that is an integer.
fn whole(float: Option<Float>) -> Result<(bool, u64), ValueError> {
    let Float { negative, mantissa, exponent } = float.ok_or(ValueError::NotAnInteger)?;
    let spare = mantissa.trailing_zeros();
    if mantissa == 0 {
        Ok((false, 0))
    } else if exponent < 0 {
        let places = exponent.unsigned_abs();
        if places > spare { Err(ValueError::NotAnInteger) } else { Ok((negative, mantissa >> places)) }
    } else if exponent.unsigned_abs() > mantissa.leading_zeros() {
        Err(ValueError::OutOfRange)
    } else {
        Ok((negative, mantissa << exponent))
    }
}
