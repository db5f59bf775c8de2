//! Fields, and the elements of arrays.

use core::fmt;

use super::Number;
use crate::message::chars;
use crate::{EnumInfo, FieldInfo, Invalid, Kind};

/// The text for what the sender does not know.
const UNKNOWN: &str = "unknown";
/// The text for a secret key.
const SECRET: &str = "secret";

/// A field of a message, with its value.
#[derive(Clone, Copy, Debug)]
pub struct Field<'a> {
    info: &'a FieldInfo,
    payload: &'a [u8],
}

/// What a field holds.
#[derive(Clone, Debug)]
pub enum Value<'a> {
    /// A number that is no array.
    One(Element<'a>),
    /// `char` and `char[N]`: the bytes up to the first NUL.
    Text(&'a [u8]),
    /// An array of numbers.
    Array(Elements<'a>),
}

impl<'a> Field<'a> {
    pub(super) const fn new(info: &'a FieldInfo, payload: &'a [u8]) -> Self {
        Self { info, payload }
    }

    /// Name, type, place, unit and enum.
    #[must_use]
    pub const fn info(&self) -> &'a FieldInfo {
        self.info
    }

    /// What the field holds, be it [secret](FieldInfo::secret).
    #[must_use]
    pub fn value(&self) -> Value<'a> {
        match (self.info.kind, self.info.array) {
            (Kind::Char, _) => Value::Text(self.text()),
            (_, Some(_)) => Value::Array(self.elements()),
            (_, None) => Value::One(Element { field: *self, index: 0 }),
        }
    }

    /// The elements of an array, or the one number of a field that is none. Of a text, its bytes.
    #[must_use]
    pub fn elements(&self) -> Elements<'a> {
        Elements { field: *self, next: 0, end: self.info.array.unwrap_or(1) }
    }

    /// An element of an array; 0 is the number of a field that is no array. `None` where there is no such element.
    #[must_use]
    pub fn element(&self, index: usize) -> Option<Element<'a>> {
        let index = u8::try_from(index).ok()?;
        if index < self.info.array.unwrap_or(1) { Some(Element { field: *self, index }) } else { None }
    }

    /// Whether the field as a whole is not known: a number that is its sentinel, or an array or a text whose first element
    /// says so for all ([`Invalid::All`]).
    ///
    /// Elements of an array that speak for themselves are asked for themselves: [`Element::is_invalid`].
    #[must_use]
    pub fn is_invalid(&self) -> bool {
        match (self.info.invalid, self.info.array) {
            (Some(Invalid::Each(sentinel) | Invalid::First(sentinel)), None) => self.number(0).is(sentinel),
            (Some(Invalid::All(sentinel)), _) => self.number(0).is(sentinel),
            _ => false,
        }
    }

    fn number(&self, index: u8) -> Number {
        let offset = usize::from(self.info.offset) + usize::from(index) * self.info.kind.size();
        Number::read(self.info.kind, self.payload, offset)
    }

    /// The bytes up to the first NUL; behind the end of the payload there are only NULs.
    fn text(&self) -> &'a [u8] {
        let start = usize::from(self.info.offset).min(self.payload.len());
        let there = self.payload.get(start..).unwrap_or_default();
        let field = there.get(..self.info.size()).unwrap_or(there);
        field.split(|&byte| byte == 0).next().unwrap_or_default()
    }
}

/// The value as [a message's text](super#the-text) has it.
impl fmt::Display for Field<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.info.secret {
            return f.write_str(SECRET);
        }
        if self.is_invalid() {
            return f.write_str(UNKNOWN);
        }
        let units = match self.value() {
            Value::Text(bytes) => {
                chars::debug(bytes, f)?;
                None
            }
            Value::One(element) => {
                write!(f, "{element}")?;
                self.info.units
            }
            Value::Array(elements) => {
                let mut separator = "[";
                for element in elements {
                    write!(f, "{separator}{element}")?;
                    separator = ", ";
                }
                f.write_str("]")?;
                self.info.units
            }
        };
        // A name needs no unit, even where the XML has one.
        match (units, self.info.values) {
            (Some(units), None) => write!(f, " {units}"),
            _ => Ok(()),
        }
    }
}

/// The value as `Debug` has it: numbers as they are, without units and without a word for those that are not known.
pub(super) struct Plain<'a>(pub(super) Field<'a>);

impl fmt::Debug for Plain<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.info.secret {
            return fmt::Debug::fmt(SECRET, f);
        }
        match self.0.value() {
            Value::Text(bytes) => chars::debug(bytes, f),
            Value::One(element) => PlainElement(element).fmt(f),
            Value::Array(elements) => f.debug_list().entries(elements.map(PlainElement)).finish(),
        }
    }
}

struct PlainElement<'a>(Element<'a>);

impl fmt::Debug for PlainElement<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.0.entry(), self.0.number()) {
            (Some((values, value)), _) => fmt::Display::fmt(&values.display(value), f),
            (None, Number::U64(number)) => fmt::Debug::fmt(&number, f),
            (None, Number::I64(number)) => fmt::Debug::fmt(&number, f),
            (None, Number::F32(number)) => fmt::Debug::fmt(&number, f),
            (None, Number::F64(number)) => fmt::Debug::fmt(&number, f),
        }
    }
}

/// An element of an array, or the one number of a field that is none.
#[derive(Clone, Copy, Debug)]
pub struct Element<'a> {
    field: Field<'a>,
    index: u8,
}

impl<'a> Element<'a> {
    /// The field's metadata.
    #[must_use]
    pub const fn info(&self) -> &'a FieldInfo {
        self.field.info
    }

    /// Its place in the array, from 0.
    #[must_use]
    pub const fn index(&self) -> usize {
        self.index as usize
    }

    /// The number.
    #[must_use]
    pub fn number(&self) -> Number {
        self.field.number(self.index)
    }

    /// Whether the sender does not know it.
    #[must_use]
    pub fn is_invalid(&self) -> bool {
        match self.field.info.invalid {
            Some(Invalid::Each(sentinel)) => self.number().is(sentinel),
            Some(Invalid::First(sentinel)) => self.index == 0 && self.number().is(sentinel),
            Some(Invalid::All(_)) => self.field.is_invalid(),
            None => false,
        }
    }

    /// The enum that lists its values or bits, and the value in it; `None` where there is none, and for numbers that no enum
    /// can have, which are negative ones.
    #[must_use]
    pub fn entry(&self) -> Option<(&'static EnumInfo, u64)> {
        let value = u64::try_from(self.number().as_integer()?).ok()?;
        Some((self.field.info.values?, value))
    }
}

/// The number, the name of the entry, or the names of the flags; `unknown` or `secret` where it is.
impl fmt::Display for Element<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.entry() {
            _ if self.info().secret => f.write_str(SECRET),
            _ if self.is_invalid() => f.write_str(UNKNOWN),
            Some((values, value)) => values.display(value).fmt(f),
            None => self.number().fmt(f),
        }
    }
}

/// Iterator over the elements of a field.
#[derive(Clone, Debug)]
pub struct Elements<'a> {
    field: Field<'a>,
    next: u8,
    end: u8,
}

impl<'a> Iterator for Elements<'a> {
    type Item = Element<'a>;

    fn next(&mut self) -> Option<Element<'a>> {
        let element = self.field.element(self.next.into())?;
        self.next += 1;
        Some(element)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = usize::from(self.end.saturating_sub(self.next));
        (left, Some(left))
    }
}

impl ExactSizeIterator for Elements<'_> {}
