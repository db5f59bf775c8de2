//! One line of a `.msg` file, without its comment.

use super::scalar::Scalar;
use super::syntax::{Comment, ConstantSyntax, FieldSyntax};
use crate::decimal::is_digits;
use crate::diag::{Code, Diagnostic};
use crate::source::{Part, Spanned};

/// What a line says; comments have still to be put to it.
pub(super) enum Statement {
    /// `TYPE NAME` or `TYPE[N] NAME`
    Field(FieldSyntax),
    /// `TYPE NAME = VALUE`
    Constant(ConstantSyntax),
}

/// Reads a line that is not blank.
pub(super) fn read(line: Part<'_>) -> Result<Statement, Diagnostic> {
    let line = line.trimmed();
    let Some((ty, rest)) = line.split_once(char::is_whitespace) else {
        return Err(problem(line, Code::UorbLine, format!("`{}` stands alone", line.text)).help(FORM));
    };
    if line.after(ty.text.len()).text.starts_with('\t') {
        let help = "write one space: PX4's generator does not take a tab here";
        return Err(problem(line, Code::UorbLine, "a tab between type and name").help(help));
    }
    let (element, array) = element(ty)?;
    let comment = Comment::default();
    let Some((name, value)) = rest.split_once(|letter| letter == '=') else {
        let name = rest.trimmed();
        check_name(name, |letter| letter.is_ascii_lowercase() || letter.is_ascii_digit())?;
        let (element, name) = (element.to_spanned(), name.to_spanned());
        return Ok(Statement::Field(FieldSyntax { element, array, name, comment }));
    };
    let (name, value) = (name.trimmed(), value.trimmed());
    check_name(name, char::is_alphanumeric)?;
    if let Some(array) = array {
        return Err(Diagnostic::new(Code::UorbConstant, array.span, "a constant cannot be an array"));
    }
    let value = Spanned::new(number(element.text, value)?, value.span());
    Ok(Statement::Constant(ConstantSyntax { element: element.to_spanned(), name: name.to_spanned(), value, comment }))
}

const FORM: &str = "a line is `TYPE NAME`, `TYPE[N] NAME`, `TYPE NAME = NUMBER`, or a comment behind `#`";

/// Takes a type apart: `float32[3]`.
fn element(ty: Part<'_>) -> Result<(Part<'_>, Option<Spanned<u16>>), Diagnostic> {
    let Some((element, length)) = ty.split_once(|letter| letter == '[') else { return Ok((ty, None)) };
    let bad =
        |what: &str| problem(ty, Code::UorbArray, what).help("write the number of elements, 1 to 65535: `float32[3]`");
    let digits = length.text.strip_suffix(']').ok_or_else(|| bad("the brackets of an array are not closed"))?;
    if digits.is_empty() || digits.starts_with("<=") {
        return Err(bad("an array without a fixed length"));
    }
    match digits.parse() {
        Ok(length) if is_digits(digits) && length > 0 => Ok((element, Some(Spanned::new(length, ty.span())))),
        _ => Err(bad(&format!("an array of `{digits}` elements"))),
    }
}

/// Names have letters, digits and underscores, and begin with a letter.
fn check_name(name: Part<'_>, may_have: impl Fn(char) -> bool) -> Result<(), Diagnostic> {
    let text = name.text;
    if text.split_whitespace().nth(1).is_some() {
        return Err(problem(name, Code::UorbLine, format!("`{text}` is more than a name")).help(FORM));
    }
    if text.starts_with(|letter: char| letter.is_ascii_alphabetic())
        && text.is_ascii()
        && text.chars().all(|l| l == '_' || may_have(l))
    {
        return Ok(());
    }
    let help = "names of fields have small letters, digits and underscores, and begin with a letter; those of constants may have capitals";
    Err(problem(name, Code::UorbName, format!("`{text}` is not a name")).help(help))
}

/// The value of a constant of this type.
fn number(element: &str, value: Part<'_>) -> Result<i128, Diagnostic> {
    let text = value.text;
    let bad = |message: &str, help: &str| Err(problem(value, Code::UorbConstant, message).help(help));
    let scalar = Scalar::of(element);
    let range = match scalar.map(Scalar::range) {
        Some(Some(range)) => range,
        Some(None) => {
            let message = format!("a constant of type `{element}`");
            return bad(&message, "constants are integers: PX4's generator cuts others to an integer, or refuses them");
        }
        // What it is instead is told where the type is looked up.
        None => i128::MIN..=i128::MAX,
    };
    let decimal = "write a whole decimal number: `3`, `-1`";
    let digits = text.strip_prefix('-').unwrap_or(text);
    if text.is_empty() {
        return bad("a constant without a value", decimal);
    }
    if !is_digits(digits) {
        return bad(&format!("`{text}` is not a whole number"), decimal);
    }
    if digits.len() > 1 && digits.starts_with('0') {
        let help = "leave the zeros in front out: PX4 reads 10 there, ROS reads 8";
        return bad(&format!("`{text}` means two numbers"), help);
    }
    match text.parse() {
        Ok(number) if range.contains(&number) => Ok(number),
        _ => bad(
            &format!("{text} does not fit into `{element}`"),
            &format!("it holds {} to {}", range.start(), range.end()),
        ),
    }
}

fn problem(part: Part<'_>, code: Code, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(code, part.span(), message)
}
