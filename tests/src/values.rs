//! The values of a message as bit patterns, and how they get into the fields of a struct and out again.
//!
//! Values go through `From`, never through the runtime's reading and writing of payloads, which is what they test.

use mavlink_wire::Chars;
use mavlink_wire::generated::Wire;

/// One list of elements for each field, in the order of the XML. An element is its bit pattern, zeros above.
pub type Values = Vec<Vec<u64>>;

/// A number of the wire.
pub trait Number: Copy {
    /// From a bit pattern.
    fn from_pattern(bits: u64) -> Self;

    /// To a bit pattern.
    fn pattern(self) -> u64;
}

macro_rules! integers {
    ($($type:ident as $unsigned:ident)*) => {$(
        impl Number for $type {
            fn from_pattern(bits: u64) -> Self {
                bits as Self
            }

            fn pattern(self) -> u64 {
                u64::from(self as $unsigned)
            }
        }
    )*};
}

integers!(u8 as u8 u16 as u16 u32 as u32 u64 as u64 i8 as u8 i16 as u16 i32 as u32 i64 as u64);

macro_rules! floats {
    ($($type:ident as $unsigned:ident)*) => {$(
        impl Number for $type {
            fn from_pattern(bits: u64) -> Self {
                Self::from_bits(bits as $unsigned)
            }

            fn pattern(self) -> u64 {
                u64::from(self.to_bits())
            }
        }
    )*};
}

floats!(f32 as u32 f64 as u64);

/// Hands out values, field by field.
///
/// The element type of the XML is always written out, so that a field of any other type does not compile: it must have
/// the same size and come from exactly that number, as the number itself and its enums do.
#[derive(Debug)]
pub struct Reader<'v>(std::slice::Iter<'v, Vec<u64>>);

impl<'v> Reader<'v> {
    /// Begins with the first field.
    pub fn new(values: &'v Values) -> Self {
        Self(values.iter())
    }

    /// The value of a field.
    ///
    /// # Panics
    ///
    /// Here and below: if the values are those of another message.
    pub fn one<X: Number, T: Wire + From<X>>(&mut self) -> T {
        let [value] = self.array::<X, T, 1>();
        value
    }

    /// The elements of an array.
    pub fn array<X: Number, T: Wire + From<X>, const N: usize>(&mut self) -> [T; N] {
        const { assert!(T::SIZE == size_of::<X>(), "the field has another type than its values") };
        let elements = self.0.next().expect("one list of values for each field");
        assert_eq!(elements.len(), N, "one value for each element");
        std::array::from_fn(|at| T::from(X::from_pattern(elements[at])))
    }

    /// A text.
    pub fn text<const N: usize>(&mut self) -> Chars<N> {
        Chars(self.array::<u8, u8, N>())
    }
}

/// Takes values, field by field.
#[derive(Debug, Default)]
pub struct Writer(Values);

impl Writer {
    /// A field.
    pub fn one<X: Number, T: Into<X>>(&mut self, value: T) {
        self.0.push(vec![value.into().pattern()]);
    }

    /// An array.
    pub fn array<X: Number, T: Into<X>, const N: usize>(&mut self, values: [T; N]) {
        self.0.push(values.into_iter().map(|value| value.into().pattern()).collect());
    }

    /// A text.
    pub fn text<const N: usize>(&mut self, text: Chars<N>) {
        self.array::<u8, u8, N>(text.0);
    }

    /// What was taken.
    pub fn into_values(self) -> Values {
        self.0
    }
}
