//! Views of a payload: packed bits where overlays say they are, slot by slot, and enums that are bound to fields.

use mavlink_wire::reflect::Number;

use super::Bits;
use super::tables::kind;
use crate::ir::{
    Access, Binding, Condition, EnumId, FieldIndex, Key, Message, Place, Record, Slots, SwitchOn, View, ViewSentinel,
    Word,
};

/// A view, read from a payload.
#[derive(Clone, Debug)]
pub struct Reading<'d> {
    /// The view.
    pub view: &'d View,
    /// What the payload holds of it.
    pub content: Content<'d>,
}

/// What a payload holds of a view.
#[derive(Clone, Debug)]
pub enum Content<'d> {
    /// Of a view over plain fields: its bits, or `None` where they mean nothing.
    Once(Option<Bits<'d>>),
    /// Of a view of slots: those that are in use.
    Slots(Vec<Slot<'d>>),
    /// Of a view of values: those, or `None` where the condition does not hold.
    Record(Option<Vec<KeyValue<'d>>>),
}

/// A slot that is in use.
#[derive(Clone, Debug)]
pub struct Slot<'d> {
    /// The fields that are copied into it.
    pub keys: Vec<KeyValue<'d>>,
    /// Its bits, or `None` where they mean nothing.
    pub status: Option<Bits<'d>>,
}

/// A field that is copied into a slot, or is a value of a view.
#[derive(Clone, Copy, Debug)]
pub struct KeyValue<'d> {
    /// Its name, unit and sentinel.
    pub key: &'d Key,
    /// The number.
    pub number: Number,
    /// The enum that the field carries.
    pub values: Option<EnumId>,
}

impl KeyValue<'_> {
    /// Whether the number is the one that means "not known".
    #[must_use]
    pub fn is_invalid(&self) -> bool {
        self.key.invalid.is_some() && self.key.invalid == self.number.as_integer()
    }
}

/// Every view of the message, as this payload fills it. Bytes that are missing read as zero.
pub fn views<'d>(message: &'d Message, payload: &'d [u8]) -> impl Iterator<Item = Reading<'d>> {
    let source = Source { message, payload };
    message.views.iter().map(move |view| Reading {
        view,
        content: match &view.access {
            Access::Once { .. } => Content::Once(source.bits(view, 0)),
            Access::Slots(slots) => Content::Slots(source.slots(view, slots)),
            Access::Record(record) => Content::Record(source.record(view, record)),
        },
    })
}

/// Every enum that overlays bind to a field of the message, with its value; `None` where its condition does not hold.
pub fn bindings<'d>(message: &'d Message, payload: &'d [u8]) -> impl Iterator<Item = (&'d Binding, Option<u64>)> {
    let source = Source { message, payload };
    message.bindings.iter().map(move |binding| {
        let holds = binding.condition.as_ref().is_none_or(|condition| source.holds(condition));
        // An enum's number has the width of the field, zeros above.
        let number = source.pattern(Place { field: binding.field, element: false }, 0);
        (binding, number.filter(|_| holds))
    })
}

/// The fields that views are read from.
#[derive(Clone, Copy)]
struct Source<'d> {
    message: &'d Message,
    payload: &'d [u8],
}

impl<'d> Source<'d> {
    /// The slots in use, by their index.
    fn slots(&self, view: &'d View, slots: &'d Slots) -> Vec<Slot<'d>> {
        let length = slots.length.get();
        let used = slots.count.and_then(|count| self.pattern(Place { field: count, element: false }, 0));
        let used = used.map_or(length, |used| u8::try_from(used).unwrap_or(length).min(length));
        let keys = |index| slots.keys.iter().filter_map(move |key| self.key(key, index)).collect();
        (0..used).map(|index| Slot { keys: keys(index), status: self.bits(view, index) }).collect()
    }

    /// The values of a record; `None` where they mean nothing.
    fn record(&self, view: &View, record: &'d Record) -> Option<Vec<KeyValue<'d>>> {
        let holds = view.condition.as_ref().is_none_or(|condition| self.holds(condition));
        holds.then(|| record.values.iter().filter_map(|value| self.key(value, 0)).collect())
    }

    fn key(&self, key: &'d Key, index: u8) -> Option<KeyValue<'d>> {
        let values = self.message.fields.get(key.place.field.0)?.values.map(|values| values.id());
        Some(KeyValue { key, number: self.number(key.place, index)?, values })
    }

    /// The bits of a slot, or of a view that has none; `None` where they mean nothing.
    fn bits(&self, view: &'d View, index: u8) -> Option<Bits<'d>> {
        let bits = self.joined(view, index);
        let sentinel = view.invalid.iter().any(|sentinel| match sentinel {
            ViewSentinel::Words(value) => bits == *value,
            ViewSentinel::Field(place, value) => self.integer(*place, index) == Some(*value),
        });
        if sentinel || view.condition.as_ref().is_some_and(|condition| !self.holds(condition)) {
            return None;
        }
        let layout = view.switch.as_ref().and_then(|switch| match switch.on {
            SwitchOn::Field(place, _) => self.pattern(place, index),
            SwitchOn::Bits { .. } => None,
        });
        Some(Bits::new(view, bits, layout))
    }

    /// The words of a view, the first least significant.
    fn joined(&self, view: &View, index: u8) -> u128 {
        let (mut bits, mut at) = (0, 0);
        let mut push = |place: Place, index: u8| {
            let word = u128::from(self.pattern(place, index).unwrap_or_default());
            bits |= word.checked_shl(at).unwrap_or_default();
            at += self.element_bits(place.field);
        };
        for word in &view.words {
            match *word {
                Word::One(place) => push(place, index),
                Word::Joined(field) => {
                    (0..self.length(field)).for_each(|index| push(Place { field, element: true }, index));
                }
            }
        }
        bits
    }

    fn holds(&self, condition: &Condition) -> bool {
        let place = Place { field: condition.field, element: false };
        self.integer(place, 0) == Some(condition.value.into())
    }

    fn integer(&self, place: Place, index: u8) -> Option<i128> {
        self.number(place, index)?.as_integer()
    }

    /// The bits of an integer or a float, zeros above.
    fn pattern(&self, place: Place, index: u8) -> Option<u64> {
        match self.number(place, index)? {
            Number::U64(value) => Some(value),
            Number::I64(value) => {
                let bits = self.element_bits(place.field);
                Some(value as u64 & u64::MAX.checked_shr(64_u32.saturating_sub(bits)).unwrap_or_default())
            }
            Number::F32(value) => Some(value.to_bits().into()),
            Number::F64(value) => Some(value.to_bits()),
        }
    }

    /// The field's number, or the slot's element of it.
    fn number(&self, place: Place, index: u8) -> Option<Number> {
        let field = self.message.fields.get(place.field.0)?;
        let skipped = if place.element { usize::from(index) * field.ty.scalar.size() } else { 0 };
        Some(Number::read(kind(field.ty.scalar), self.payload, usize::from(field.offset) + skipped))
    }

    fn element_bits(&self, field: FieldIndex) -> u32 {
        self.message.fields.get(field.0).map_or(0, |field| 8 * field.ty.scalar.size() as u32)
    }

    fn length(&self, field: FieldIndex) -> u8 {
        self.message.fields.get(field.0).and_then(|field| field.ty.array).map_or(1, std::num::NonZeroU8::get)
    }
}
