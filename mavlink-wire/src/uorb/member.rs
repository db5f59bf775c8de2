//! What the fields of topics can be, and how they are read from the records of a log.

use super::kind::Char;
use super::{Element, Kind, Place, Value, places};
use crate::{Chars, Enum};

/// What a field of a topic can be: a number, a `bool`, an enum or flags, text, another topic, or an array of one of these.
pub trait Member: Copy + 'static {
    /// Its type, or that of its elements.
    const ELEMENT: Element;

    /// The length of an array.
    const LEN: Option<u16> = None;

    /// Reads element `i` at a place of a record; what is not there stays as it was. An array reads all of its elements. `nested` are
    /// the places of the fields of a nested topic.
    fn read(&mut self, place: &Place, i: u16, nested: &[Place], record: &[u8]);

    /// Whether it says nothing: it is zero, NaN, or what it is where nothing is known.
    fn is_blank(&self, unknown: &Self) -> bool;
}

/// The fields of a topic, as binding by name needs them: [`topic!`](crate::topic!) implements it.
pub trait Fields: Copy + 'static {
    /// Its fields.
    const FIELDS: &'static [super::Field];

    /// A value of which nothing is known.
    const UNKNOWN: Self;

    /// As many places as [`places`] says: `[Place; N]`.
    type Places: Copy + AsRef<[Place]> + AsMut<[Place]> + 'static;

    /// Places of a log that has none of the fields.
    const ABSENT: Self::Places;

    /// Visits the fields, each beside its value in `unknown`.
    fn visit<V: Visit>(&mut self, unknown: &Self, visit: &mut V);

    /// Reads a record of a log by its places: first those of the fields, then those of the fields of each nested message. What the
    /// record does not have stays as it was.
    #[inline]
    fn read_record(&mut self, places: &[Place], record: &[u8]) {
        let (own, nested) = places.split_at_checked(Self::FIELDS.len()).unwrap_or_default();
        self.visit(&Self::UNKNOWN, &mut Reading { own, nested, record });
    }

    /// Whether it says nothing.
    fn is_blank(&self) -> bool {
        let (mut copy, mut blank) = (*self, Blank(true));
        copy.visit(&Self::UNKNOWN, &mut blank);
        blank.0
    }
}

/// What is done with each field of a topic, in their order.
pub trait Visit {
    /// A field, and what it is where nothing is known.
    fn field<M: Member>(&mut self, field: &mut M, unknown: &M);
}

/// Reads a record: the places of the fields that are to come, and those of what is nested in them.
struct Reading<'p> {
    own: &'p [Place],
    nested: &'p [Place],
    record: &'p [u8],
}

impl Visit for Reading<'_> {
    #[inline]
    fn field<M: Member>(&mut self, field: &mut M, _: &M) {
        let Some((place, others)) = self.own.split_first() else { return };
        self.own = others;
        let (nested, others) = self.nested.split_at_checked(const { M::ELEMENT.places() }).unwrap_or_default();
        self.nested = others;
        field.read(place, 0, nested, self.record);
    }
}

/// Whether no field so far said anything.
struct Blank(bool);

impl Visit for Blank {
    #[inline]
    fn field<M: Member>(&mut self, field: &mut M, unknown: &M) {
        self.0 &= field.is_blank(unknown);
    }
}

/// Reads a nested topic.
#[inline]
pub fn read_nested<T: Fields>(topic: &mut T, (place, i): (&Place, u16), nested: &[Place], record: &[u8]) {
    if let Some(record) = place.nested(record, i) {
        topic.read_record(nested, record);
    }
}

impl Element {
    /// How many places the fields of a nested message take.
    pub(super) const fn places(self) -> usize {
        match self {
            Self::Scalar(_) => 0,
            Self::Message { fields, .. } => places(fields),
        }
    }
}

macro_rules! scalar {
    ($($type:ty: $is_nothing:expr;)*) => {$(
        impl Member for $type {
            const ELEMENT: Element = Element::Scalar(<$type as Value>::KIND);

            #[inline]
            fn read(&mut self, place: &Place, i: u16, _: &[Place], record: &[u8]) {
                if let Some(read) = place.value(record, i) {
                    *self = read;
                }
            }

            #[inline]
            fn is_blank(&self, unknown: &Self) -> bool {
                $is_nothing(*self) || self == unknown
            }
        }
    )*};
}

scalar! {
    bool: |value: bool| !value;
    u8: |value| value == 0;
    i8: |value| value == 0;
    u16: |value| value == 0;
    i16: |value| value == 0;
    u32: |value| value == 0;
    i32: |value| value == 0;
    u64: |value| value == 0;
    i64: |value| value == 0;
    f32: |value: f32| value == 0.0 || value.is_nan();
    f64: |value: f64| value == 0.0 || value.is_nan();
}

impl<E: Enum> Member for E
where
    E::Repr: Value + Member,
{
    const ELEMENT: Element = Element::Scalar(<E::Repr as Value>::KIND);

    #[inline]
    fn read(&mut self, place: &Place, i: u16, _: &[Place], record: &[u8]) {
        if let Some(read) = place.value(record, i) {
            *self = E::from_repr(read);
        }
    }

    #[inline]
    fn is_blank(&self, unknown: &Self) -> bool {
        self.repr().is_blank(&unknown.repr())
    }
}

impl<const N: usize> Member for Chars<N> {
    const ELEMENT: Element = Element::Scalar(Kind::Char);
    const LEN: Option<u16> = Some(N as u16);

    #[inline]
    fn read(&mut self, place: &Place, _: u16, _: &[Place], record: &[u8]) {
        for (i, byte) in (0..place.len()).zip(&mut self.0) {
            if let Some(Char(read)) = place.value(record, i) {
                *byte = read;
            }
        }
    }

    #[inline]
    fn is_blank(&self, _: &Self) -> bool {
        self.0.iter().all(|byte| *byte == 0)
    }
}

impl<T: Member, const N: usize> Member for [T; N] {
    const ELEMENT: Element = T::ELEMENT;
    const LEN: Option<u16> = Some(N as u16);

    #[inline]
    fn read(&mut self, place: &Place, _: u16, nested: &[Place], record: &[u8]) {
        for (i, element) in (0..place.len()).zip(self) {
            element.read(place, i, nested, record);
        }
    }

    #[inline]
    fn is_blank(&self, unknown: &Self) -> bool {
        self.iter().zip(unknown).all(|(element, unknown)| element.is_blank(unknown))
    }
}
