//! Exact values of scaled bits.

use std::fmt;

use crate::ir::Scaled;

/// At most so many digits behind the point are looked for to show every value of a fraction.
const MOST_DIGITS: u32 = 6;

/// Digits behind the point where no number of them shows every value.
const INEXACT_DIGITS: usize = 2;

/// A fraction: what scaled bits stand for, before anything is rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ratio {
    /// raw · factor + bias.
    pub numerator: i128,
    /// At least 1.
    pub divisor: i64,
}

impl Ratio {
    /// The value that a raw number of at most 64 bits stands for.
    #[must_use]
    pub fn of(raw: i128, scaled: &Scaled) -> Self {
        // 64 bits times 63 bits and one more addend: nothing saturates.
        let product = raw.saturating_mul(scaled.factor.into());
        Self { numerator: product.saturating_add(scaled.bias.into()), divisor: scaled.divisor }
    }

    /// The nearest double, where the numerator is below 2^53; else one beside it.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        self.numerator as f64 / self.divisor as f64
    }

    /// Digits behind the point that show every value of this divisor, or two where no number of them does.
    fn digits(self) -> usize {
        let ends = |digits: &u32| 10_i64.pow(*digits) % self.divisor.max(1) == 0;
        (0..=MOST_DIGITS).find(ends).map_or(INEXACT_DIGITS, |digits| digits as usize)
    }
}

/// In decimal, with as many digits as the divisor needs, or rounded to two: what `Debug` of generated views prints.
impl fmt::Display for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = self.digits();
        write!(f, "{:.digits$}", self.to_f64())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scaled(factor: i64, bias: i64, divisor: i64) -> Scaled {
        Scaled { factor, bias, divisor, units: None, exact: None }
    }

    #[test]
    fn exact_and_shown() {
        for (raw, (factor, bias, divisor), value, shown) in [
            (1234, (1, 0, 100), 12.34, "12.34"),
            (0, (1, -128, 4), -32.0, "-32.00"),
            (129, (1, -128, 4), 0.25, "0.25"),
            (255, (20, 0, 51), 100.0, "100.00"),
            (1, (20, 0, 51), 20.0 / 51.0, "0.39"),
            (-3, (5, 0, 1), -15.0, "-15"),
            (7, (1, 0, 8), 0.875, "0.875"),
            (1, (1, 0, 10_000_000), 1e-7, "0.00"),
        ] {
            let ratio = Ratio::of(raw, &scaled(factor, bias, divisor));
            assert_eq!((ratio.to_f64(), ratio.to_string().as_str()), (value, shown), "{ratio:?}");
        }
    }

    #[test]
    fn the_largest_numbers_do_not_overflow() {
        for (raw, factor) in
            [(i128::from(u64::MAX), i64::MIN), (i128::from(u64::MAX), i64::MAX), (i64::MIN.into(), i64::MIN)]
        {
            let (plus, minus) =
                (Ratio::of(raw, &scaled(factor, i64::MAX, 1)), Ratio::of(raw, &scaled(factor, i64::MIN, 1)));
            assert_eq!(plus.numerator - minus.numerator, i128::from(u64::MAX));
        }
    }
}
