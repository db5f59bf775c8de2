//! Views: what bits that are packed into fields mean, and fields that have another meaning on a condition. They come from
//! overlays; the wire does not know them.

use std::fmt;
use std::num::NonZeroU8;
use std::ops::RangeInclusive;

use super::{EnumId, Label, Name, Origin, Repr, unit_words};
use crate::source::Span;

/// How many bits a view can have: there is no larger integer.
pub(crate) const MOST_BITS: usize = 128;

/// A layout of bits over one or more fields of a message; or values in some of its fields, which has no words and no bits.
#[derive(Clone, Debug)]
pub struct View {
    /// Its name: `ESC32_STATUS`, the type `Esc32Status`.
    pub name: Name,
    /// The integers it is read from, least significant first; none of a view of values.
    pub words: Vec<Word>,
    /// Bits of all words together: 8 to 128; 0 of a view of values.
    pub width: u8,
    /// How a message gives it.
    pub access: Access,
    /// The view means something only while this holds.
    pub condition: Option<Condition>,
    /// Any match says that the bits mean nothing.
    pub invalid: Vec<ViewSentinel>,
    /// What selects between layouts, if the layout is not always the same.
    pub switch: Option<Switch>,
    /// The named bits, in the order of the overlay.
    pub members: Vec<Member>,
    /// Where it comes from.
    pub origin: Origin,
}

impl View {
    /// The fields that are copied: into its slots, or as its values.
    pub(crate) fn keys(&self) -> &[Key] {
        match &self.access {
            Access::Once { .. } => &[],
            Access::Slots(slots) => &slots.keys,
            Access::Record(record) => &record.values,
        }
    }
}

/// A field of the message, by its place in [`super::Message::fields`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FieldIndex(pub usize);

/// A field, or the element of an array field that belongs to a slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Place {
    /// The field.
    pub field: FieldIndex,
    /// Whether it is an array of which each slot has one element (`x[i]`).
    pub element: bool,
}

/// An integer that a view is read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// A scalar, or an element for each slot.
    One(Place),
    /// All elements of an array joined, the first least significant (`x[*]`).
    Joined(FieldIndex),
}

/// How a message gives a view.
#[derive(Clone, Debug)]
pub enum Access {
    /// Once: a getter and a setter of this name on the message.
    Once {
        /// `flight_sw` gives `flight_sw()` and `set_flight_sw()`.
        getter: Label,
    },
    /// Once a slot.
    Slots(Slots),
    /// Once, as values in fields.
    Record(Record),
}

/// Fields that have a name, a unit and a meaning of their own, mostly while the condition of the view holds.
#[derive(Clone, Debug)]
pub struct Record {
    /// `gps` gives `gps()`, `set_gps()` and `with_gps()`.
    pub getter: Label,
    /// The values: scalars, each field once.
    pub values: Vec<Key>,
}

/// The slots of arrays that a message carries side by side.
#[derive(Clone, Debug)]
pub struct Slots {
    /// The type of a slot, `Esc`; the methods `esc(index)`, `set_esc(index, …)` and `push_esc(…)` are named after it.
    pub item: Name,
    /// The iterator: `escs`.
    pub items: Label,
    /// Elements of the arrays.
    pub length: NonZeroU8,
    /// A scalar field that says how many slots are used; the others hold stale data.
    pub count: Option<FieldIndex>,
    /// What a slot carries beside the view.
    pub keys: Vec<Key>,
}

/// A field that is copied into a slot, or is a value of a view.
#[derive(Clone, Debug)]
pub struct Key {
    /// Its name: `age` in milliseconds, shown as `age_ms`.
    pub name: Label,
    /// The field.
    pub place: Place,
    /// Its unit.
    pub units: Option<String>,
    /// The value that means "not known".
    pub invalid: Option<i128>,
    /// What the overlay says of it.
    pub description: String,
}

/// A value that says that a view means nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViewSentinel {
    /// A field, or the slot's element of one, has this value.
    Field(Place, i128),
    /// The joined words are this.
    Words(u128),
}

/// A condition on the message: a scalar integer field has this value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Condition {
    /// The field; scalar.
    pub field: FieldIndex,
    /// The value.
    pub value: u64,
    /// The enum that the XML names the value in, if the field carries one.
    pub enum_: Option<EnumId>,
}

/// What selects between layouts.
#[derive(Clone, Debug)]
pub struct Switch {
    /// The name of the field or the bits that it looks at: `data_version`.
    pub name: Label,
    /// Where it is read.
    pub on: SwitchOn,
    /// Where the overlay names what it looks at.
    pub span: Span,
}

/// Where the value that selects a layout is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SwitchOn {
    /// An unsigned integer field, which the view carries along.
    Field(Place, Repr),
    /// Bits of the view itself that are in every layout.
    Bits {
        /// The first bit.
        at: u8,
        /// How many.
        width: u8,
    },
}

impl SwitchOn {
    /// The largest value.
    pub(crate) fn highest(self) -> u64 {
        match self {
            Self::Field(_, repr) => repr.highest(),
            Self::Bits { width, .. } => largest_of_bits(width),
        }
    }
}

/// Named bits.
#[derive(Clone, Debug)]
pub struct Member {
    /// The name.
    pub name: Label,
    /// The first bit; 0 is the least significant of all words together.
    pub at: u8,
    /// How many bits; with `repeat`, of each.
    pub width: u8,
    /// Two's complement.
    pub signed: bool,
    /// What the bits are.
    pub meaning: Meaning,
    /// Several alike, by index.
    pub repeat: Option<Repeat>,
    /// In which layouts it is.
    pub presence: Presence,
    /// What the overlay says of it.
    pub description: String,
}

/// What bits are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// One bit: yes or no.
    Flag,
    /// Values of an enum that is at least as wide.
    Values(EnumId),
    /// A whole number, as it is.
    Number {
        /// Its unit.
        units: Option<String>,
    },
    /// A number that stands for another: (raw · `factor` + `bias`) / `divisor`, exactly.
    Scaled(Scaled),
}

/// How a raw number becomes a value: (raw · `factor` + `bias`) / `divisor`, in lowest terms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scaled {
    /// Not zero.
    pub factor: i64,
    /// Added before dividing.
    pub bias: i64,
    /// At least 1.
    pub divisor: i64,
    /// The unit of the value.
    pub units: Option<String>,
    /// An integer getter in a smaller unit.
    pub exact: Option<Exact>,
}

/// The formula: `raw * 20 / 51`, `(raw - 128) / 4`.
impl fmt::Display for Scaled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (open, close) = if self.divisor != 1 && self.bias != 0 { ("(", ")") } else { ("", "") };
        write!(f, "{open}raw")?;
        if self.factor != 1 {
            write!(f, " * {}", self.factor)?;
        }
        if self.bias != 0 {
            let sign = if self.bias < 0 { '-' } else { '+' };
            write!(f, " {sign} {}", self.bias.unsigned_abs())?;
        }
        f.write_str(close)?;
        if self.divisor == 1 { Ok(()) } else { write!(f, " / {}", self.divisor) }
    }
}

/// The value as a whole number of a smaller unit: raw · `factor` + `bias`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exact {
    /// The unit: `mV`.
    pub units: String,
    /// Not zero.
    pub factor: i64,
    /// Added.
    pub bias: i64,
}

impl Exact {
    /// What the unit adds to the name of a getter: `mv`.
    pub(crate) fn suffix(&self) -> String {
        unit_words(&self.units)
    }
}

/// The largest value of so many bits, of which there are 1 to 64.
pub(crate) fn largest_of_bits(bits: u8) -> u64 {
    u64::MAX >> (64 - u32::from(bits.clamp(1, 64)))
}

/// The bits of so many beginning at one, and of those that repeat them; of those that a view can have.
pub(crate) fn mask(at: u8, width: u8, repeat: Option<Repeat>) -> u128 {
    let one = u128::MAX.checked_shr(128_u32.saturating_sub(width.into())).unwrap_or_default();
    let Repeat { count, stride } = repeat.unwrap_or(Repeat { count: 1, stride: 0 });
    (0..u32::from(count))
        .fold(0, |mask, index| mask | one.checked_shl(u32::from(at) + index * u32::from(stride)).unwrap_or_default())
}

/// Several alike: number `i` begins at `at + i · stride`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Repeat {
    /// How many; at least 2.
    pub count: u8,
    /// Bits from one to the next; at least `width`.
    pub stride: u8,
}

/// In which layouts a member is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Presence {
    /// In all of them.
    Always,
    /// While the switch has one of these values: sorted, apart, not all there are.
    When(Vec<RangeInclusive<u64>>),
}

/// A field that carries the values of an enum that the definitions do not name, always or on a condition.
#[derive(Clone, Debug)]
pub struct Binding {
    /// The getter: `nav_status` gives `nav_status()` and `set_nav_status()` on the message.
    pub name: Label,
    /// The integer field; scalar, and as wide as the enum.
    pub field: FieldIndex,
    /// The enum.
    pub enum_: EnumId,
    /// The getter gives `None` unless this holds.
    pub condition: Option<Condition>,
    /// What the overlay says of it.
    pub description: String,
}
