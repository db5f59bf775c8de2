//! From values to the raw numbers that packed bits hold.

/// The raw number for `value` = (raw · `factor` + `bias`) / `divisor`, rounded to the nearest, halves up.
///
/// `None` for NaN, infinities and what an `i64` cannot hold.
#[must_use]
pub fn raw_of(value: f32, factor: i64, bias: i64, divisor: i64) -> Option<i64> {
    let raw = (f64::from(value) * divisor as f64 - bias as f64) / factor as f64 + 0.5;
    // 2^53: beyond it a double has no fractions, and no packed bits are so wide.
    if raw.is_nan() || raw.abs() >= 9_007_199_254_740_992.0 {
        return None;
    }
    let toward_zero = raw as i64;
    Some(if toward_zero as f64 > raw { toward_zero - 1 } else { toward_zero })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_go_up() {
        for (value, raw) in [(2.4, 2), (2.5, 3), (-2.5, -2), (-2.6, -3), (0.0, 0), (-0.4, 0)] {
            assert_eq!(raw_of(value, 1, 0, 1), Some(raw), "{value}");
        }
        assert_eq!(raw_of(15.12, 1, 0, 100), Some(1512));
        assert_eq!(raw_of(-32.0, 1, -128, 4), Some(0));
        assert_eq!(raw_of(25.0, 1, -128, 4), Some(228));
        assert_eq!(raw_of(50.0, 20, 0, 51), Some(128));
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX] {
            assert_eq!(raw_of(value, 1, 0, 100), None);
        }
    }
}
