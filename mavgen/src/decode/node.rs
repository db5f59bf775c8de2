//! What a tree of values is made of.

use mavlink_wire::reflect::Number;

use super::Ratio;

/// A name with its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// As the XML or the overlay spells it.
    pub name: String,
    /// The unit, as the XML or the overlay spells it.
    pub units: Option<String>,
    /// What it holds.
    pub node: Node,
}

impl Entry {
    /// One without a unit.
    pub(super) fn of(name: impl Into<String>, node: Node) -> Self {
        Self { name: name.into(), units: None, node }
    }
}

/// A value, or a collection of them.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// The sender does not know it.
    Unknown,
    /// A secret key, which is not shown.
    Secret,
    /// A whole number that is not negative.
    Unsigned(u128),
    /// A whole number of a signed type.
    Signed(i128),
    /// A `float`.
    Float(f32),
    /// A `double`.
    Double(f64),
    /// A number that packed bits stand for.
    Scaled(Ratio),
    /// Yes or no.
    Flag(bool),
    /// An enum's entry by name.
    Name(String),
    /// Flags by name, `A | B | 0x40`; empty for none.
    Flags(String),
    /// The byte of a `char`.
    Char(u8),
    /// All bytes of an array of `char`: text up to the first NUL, perhaps not UTF-8.
    Text(Vec<u8>),
    /// An array.
    List(Vec<Node>),
    /// A slot, or the members of a view.
    Record(Vec<Entry>),
}

/// The value of a number.
pub(super) fn number(number: Number) -> Node {
    match number {
        Number::U64(value) => Node::Unsigned(value.into()),
        Number::I64(value) => Node::Signed(value.into()),
        Number::F32(value) => Node::Float(value),
        Number::F64(value) => Node::Double(value),
    }
}
