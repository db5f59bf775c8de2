//! One line of a `.msg` file, without its comment.

use std::ops::Range;

use super::constant;
use crate::decimal::is_digits;
use crate::diag::{Code, Diagnostic};
use crate::source::{FileId, Span, Spanned};

/// What a line says.
pub(super) enum Statement {
    /// `TYPE NAME` or `TYPE[N] NAME`
    Field { element: Spanned<String>, array: Option<Spanned<u16>>, name: Spanned<String> },
    /// `TYPE NAME = VALUE`
    Constant { element: Spanned<String>, name: Spanned<String>, value: Spanned<i128> },
}

/// A part of a line that knows where it stands.
#[derive(Clone, Copy)]
pub(super) struct Piece<'t> {
    pub(super) file: FileId,
    pub(super) text: &'t str,
    pub(super) start: usize,
}

impl<'t> Piece<'t> {
    fn part(self, range: Range<usize>) -> Self {
        Self { text: self.text.get(range.clone()).unwrap_or_default(), start: self.start + range.start, ..self }
    }

    pub(super) fn trimmed(self) -> Self {
        let start = self.text.len() - self.text.trim_start().len();
        self.part(start..start + self.text.trim().len())
    }

    /// What stands before and behind the first of these characters.
    fn split_at(self, stop: impl Fn(char) -> bool) -> Option<(Self, Self)> {
        let at = self.text.find(stop)?;
        let behind = at + self.text.get(at..)?.chars().next()?.len_utf8();
        Some((self.part(0..at), self.part(behind..self.text.len())))
    }

    pub(super) fn span(self) -> Span {
        Span::new(self.file, self.start..self.start + self.text.len())
    }

    fn spanned(self) -> Spanned<String> {
        Spanned::new(self.text.to_owned(), self.span())
    }

    fn problem(self, code: Code, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(code, self.span(), message)
    }
}

/// Reads a line that is not blank.
pub(super) fn read(line: Piece<'_>) -> Result<Statement, Diagnostic> {
    let line = line.trimmed();
    let Some((ty, rest)) = line.split_at(char::is_whitespace) else {
        return Err(line.problem(Code::UorbLine, format!("`{}` stands alone", line.text)).help(FORM));
    };
    if line.text.get(ty.text.len()..).is_some_and(|rest| rest.starts_with('\t')) {
        let help = "write one space: PX4's generator does not take a tab here";
        return Err(line.problem(Code::UorbLine, "a tab between type and name").help(help));
    }
    let (element, array) = element(ty)?;
    match rest.split_at(|letter| letter == '=') {
        Some((name, value)) => {
            let name = name.trimmed();
            check_name(name, char::is_alphanumeric)?;
            if let Some(array) = array {
                let message = "a constant cannot be an array";
                return Err(Diagnostic::new(Code::UorbConstant, array.span, message));
            }
            let value = Spanned::new(constant::read(element.text, value.trimmed())?, value.trimmed().span());
            Ok(Statement::Constant { element: element.spanned(), name: name.spanned(), value })
        }
        None => {
            let name = rest.trimmed();
            check_name(name, |letter| letter.is_ascii_lowercase() || letter.is_ascii_digit())?;
            Ok(Statement::Field { element: element.spanned(), array, name: name.spanned() })
        }
    }
}

const FORM: &str = "a line is `TYPE NAME`, `TYPE[N] NAME`, `TYPE NAME = NUMBER`, or a comment behind `#`";

/// Takes a type apart: `float32[3]`.
fn element(ty: Piece<'_>) -> Result<(Piece<'_>, Option<Spanned<u16>>), Diagnostic> {
    let Some((element, length)) = ty.split_at(|letter| letter == '[') else { return Ok((ty, None)) };
    let bad =
        |what: &str| ty.problem(Code::UorbArray, what).help("write the number of elements, 1 to 65535: `float32[3]`");
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
fn check_name(name: Piece<'_>, may_have: impl Fn(char) -> bool) -> Result<(), Diagnostic> {
    let text = name.text;
    if text.split_whitespace().nth(1).is_some() {
        return Err(name.problem(Code::UorbLine, format!("`{text}` is more than a name")).help(FORM));
    }
    if text.starts_with(|letter: char| letter.is_ascii_alphabetic())
        && text.is_ascii()
        && text.chars().all(|l| l == '_' || may_have(l))
    {
        return Ok(());
    }
    let help = "names of fields have small letters, digits and underscores, and begin with a letter; those of constants may have capitals";
    Err(name.problem(Code::UorbName, format!("`{text}` is not a name")).help(help))
}
