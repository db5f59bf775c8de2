//! Values in a payload: little-endian, packed, at any offset.
//!
//! Everything here is total: a byte that is not there reads as zero and is not written. Generated code uses constant
//! offsets into fixed-size arrays, where the compiler removes every check.
//!
//! Inlined without `always`: that would copy these functions into every use of an unoptimised build, too, at 15 % of the
//! compile time of a dialect and 17 % of its memory.

use crate::Enum;

/// A value that a payload can carry. Floats keep every bit, also of signalling NaNs.
pub trait Wire: Copy {
    /// Bytes in the payload.
    const SIZE: usize;

    /// The value at `offset`; bytes beyond the end read as zero.
    fn read(bytes: &[u8], offset: usize) -> Self;

    /// Puts the value at `offset`; bytes beyond the end are dropped.
    fn write(self, bytes: &mut [u8], offset: usize);
}

/// Reads a value at an offset of a payload; bytes beyond the end read as zero.
#[inline]
#[must_use]
pub fn get<T: Wire>(bytes: &[u8], offset: usize) -> T {
    T::read(bytes, offset)
}

/// Writes a value at an offset of a payload; bytes beyond the end are dropped.
#[inline]
pub fn put<T: Wire>(bytes: &mut [u8], offset: usize, value: T) {
    value.write(bytes, offset);
}

/// A payload at its full length: zeros behind its end, or cut if it is longer.
///
/// MAVLink 2 drops trailing zeros, so a payload that is shorter than its message is nothing unusual.
#[cfg_attr(feature = "fast-crc", inline(never))]
#[cfg_attr(not(feature = "fast-crc"), inline)]
#[must_use]
pub fn zero_extended<const N: usize>(payload: &[u8]) -> [u8; N] {
    let mut whole = [0; N];
    copy(payload, &mut whole);
    whole
}

/// Copies as many bytes as there are on both sides: one function for payloads of every length where flash counts. Where time
/// does, it is a part of each of theirs: a call for known lengths costs half of decoding.
#[cfg_attr(feature = "fast-crc", inline)]
#[cfg_attr(not(feature = "fast-crc"), inline(never))]
pub(crate) fn copy(from: &[u8], to: &mut [u8]) {
    // Unlike `copy_from_slice` this has no path to a panic.
    to.iter_mut().zip(from).for_each(|(to, from)| *to = *from);
}

macro_rules! number {
    ($($type:ty)*) => {$(
        impl Wire for $type {
            const SIZE: usize = size_of::<Self>();

            #[inline]
            fn read(bytes: &[u8], offset: usize) -> Self {
                match bytes.get(offset..).and_then(<[u8]>::first_chunk) {
                    Some(chunk) => Self::from_le_bytes(*chunk),
                    None => Self::from_le_bytes(zero_extended(bytes.get(offset..).unwrap_or_default())),
                }
            }

            #[inline]
            fn write(self, bytes: &mut [u8], offset: usize) {
                let there = bytes.get_mut(offset..).unwrap_or_default();
                match there.first_chunk_mut() {
                    Some(chunk) => *chunk = self.to_le_bytes(),
                    None => there.iter_mut().zip(self.to_le_bytes()).for_each(|(to, from)| *to = from),
                }
            }
        }
    )*};
}

number!(u8 i8 u16 i16 u32 i32 u64 i64 f32 f64);

impl<E: Enum> Wire for E {
    const SIZE: usize = E::Repr::SIZE;

    #[inline]
    fn read(bytes: &[u8], offset: usize) -> Self {
        Self::from_repr(E::Repr::read(bytes, offset))
    }

    #[inline]
    fn write(self, bytes: &mut [u8], offset: usize) {
        self.repr().write(bytes, offset);
    }
}

impl<T: Wire, const N: usize> Wire for [T; N] {
    const SIZE: usize = N * T::SIZE;

    #[inline]
    fn read(bytes: &[u8], offset: usize) -> Self {
        // Zeros that are there: reading what is not would be a call, and more than all the rest.
        let mut array = [T::read(&[0; 8], 0); N];
        read_each(&mut array, bytes, offset);
        array
    }

    #[inline]
    fn write(self, bytes: &mut [u8], offset: usize) {
        write_each(&self, bytes, offset);
    }
}

/// Reads elements of any number: an unoptimised build has one loop for all, an optimised one knows the number.
#[cfg_attr(debug_assertions, inline)]
#[cfg_attr(not(debug_assertions), inline(always))]
fn read_each<T: Wire>(elements: &mut [T], bytes: &[u8], offset: usize) {
    let there = bytes.get(offset..).unwrap_or_default();
    for (i, element) in elements.iter_mut().enumerate() {
        *element = T::read(there, i * T::SIZE);
    }
}

/// Writes elements of any number, as [`read_each`] reads them.
#[cfg_attr(debug_assertions, inline)]
#[cfg_attr(not(debug_assertions), inline(always))]
fn write_each<T: Wire>(elements: &[T], bytes: &mut [u8], offset: usize) {
    let there = bytes.get_mut(offset..).unwrap_or_default();
    for (i, element) in elements.iter().enumerate() {
        element.write(there, i * T::SIZE);
    }
}
