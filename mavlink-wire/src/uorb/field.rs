//! What a generated topic says of its fields: names and types, flat, for binding by name.

use super::Kind;

/// A field of a topic or of a message nested in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    /// Name in the `.msg` file.
    pub name: &'static str,
    /// The name that it had in older definitions, if it was renamed.
    pub was: Option<&'static str>,
    /// Its type.
    pub element: Element,
    /// Elements: 1 for a scalar.
    pub len: u16,
    /// Whether it is an array, also of one element.
    pub array: bool,
}

impl Field {
    /// A scalar.
    #[must_use]
    pub const fn new(name: &'static str, kind: Kind) -> Self {
        Self { name, was: None, element: Element::Scalar(kind), len: 1, array: false }
    }

    /// A nested message.
    #[must_use]
    pub const fn nested(name: &'static str, message: &'static str, fields: &'static [Self]) -> Self {
        Self { name, was: None, element: Element::Message { name: message, fields }, len: 1, array: false }
    }

    /// The same as an array.
    #[must_use]
    pub const fn array(self, len: u16) -> Self {
        Self { len, array: true, ..self }
    }

    /// The same, which had another name in older definitions.
    #[must_use]
    pub const fn was(self, name: &'static str) -> Self {
        Self { was: Some(name), ..self }
    }

    /// Whether a log's name for a field means this one.
    pub(crate) fn is_called(&self, name: &str) -> bool {
        self.name == name || self.was == Some(name)
    }
}

/// The type of a field's elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// A number, `bool` or `char`.
    Scalar(Kind),
    /// Another message, nested.
    Message {
        /// Its name, `EscReport`.
        name: &'static str,
        /// Its fields.
        fields: &'static [Field],
    },
}

/// How many [`Place`](super::Place)s a topic of these fields takes: one each, and those of what it nests.
#[must_use]
pub const fn places(fields: &[Field]) -> usize {
    let (mut rest, mut count) = (fields, fields.len());
    while let [field, others @ ..] = rest {
        if let Element::Message { fields, .. } = field.element {
            count += places(fields);
        }
        rest = others;
    }
    count
}
