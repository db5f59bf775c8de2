//! What the code of generated topics is made of: loads and stores that CDR and logs need beside those of MAVLink.
//!
//! All of it is total. Offsets and lengths are constants there, so that the compiler removes what can be checked once.

use super::cdr::CdrError;
use super::{Definition, Member};

/// The bytes of a body, which are at least the `N` of its definition.
///
/// # Errors
///
/// There is no such definition, or they are fewer.
#[inline]
pub fn body<'b, const N: usize>(
    definitions: &'static [Definition],
    definition: usize,
    bytes: &'b [u8],
) -> Result<&'b [u8; N], CdrError> {
    let known = definitions.get(definition..=definition).ok_or(CdrError::Definition)?;
    bytes.first_chunk().ok_or(CdrError::Length { found: bytes.len(), known })
}

/// The bytes of a body that is written.
///
/// # Errors
///
/// There is no such definition, or they are fewer.
#[inline]
pub fn body_mut<'b, const N: usize>(
    definitions: &'static [Definition],
    definition: usize,
    bytes: &'b mut [u8],
) -> Result<&'b mut [u8; N], CdrError> {
    if definition < definitions.len() { record_mut(bytes) } else { Err(CdrError::Definition) }
}

/// The bytes of a record that is written.
///
/// # Errors
///
/// They are fewer.
#[inline]
pub fn record_mut<const N: usize>(bytes: &mut [u8]) -> Result<&mut [u8; N], CdrError> {
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

/// Whether a definition that has room for `room` elements has all that say something.
///
/// # Errors
///
/// It has not.
#[inline]
pub fn fit<T: Member>(values: &[T], unknown: &[T], room: usize, field: &'static str) -> Result<(), CdrError> {
    let mut rest = values.iter().zip(unknown).skip(room);
    if rest.all(|(value, unknown)| value.is_blank(unknown)) { Ok(()) } else { Err(CdrError::DoesNotFit { field }) }
}

/// As many values as a definition has room for.
///
/// # Errors
///
/// The others say something.
#[inline]
pub fn first<T: Member, const N: usize>(values: &[T], unknown: &[T], field: &'static str) -> Result<[T; N], CdrError> {
    fit(values, unknown, N, field)?;
    values.first_chunk().copied().ok_or(CdrError::DoesNotFit { field })
}

/// Completes a topic: `Default`, which is its `UNKNOWN`, [`Fields`](crate::uorb::Fields), and what the optional features add.
///
/// `topic!(Light { timestamp, on, r#type })` takes the type and all of its fields. A field that the `.msg` file names otherwise, or
/// that had another name in older definitions, says so: `topic!(Light { timestamp, self_ = "self", lux was "brightness" })`.
#[macro_export]
macro_rules! topic {
    ($name:ident { $($field:ident $(= $named:literal)? $(was $was:literal)?),* $(,)? }) => {
        impl $crate::uorb::Fields for $name {
            const FIELDS: &'static [$crate::uorb::Field] = {
                let unknown = &$name::UNKNOWN;
                &[$(
                    $crate::uorb::Field::like(::core::stringify!($field), &unknown.$field)$(.named($named))?$(.was($was))?
                ),*]
            };
            const UNKNOWN: Self = Self::UNKNOWN;
            type Places = [$crate::uorb::Place; $crate::uorb::places(<$name as $crate::uorb::Fields>::FIELDS)];
            const ABSENT: Self::Places =
                [$crate::uorb::Place::ABSENT; $crate::uorb::places(<$name as $crate::uorb::Fields>::FIELDS)];

            #[inline]
            fn visit<V: $crate::uorb::Visit>(&mut self, unknown: &Self, visit: &mut V) {
                $(visit.field(&mut self.$field, &unknown.$field);)*
            }
        }

        impl $crate::uorb::Member for $name {
            const ELEMENT: $crate::uorb::Element = $crate::uorb::Element::Message {
                name: <Self as $crate::uorb::Topic>::NAME,
                fields: <Self as $crate::uorb::Fields>::FIELDS,
            };

            #[inline]
            fn read(
                &mut self,
                place: &$crate::uorb::Place,
                i: u16,
                nested: &[$crate::uorb::Place],
                record: &[u8],
            ) {
                $crate::generated::read_nested(self, (place, i), nested, record)
            }

            #[inline]
            fn is_blank(&self, _: &Self) -> bool {
                $crate::uorb::Fields::is_blank(self)
            }
        }

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
        assert_eq!(first::<_, 2>(&[1.0, 2.0, f32::NAN, 0.0], &[0.0; 4], "x"), Ok([1.0, 2.0]));
        assert_eq!(first::<_, 2>(&[1_u8, 2, 3], &[4; 3], "x"), Err(CdrError::DoesNotFit { field: "x" }));
        assert_eq!(first::<_, 2>(&[1_u8, 2, 4, 0], &[4; 4], "x"), Ok([1, 2]));
        assert_eq!(fit(&[1_u8, 2, 4, 0], &[4; 4], 1, "x"), Err(CdrError::DoesNotFit { field: "x" }));
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
