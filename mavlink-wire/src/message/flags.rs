//! Flags of a dialect: newtypes with the interface of `bitflags` 2, cheaper to compile.
//!
//! [`flags!`](crate::flags!) adds to each only what needs its type; iteration and text are done here once, for all.
//!
//! ```
//! # use mavlink_wire as wire;
//! # #[derive(Clone, Copy, PartialEq)]
//! # pub struct MavModeFlag(pub u8);
//! # impl MavModeFlag {
//! #     pub const GUIDED_ENABLED: Self = Self(8);
//! #     pub const SAFETY_ARMED: Self = Self(128);
//! # }
//! # static INFO: wire::EnumInfo = wire::EnumInfo::bitmask(
//! #     "MAV_MODE_FLAG",
//! #     &[(8, "MAV_MODE_FLAG_GUIDED_ENABLED"), (128, "MAV_MODE_FLAG_SAFETY_ARMED")],
//! # );
//! # wire::flags!(MavModeFlag, u8, INFO);
//! let mut mode = MavModeFlag::SAFETY_ARMED | MavModeFlag::GUIDED_ENABLED;
//! mode.remove(MavModeFlag::GUIDED_ENABLED);
//! assert!(mode.contains(MavModeFlag::SAFETY_ARMED));
//! assert_eq!(mode.iter_names().map(|(name, _)| name).collect::<Vec<_>>(), ["MAV_MODE_FLAG_SAFETY_ARMED"]);
//! ```

mod interface;

use core::fmt;
use core::marker::PhantomData;

use super::enums::number;
use crate::{Enum, EnumInfo, Repr, UnknownName};

/// The entries that are contained in a value, in order, each bit claimed once.
#[derive(Clone, Debug)]
pub(crate) struct Contained {
    entries: &'static [(u64, &'static str)],
    source: u64,
    remaining: u64,
}

impl Contained {
    pub(crate) const fn new(info: &EnumInfo, bits: u64) -> Self {
        Self { entries: info.entries, source: bits, remaining: bits }
    }

    /// The bits that no entry has claimed so far.
    #[cfg(feature = "defmt")]
    pub(crate) const fn remaining(&self) -> u64 {
        self.remaining
    }

    pub(crate) fn next(&mut self) -> Option<(u64, &'static str)> {
        while let [(value, name), rest @ ..] = self.entries {
            if self.remaining == 0 {
                return None;
            }
            self.entries = rest;
            if self.source & value == *value && self.remaining & value != 0 {
                self.remaining &= !value;
                return Some((*value, name));
            }
        }
        None
    }
}

/// Without what the sign of a number left above.
const fn low_bits(bits: u64, width: u32) -> u64 {
    bits & (u64::MAX >> (u64::BITS - width))
}

/// Iterator over the entries of a flags value, and in the end the bits that no entry names.
#[derive(Clone, Debug)]
pub struct Iter<F> {
    contained: Contained,
    flags: PhantomData<F>,
}

impl<F> Iter<F> {
    #[doc(hidden)]
    pub const fn new(info: &'static EnumInfo, bits: u64, width: u32) -> Self {
        Self { contained: Contained::new(info, low_bits(bits, width)), flags: PhantomData }
    }
}

impl<F: Enum> Iterator for Iter<F> {
    type Item = F;

    fn next(&mut self) -> Option<F> {
        let bits = match self.contained.next() {
            Some((bits, _)) => bits,
            None => core::mem::take(&mut self.contained.remaining),
        };
        if bits == 0 { None } else { Some(F::from_repr(F::Repr::from_bits(bits))) }
    }
}

/// Iterator over the entries of a flags value with their names in the XML.
#[derive(Clone, Debug)]
pub struct IterNames<F> {
    contained: Contained,
    flags: PhantomData<F>,
}

impl<F> IterNames<F> {
    #[doc(hidden)]
    pub const fn new(info: &'static EnumInfo, bits: u64, width: u32) -> Self {
        Self { contained: Contained::new(info, low_bits(bits, width)), flags: PhantomData }
    }
}

impl<F: Enum> IterNames<F> {
    /// The bits that were not yielded so far; after the end, those that no entry names.
    #[must_use]
    pub fn remaining(&self) -> F {
        F::from_repr(F::Repr::from_bits(self.contained.remaining))
    }
}

impl<F: Enum> Iterator for IterNames<F> {
    type Item = (&'static str, F);

    fn next(&mut self) -> Option<Self::Item> {
        let (bits, name) = self.contained.next()?;
        Some((name, F::from_repr(F::Repr::from_bits(bits))))
    }
}

/// All bits of these flags together.
#[doc(hidden)]
pub fn union<F: Enum>(first: F, others: impl IntoIterator<Item = F>) -> F {
    let bits = others.into_iter().fold(first.repr().bits(), |bits, flags| bits | flags.repr().bits());
    F::from_repr(F::Repr::from_bits(bits))
}

/// Writes `A | B | 0x40`: names in the XML, then the bits without one; `0` for none.
///
/// # Errors
///
/// Those of the formatter.
#[doc(hidden)]
pub fn fmt_flags<F: Enum>(flags: &F, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    fmt_bits(F::INFO, flags.repr().bits(), f)
}

/// Reads what [`fmt_flags`] writes, and decimal numbers.
///
/// # Errors
///
/// A name is unknown, or a bit does not fit.
#[doc(hidden)]
pub fn parse_flags<F: Enum>(text: &str) -> Result<F, UnknownName> {
    let bits = parse_bits(F::INFO, F::Repr::from_bits(u64::MAX).bits(), text)?;
    Ok(F::from_repr(F::Repr::from_bits(bits)))
}

pub(crate) fn fmt_bits(info: &EnumInfo, bits: u64, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if bits == 0 {
        return f.write_str("0");
    }
    let (mut contained, mut separator) = (Contained::new(info, bits), "");
    while let Some((_, name)) = contained.next() {
        f.write_str(separator)?;
        f.write_str(name)?;
        separator = " | ";
    }
    match contained.remaining {
        0 => Ok(()),
        rest => write!(f, "{separator}{rest:#x}"),
    }
}

/// Bits outside `mask` do not fit.
pub(crate) fn parse_bits(info: &'static EnumInfo, mask: u64, text: &str) -> Result<u64, UnknownName> {
    let mut bits = 0;
    for word in text.split('|') {
        let word = word.trim();
        bits |= number(word).or_else(|| info.entry_value(word)).ok_or(UnknownName::of(info))?;
    }
    if bits & !mask == 0 { Ok(bits) } else { Err(UnknownName::of(info)) }
}
