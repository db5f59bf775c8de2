//! What a generated topic says of its fields: names and types, flat, for binding by name.

use super::{Kind, Member};
use crate::message::record::plain_name;

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
    /// A field of this name in Rust, and of the type of this value.
    #[must_use]
    pub const fn like<M: Member>(name: &'static str, _: &M) -> Self {
        let (len, array) = match M::LEN {
            Some(len) => (len, true),
            None => (1, false),
        };
        Self { name: plain_name(name), was: None, element: M::ELEMENT, len, array }
    }

    /// The same, whose name in the `.msg` file is another than in Rust.
    #[must_use]
    pub const fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
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
        count += field.element.places();
        rest = others;
    }
    count
}
