//! The values of constants.

use super::line::Piece;
use super::scalar::Scalar;
use crate::decimal::is_digits;
use crate::diag::{Code, Diagnostic};

/// The value of a constant of this type.
pub(super) fn read(element: &str, value: Piece<'_>) -> Result<i128, Diagnostic> {
    let text = value.text;
    let bad = |message: String, help: &str| Err(Diagnostic::new(Code::UorbConstant, value.span(), message).help(help));
    let decimal = "write a whole decimal number: `3`, `-1`";
    let range = match Scalar::of(element).map(|scalar| (scalar, scalar.range())) {
        Some((_, Some(range))) => range,
        Some((scalar, None)) => {
            let message = format!("a constant of type `{}`", scalar.name());
            return bad(message, "constants are integers: PX4's generator cuts others to an integer, or refuses them");
        }
        // What it is instead is told where the type is looked up.
        None => i128::MIN..=i128::MAX,
    };
    let digits = text.strip_prefix('-').unwrap_or(text);
    if !is_digits(digits) {
        return bad(
            if text.is_empty() {
                "a constant without a value".into()
            } else {
                format!("`{text}` is not a whole number")
            },
            decimal,
        );
    }
    if digits.len() > 1 && digits.starts_with('0') {
        let help = "leave the zeros in front out: PX4 reads 10 there, ROS reads 8";
        return bad(format!("`{text}` means two numbers"), help);
    }
    match text.parse::<i128>() {
        Ok(number) if range.contains(&number) => Ok(number),
        _ => bad(
            format!("{text} does not fit into `{element}`"),
            &format!("it holds {} to {}", range.start(), range.end()),
        ),
    }
}
