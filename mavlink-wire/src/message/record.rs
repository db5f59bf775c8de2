//! Small types that people hold beside messages: views of packed bits, slots of them, and what a dialect crate adds by hand.

/// Completes a view over packed bits: `Default`, which is its `EMPTY`, and what the optional features add.
///
/// `view!(Esc32Status { bits, data_version } [state, voltage, relay[8]])` takes the type, its own fields, which `from_bits` makes it
/// of and which have getters, and the getters of what is in the bits; of those with an index how many there are.
#[macro_export]
macro_rules! view {
    ($name:ident { $($field:ident),* } [$($member:ident $([$count:literal])?),*]) => {
        impl ::core::default::Default for $name {
            #[inline]
            fn default() -> Self {
                Self::EMPTY
            }
        }

        $crate::__serde_view!($name { $($field),* } [$($member $([$count])?),*]);
        $crate::__defmt_view!($name [$($member $([$count])?),*]);
    };
}

/// Completes a struct of plain values with what the optional features add: `record!(Esc { id, age_ms, status })`, all fields.
#[macro_export]
macro_rules! record {
    ($name:ident { $($field:ident),* }) => {
        $crate::__serde_record!($name { $($field),* });
        $crate::__defmt_record!($name { $($field),* });
    };
}

/// Completes an enum with what the optional features add: `variants!(Update { Partial, Complete })`, or with one variant that has a
/// number, `variants!(Reason { None, Startup } Undefined(u8))`.
#[macro_export]
macro_rules! variants {
    ($name:ident { $($variant:ident),* } $($other:ident($number:ty))?) => {
        $crate::__serde_variants!($name { $($variant),* } $($other($number))?);
        $crate::__defmt_variants!($name { $($variant),* } $($other)?);
    };
}

/// What a getter gives: of one with an index, all that there are.
#[doc(hidden)]
#[macro_export]
macro_rules! __member {
    ($view:ident $member:ident) => {
        $view.$member()
    };
    ($view:ident $member:ident $count:literal) => {
        $crate::generated::Several { count: $count, get: |index| $view.$member(index) }
    };
}

/// The values of a getter with an index.
pub struct Several<F> {
    /// How many there are.
    pub count: usize,
    /// The getter.
    pub get: F,
}

impl<T, F: Fn(usize) -> Option<T>> Several<F> {
    /// The values; those that some layouts lack are left out.
    #[cfg_attr(not(any(feature = "serde", feature = "defmt")), allow(dead_code, reason = "only these features use it"))]
    pub(crate) fn values(&self) -> impl Iterator<Item = T> {
        (0..self.count).filter_map(&self.get)
    }
}

/// A name without the mark of a raw identifier.
#[cfg_attr(
    not(any(feature = "serde", feature = "defmt", feature = "uorb")),
    allow(dead_code, reason = "only these features use it")
)]
pub(crate) const fn plain_name(name: &'static str) -> &'static str {
    match name.as_bytes() {
        [b'r', b'#', ..] => name.split_at(2).1,
        _ => name,
    }
}
