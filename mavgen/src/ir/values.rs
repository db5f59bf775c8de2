//! Enums, entries and command parameters of the resolved dialect.

use std::ops::RangeInclusive;

use super::{EnumId, FileIndex, Limits, Name, Origin};
use crate::order;

/// An enum or, with [`Enum::bitmask`], a set of flags.
#[derive(Clone, Debug)]
pub struct Enum {
    /// Its name, at the oldest definition: that of a file which others include, before those that include it.
    pub name: Name,
    /// Whether values are combined bit by bit.
    pub bitmask: bool,
    /// The integer that its values are.
    pub repr: Repr,
    /// The entries by value, merged over all files.
    pub entries: Vec<Entry>,
    /// The file in which [`Enum::name`] was written: the oldest that defines it.
    pub named_in: FileIndex,
    /// The defining file: of all that define it, the one that most of the others include.
    ///
    /// Width, sign and name prefix come from there, so that a dialect that adds entries changes no type of the file it
    /// includes.
    pub defined_in: FileIndex,
    /// Where it comes from: its first definition in merge order, with the first description that is not empty.
    pub origin: Origin,
}

impl Enum {
    /// Every file that it is written in, once: the defining one, those that add entries, and the overlays.
    pub fn files(&self) -> Vec<FileIndex> {
        let origins = self.entries.iter().map(|entry| &entry.origin);
        let mut files = Origin::files_of([&self.origin].into_iter().chain(origins));
        files.push(self.defined_in);
        order::sort_and_dedup(&mut files);
        files
    }
}

/// An entry of an enum.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Its name, with the prefix that entries of the enum share.
    pub name: Name,
    /// Its value.
    pub value: u64,
    /// Whether the value was assigned automatically.
    pub auto: bool,
    /// What it says as a command: `Some` in enums of commands.
    pub command: Option<Command>,
    /// Where it comes from.
    pub origin: Origin,
}

/// What an entry says as a command (`MAV_CMD`).
#[derive(Clone, Debug, Default)]
pub struct Command {
    /// The parameters that the XML lists, by index.
    pub params: Vec<Param>,
    /// `hasLocation`: params 5, 6 and 7 are a place.
    pub has_location: bool,
    /// `isDestination`: the place is one to go to.
    pub is_destination: bool,
    /// `missionOnly`: not to be sent as a command.
    pub mission_only: bool,
}

/// The indices of the params that commands carry.
pub(crate) const PARAMS: RangeInclusive<u8> = 1..=7;

/// A parameter of a command.
#[derive(Clone, Debug)]
pub struct Param {
    /// 1 to 7.
    pub index: u8,
    /// Its label, as the XML spells it.
    pub label: Option<String>,
    /// The unit, as the XML spells it.
    pub units: Option<String>,
    /// The enum whose values it carries.
    pub enum_: Option<EnumId>,
    /// Documented range and step.
    pub limits: Limits,
    /// `default`: a number or NaN.
    pub default: Option<f64>,
    /// Not to be used: to be sent as its default.
    pub reserved: bool,
    /// Where it comes from.
    pub origin: Origin,
}

/// The integer types that can stand behind an enum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Repr {
    /// `u8`.
    U8,
    /// `i8`.
    I8,
    /// `u16`.
    U16,
    /// `i16`.
    I16,
    /// `u32`.
    U32,
    /// `i32`.
    I32,
    /// `u64`.
    U64,
    /// `i64`.
    I64,
}

impl Repr {
    /// Name, bytes, and whether it can be negative.
    fn facts(self) -> (&'static str, usize, bool) {
        match self {
            Self::U8 => ("u8", 1, false),
            Self::I8 => ("i8", 1, true),
            Self::U16 => ("u16", 2, false),
            Self::I16 => ("i16", 2, true),
            Self::U32 => ("u32", 4, false),
            Self::I32 => ("i32", 4, true),
            Self::U64 => ("u64", 8, false),
            Self::I64 => ("i64", 8, true),
        }
    }

    /// Bytes.
    pub fn size(self) -> usize {
        self.facts().1
    }

    /// Whether it can be negative.
    pub fn is_signed(self) -> bool {
        self.facts().2
    }

    /// What it is called: `u8`.
    pub fn name(self) -> &'static str {
        self.facts().0
    }

    /// The largest value it can hold.
    pub fn highest(self) -> u64 {
        let bits = 8 * self.size() - usize::from(self.is_signed());
        u64::MAX >> (64 - bits)
    }

    /// The smallest unsigned type that holds `value`.
    pub fn smallest_for(value: u64) -> Self {
        [Self::U8, Self::U16, Self::U32].into_iter().find(|repr| value <= repr.highest()).unwrap_or(Self::U64)
    }
}
