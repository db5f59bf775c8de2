//! Floats as text.

use core::fmt;

/// A float with a point or an exponent, as many digits as it takes to read the same float again; a NaN other than the usual one
/// keeps its bits: `NaN(0x7fc00001)`.
pub(crate) struct Exact<T>(pub(crate) T);

impl fmt::Display for Exact<f32> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.to_bits() {
            bits if self.0.is_nan() && bits != f32::NAN.to_bits() => write!(f, "NaN({bits:#010x})"),
            _ => write!(f, "{:?}", self.0),
        }
    }
}

impl fmt::Display for Exact<f64> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.to_bits() {
            bits if self.0.is_nan() && bits != f64::NAN.to_bits() => write!(f, "NaN({bits:#018x})"),
            _ => write!(f, "{:?}", self.0),
        }
    }
}
