//! Views, the slots that messages give them in, and what their methods need.

use std::ops::RangeInclusive;

use super::{Docs, Element, EnumType, Int, Literal, Method, Ty};
use crate::ir::{Exact, Repeat};

/// A view: its types, and what its message gets.
#[derive(Clone, Debug)]
pub(crate) struct View<'d> {
    /// The type over its bits, if it has some.
    pub(crate) packed: Option<Packed<'d>>,
    /// The type of its slots or of its values.
    pub(crate) record: Option<RecordType<'d>>,
    pub(crate) message: &'d str,
    pub(crate) message_methods: Vec<Method<'d>>,
}

/// A type over packed bits.
#[derive(Clone, Debug)]
pub(crate) struct Packed<'d> {
    pub(crate) ident: &'d str,
    pub(crate) docs: Docs<'d>,
    pub(crate) storage: Int,
    /// The switch value that it carries along, and its type.
    pub(crate) switch: Option<(&'d str, Int)>,
    pub(crate) methods: Vec<Method<'d>>,
    pub(crate) debug: Vec<Debugged<'d>>,
}

/// `pub struct Esc { pub id: u8, pub status: Option<Esc32Status> }`
#[derive(Clone, Debug)]
pub(crate) struct RecordType<'d> {
    pub(crate) ident: &'d str,
    pub(crate) docs: Docs<'d>,
    pub(crate) fields: Vec<RecordField<'d>>,
}

/// A public field of a slot or a record of values.
#[derive(Clone, Debug)]
pub(crate) struct RecordField<'d> {
    pub(crate) ident: &'d str,
    pub(crate) ty: Ty<'d>,
    pub(crate) docs: Docs<'d>,
}

/// Named bits of a view.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BitField<'d> {
    /// The integer that holds the bits of the view.
    pub(crate) storage: Int,
    /// The first bit.
    pub(crate) at: u8,
    /// How many bits; with `repeat`, of each.
    pub(crate) width: u8,
    pub(crate) repeat: Option<Repeat>,
    /// The integer of the raw number: the smallest that holds it.
    pub(crate) raw: Int,
    pub(crate) holds: Holds<'d>,
    /// In which layouts the bits are; `None` for all.
    pub(crate) present: Option<Present<'d>>,
}

/// What bits hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Holds<'d> {
    Flag,
    Number,
    Enum(EnumType<'d>),
}

/// The layouts that have some bits: the selector has one of these values.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Present<'d> {
    pub(crate) selector: Selector<'d>,
    pub(crate) ranges: &'d [RangeInclusive<u64>],
}

/// What selects the layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Selector<'d> {
    /// The value that the view carries along.
    Field(&'d str),
    Bits {
        at: u8,
        width: u8,
    },
}

/// A raw number that stands for a value: (raw · `factor` + `bias`) / `divisor`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Scale<'d> {
    pub(crate) bits: BitField<'d>,
    pub(crate) get_raw: String,
    pub(crate) set_raw: String,
    pub(crate) factor: i64,
    pub(crate) bias: i64,
    pub(crate) divisor: i64,
    /// Whether every step is exact in `f32`; else it is done in `f64`.
    pub(crate) in_f32: bool,
    /// The whole number of a smaller unit, and its type.
    pub(crate) exact: Option<(&'d Exact, Int)>,
}

/// A member as `Debug` shows it.
#[derive(Clone, Debug)]
pub(crate) struct Debugged<'d> {
    pub(crate) ident: &'d str,
    pub(crate) units: Option<&'d str>,
    /// How many digits stand behind the point, of a fraction.
    pub(crate) decimals: Option<usize>,
    /// How many there are, if several.
    pub(crate) count: Option<u8>,
    /// Whether the getter gives an `Option`.
    pub(crate) optional: bool,
}

/// Where a value stands in a message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Place<'d> {
    /// `self.count`
    Field(&'d str),
    /// `self.data[1]`
    At(&'d str, u8),
    /// The slot's element of an array, which a local variable holds.
    Element(SlotElement<'d>),
}

/// A word of a view: a place in a message, and where it begins in the view.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Word<'d> {
    pub(crate) place: Place<'d>,
    pub(crate) element: Element<'d>,
    pub(crate) at: u8,
}

/// The switch value of a view: a place in a message, and the view's getter.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Switch<'d> {
    pub(crate) place: Place<'d>,
    pub(crate) element: Element<'d>,
    pub(crate) get: &'d str,
}

/// Where a message has a view.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Source<'d> {
    pub(crate) view: &'d str,
    pub(crate) storage: Int,
    /// Least significant first.
    pub(crate) words: Vec<Word<'d>>,
    pub(crate) switch: Option<Switch<'d>>,
    /// What must hold for the bits to mean something.
    pub(crate) when: Vec<Test<'d>>,
}

/// A question to a message.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Test<'d> {
    Is(Place<'d>, Literal<'d>),
    IsNot(Place<'d>, Literal<'d>),
    WordsAreNot(u128),
}

/// The slots of a message: how one is read and written.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Slot<'d> {
    pub(crate) ident: &'d str,
    pub(crate) source: Source<'d>,
    pub(crate) count: Option<Count<'d>>,
    /// The arrays that it has elements of, each once.
    pub(crate) elements: Vec<SlotElement<'d>>,
    pub(crate) keys: Vec<Key<'d>>,
}

/// An array that slots have elements of, and the local variable for one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct SlotElement<'d> {
    pub(crate) field: &'d str,
    /// Whether it is a `wire::Chars`.
    pub(crate) chars: bool,
    pub(crate) local: String,
}

/// The field that says how many slots are in use.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Count<'d> {
    pub(crate) field: &'d str,
    pub(crate) element: Element<'d>,
}

/// A field of a slot or a record that is copied from the message.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Key<'d> {
    pub(crate) ident: &'d str,
    pub(crate) place: Place<'d>,
    /// The value that means "not known".
    pub(crate) invalid: Option<Literal<'d>>,
}

/// A record of values: where a message has them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Record<'d> {
    pub(crate) ident: &'d str,
    pub(crate) values: Vec<Key<'d>>,
    /// What must hold for the values to mean something.
    pub(crate) when: Option<Test<'d>>,
}

impl<'d> Source<'d> {
    /// The test that fails where the bits mean nothing: that of the words if there is one, else the first of a field.
    pub(crate) fn sentinel(&self) -> Option<&Test<'d>> {
        let of_words = self.when.iter().find(|test| matches!(test, Test::WordsAreNot(_)));
        of_words.or_else(|| self.when.iter().find(|test| matches!(test, Test::IsNot(..))))
    }
}

/// An enum that an overlay binds to a field.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bind<'d> {
    pub(crate) field: &'d str,
    pub(crate) bound: EnumType<'d>,
    pub(crate) when: Option<Test<'d>>,
}

impl<'d> BitField<'d> {
    pub(crate) fn ty(&self) -> Ty<'d> {
        match self.holds {
            Holds::Flag => Ty::Bool,
            Holds::Number => Ty::Int(self.raw),
            Holds::Enum(one) => Ty::Enum(one),
        }
    }

    /// Whether every value of their type fits, and there always are such bits.
    pub(crate) fn always_sets(&self) -> bool {
        let fits = match self.holds {
            Holds::Flag => true,
            Holds::Number => self.raw.bits() == self.width,
            Holds::Enum(one) => one.int.bits() == self.width,
        };
        fits && !self.is_optional()
    }

    /// Whether there may be no such bits: some layouts lack them, or an index is past the last.
    pub(crate) fn is_optional(&self) -> bool {
        self.repeat.is_some() || self.present.is_some()
    }
}
