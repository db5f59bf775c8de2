//! What the code of generated topics is made of: loads and stores that CDR and logs need beside those of MAVLink.
//!
//! All of it is total. Offsets and lengths are constants there, so that the compiler removes what can be checked once.

use super::Definition;
use super::cdr::CdrError;

/// The bytes of a body, which are at least as many as its definition has.
///
/// # Errors
///
/// They are fewer.
#[inline]
pub fn body<'b, const N: usize>(bytes: &'b [u8], known: &'static [Definition]) -> Result<&'b [u8; N], CdrError> {
    bytes.first_chunk().ok_or(CdrError::Length { found: bytes.len(), known })
}

/// The bytes of a body or record that is written.
///
/// # Errors
///
/// They are fewer.
#[inline]
pub fn body_mut<const N: usize>(bytes: &mut [u8]) -> Result<&mut [u8; N], CdrError> {
    bytes.first_chunk_mut().ok_or(CdrError::NoRoom { needed: N })
}

/// Nested messages of `L` bytes each, from `at` on, one every `stride` bytes.
#[inline]
pub fn elements<const L: usize>(bytes: &[u8], at: usize, stride: usize) -> impl Iterator<Item = &[u8; L]> {
    bytes.get(at..).unwrap_or_default().chunks(stride.max(1)).map_while(<[u8]>::first_chunk)
}

/// `N` nested messages of `L` bytes each, from `at` on, one every `stride` bytes, each made by `read`.
#[inline]
pub fn each<T, const N: usize, const L: usize>(
    bytes: &[u8],
    at: usize,
    stride: usize,
    read: impl Fn(&[u8; L]) -> T,
) -> [T; N] {
    let element = |i| bytes.get(at + stride * i..).and_then(<[u8]>::first_chunk);
    core::array::from_fn(|i| read(element(i).unwrap_or(&[0; L])))
}

/// Nested messages of `L` bytes each that are written, from `at` on, one every `stride` bytes.
#[inline]
pub fn elements_mut<const L: usize>(bytes: &mut [u8], at: usize, stride: usize) -> impl Iterator<Item = &mut [u8; L]> {
    bytes.get_mut(at..).unwrap_or_default().chunks_mut(stride.max(1)).map_while(<[u8]>::first_chunk_mut)
}

/// A `bool` at an offset.
///
/// # Errors
///
/// It is neither 0 nor 1.
#[inline]
pub fn boolean(bytes: &[u8], at: usize, field: &'static str) -> Result<bool, CdrError> {
    match bytes.get(at) {
        Some(0) | None => Ok(false),
        Some(1) => Ok(true),
        Some(&value) => Err(CdrError::Bool { field, value }),
    }
}

/// Several `bool`s from an offset on.
///
/// # Errors
///
/// One is neither 0 nor 1.
#[inline]
pub fn booleans<const N: usize>(bytes: &[u8], at: usize, field: &'static str) -> Result<[bool; N], CdrError> {
    let mut values = [false; N];
    for (value, at) in values.iter_mut().zip(at..) {
        *value = boolean(bytes, at, field)?;
    }
    Ok(values)
}

/// Puts the first values of an array over its own.
#[inline]
pub fn fill<T: Copy>(to: &mut [T], from: &[T]) {
    to.iter_mut().zip(from).for_each(|(to, from)| *to = *from);
}

/// A value that may be one of a narrower type.
pub trait Narrow<T>: Copy {
    /// The same value, if the type has it.
    fn narrowed(self) -> Option<T>;
}

macro_rules! narrow {
    ($($wide:ty: $($narrow:ty)*;)*) => {$($(
        impl Narrow<$narrow> for $wide {
            #[inline]
            fn narrowed(self) -> Option<$narrow> {
                self.try_into().ok()
            }
        }
    )*)*};
}

narrow! {
    u16: u8;
    u32: u16 u8;
    u64: u32 u16 u8;
    i16: u8 i8;
    i32: u16 i16 u8 i8;
    i64: u32 i32 u16 i16 u8 i8;
}

macro_rules! narrow_to_bool {
    ($($wide:ty)*) => {$(
        impl Narrow<bool> for $wide {
            #[inline]
            fn narrowed(self) -> Option<bool> {
                match self {
                    0 => Some(false),
                    1 => Some(true),
                    _ => None,
                }
            }
        }
    )*};
}

narrow_to_bool!(u8 i8 u16 i16 u32 i32 u64 i64);

macro_rules! narrow_float {
    ($($wide:ty: $($narrow:ty)*;)*) => {$($(
        impl Narrow<$narrow> for $wide {
            #[inline]
            fn narrowed(self) -> Option<$narrow> {
                // The cast saturates, and what was not whole or too large comes back as another number.
                let narrow = self as $narrow;
                (Self::from(narrow) == self).then_some(narrow)
            }
        }
    )*)*};
}

narrow_float! {
    f32: u16 i16 u8 i8;
    f64: u32 i32 u16 i16 u8 i8;
}

impl Narrow<f32> for f64 {
    #[inline]
    fn narrowed(self) -> Option<f32> {
        let narrow = self as f32;
        (self.is_nan() || Self::from(narrow) == self).then_some(narrow)
    }
}

/// The value in the type that a definition has.
///
/// # Errors
///
/// That has no such value.
#[inline]
pub fn narrow<T, S: Narrow<T>>(value: S, field: &'static str) -> Result<T, CdrError> {
    value.narrowed().ok_or(CdrError::DoesNotFit { field })
}

/// The values in the type that a definition has.
///
/// # Errors
///
/// That lacks one of them.
#[inline]
pub fn narrow_each<T: Copy + Default, S: Narrow<T>, const N: usize>(
    values: [S; N],
    field: &'static str,
) -> Result<[T; N], CdrError> {
    let mut narrowed = [T::default(); N];
    for (to, value) in narrowed.iter_mut().zip(values) {
        *to = narrow(value, field)?;
    }
    Ok(narrowed)
}

/// A value that may say nothing.
pub trait Blank: Copy {
    /// Whether it is what a field is that nobody set.
    fn is_blank(self) -> bool;
}

macro_rules! blank {
    ($($type:ty)*) => {$(
        impl Blank for $type {
            #[inline]
            fn is_blank(self) -> bool {
                self == Self::default()
            }
        }
    )*};
}

blank!(u8 i8 u16 i16 u32 i32 u64 i64 bool);

macro_rules! blank_float {
    ($($type:ty)*) => {$(
        impl Blank for $type {
            #[inline]
            fn is_blank(self) -> bool {
                self == 0.0 || self.is_nan()
            }
        }
    )*};
}

blank_float!(f32 f64);

impl<T: Blank, const N: usize> Blank for [T; N] {
    #[inline]
    fn is_blank(self) -> bool {
        self.iter().all(|value| value.is_blank())
    }
}

/// Whether a field says nothing.
#[inline]
pub fn is_blank<T: Blank>(value: T) -> bool {
    value.is_blank()
}

/// As many values as a definition has room for.
///
/// # Errors
///
/// The others say something else than that they are not known.
#[inline]
pub fn first<T: Blank + PartialEq, const N: usize>(
    values: &[T],
    unknown: T,
    field: &'static str,
) -> Result<[T; N], CdrError> {
    let is_blank = |value: &T| value.is_blank() || *value == unknown;
    match values.split_first_chunk() {
        Some((first, rest)) if rest.iter().all(is_blank) => Ok(*first),
        _ => Err(CdrError::DoesNotFit { field }),
    }
}

/// Completes a generated topic: `Default`, which is its `UNKNOWN`, and what the optional features add.
///
/// `topic!(EscStatus { timestamp, counter, esc })` takes the type and all of its fields.
#[macro_export]
macro_rules! topic {
    ($name:ident { $($field:ident),* }) => {
        impl ::core::default::Default for $name {
            #[inline]
            fn default() -> Self {
                Self::UNKNOWN
            }
        }

        $crate::__serde_topic!($name { $($field),* });
        $crate::__defmt_record!($name { $($field),* });
        $crate::__arbitrary_record!($name { $($field),* });
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_is_refused() {
        let narrowed = |value: u16| narrow::<u8, _>(value, "flags").ok();
        assert_eq!([255, 256].map(narrowed), [Some(255), None]);
        let whole = |value: f32| narrow::<u8, _>(value, "temperature").ok();
        assert_eq!([25.0, 25.5, 256.0, -1.0, f32::NAN].map(whole), [Some(25), None, None, None, None]);
        assert_eq!(narrow::<bool, _>(2_u8, "armed"), Err(CdrError::DoesNotFit { field: "armed" }));
        assert_eq!(narrow::<f32, _>(1e300_f64, "x"), Err(CdrError::DoesNotFit { field: "x" }));
        assert_eq!(narrow_each::<i8, i32, 2>([-128, 127], "x"), Ok([-128, 127]));
    }

    #[test]
    fn what_is_left_out_says_nothing() {
        assert_eq!(first::<_, 2>(&[1.0, 2.0, f32::NAN, 0.0], 0.0, "x"), Ok([1.0, 2.0]));
        assert_eq!(first::<_, 2>(&[1_u8, 2, 3], 4, "x"), Err(CdrError::DoesNotFit { field: "x" }));
        assert_eq!(first::<_, 2>(&[1_u8, 2, 4, 0], 4, "x"), Ok([1, 2]));
    }

    #[test]
    fn elements_lie_a_stride_apart() {
        let bytes = [9, 1, 2, 0, 3, 4];
        assert!(elements::<2>(&bytes, 1, 3).eq([&[1, 2], &[3, 4]]));
        assert_eq!(elements::<2>(&bytes, 7, 3).count(), 0);
        assert_eq!(each(&bytes, 1, 3, |element: &[u8; 2]| *element), [[1, 2], [3, 4], [0, 0]]);
        assert_eq!(booleans::<2>(&[0, 1, 0], 1, "x"), Ok([true, false]));
        assert_eq!(boolean(&[7], 0, "x"), Err(CdrError::Bool { field: "x", value: 7 }));
    }
}
