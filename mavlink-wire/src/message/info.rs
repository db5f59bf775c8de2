//! Metadata of messages, enums and commands: what the XML says beyond the bytes.

use core::fmt;

use super::{enums, flags};

/// What a frame needs to know about a message; one per message, shared by every table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct MessageInfo {
    /// Message id, at most 24 bits. Only ids up to 255 exist in MAVLink 1.
    pub id: u32,
    /// Name in the XML, `GPS_RAW_INT`.
    pub name: &'static str,
    /// Last byte of the checksum, not transmitted: a digest of the message's layout.
    pub crc_extra: u8,
    /// Payload length in bytes without extension fields: what MAVLink 1 sends.
    pub len_v1: u8,
    /// Payload length in bytes with extension fields, before MAVLink 2 cuts trailing zeros.
    pub len_v2: u8,
    /// Offset of the addressed system's id in the payload, if the message has an addressee.
    pub target_system: Option<u8>,
    /// Offset of the addressed component's id in the payload.
    pub target_component: Option<u8>,
}

impl MessageInfo {
    /// A message without extension fields and addressee: its id, its name in the XML, the last byte of its checksum and the
    /// length of its payload.
    #[must_use]
    pub const fn new(id: u32, name: &'static str, crc_extra: u8, length: u8) -> Self {
        Self { id, name, crc_extra, len_v1: length, len_v2: length, target_system: None, target_component: None }
    }

    /// Sets the payload length without extension fields.
    #[must_use]
    pub const fn len_v1(mut self, length: u8) -> Self {
        self.len_v1 = length;
        self
    }

    /// Sets the offset of the addressed system's id.
    #[must_use]
    pub const fn target_system(mut self, offset: u8) -> Self {
        self.target_system = Some(offset);
        self
    }

    /// Sets the offset of the addressed component's id.
    #[must_use]
    pub const fn target_component(mut self, offset: u8) -> Self {
        self.target_component = Some(offset);
        self
    }
}

/// An enum of the XML: its name and its entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct EnumInfo {
    /// Name in the XML, `MAV_STATE`.
    pub name: &'static str,
    /// Whether the entries are bits to be combined.
    pub bitmask: bool,
    /// Value and name in the XML of every entry, in ascending order of values. Only an enum that several dialects share can
    /// have two names for a value.
    pub entries: &'static [(u64, &'static str)],
}

impl EnumInfo {
    /// An enum of single values: its name in the XML, and the value and name of every entry by value.
    #[must_use]
    pub const fn new(name: &'static str, entries: &'static [(u64, &'static str)]) -> Self {
        Self { name, bitmask: false, entries }
    }

    /// An enum of bits to be combined.
    #[must_use]
    pub const fn bitmask(name: &'static str, entries: &'static [(u64, &'static str)]) -> Self {
        Self { bitmask: true, ..Self::new(name, entries) }
    }

    /// The name in the XML of the entry with this value; the first, if there are two.
    #[must_use]
    pub fn entry_name(&self, value: u64) -> Option<&'static str> {
        let at = self.entries.partition_point(|&(smaller, _)| smaller < value);
        self.entries.get(at).filter(|&&(found, _)| found == value).map(|&(_, name)| name)
    }

    /// The value of the entry with this name in the XML.
    #[must_use]
    pub fn entry_value(&self, name: &str) -> Option<u64> {
        self.entries.iter().find(|(_, known)| *known == name).map(|&(value, _)| value)
    }

    /// The value as text: the name of its entry in the XML, or the number if there is none; for a bitmask `A | B | 0x40`,
    /// and `0` for no bits.
    #[must_use]
    pub fn display(&self, value: u64) -> impl fmt::Display + use<'_> {
        Shown { info: self, value }
    }

    /// All bits that some entry has.
    #[must_use]
    pub const fn all_bits(&self) -> u64 {
        let (mut bits, mut rest) = (0, self.entries);
        while let [(value, _), tail @ ..] = rest {
            bits |= *value;
            rest = tail;
        }
        bits
    }
}

struct Shown<'a> {
    info: &'a EnumInfo,
    value: u64,
}

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.info.bitmask {
            flags::fmt_bits(self.info, self.value, f)
        } else {
            enums::fmt_named(self.info, self.value, &self.value, f)
        }
    }
}

/// A parameter of a command (`MAV_CMD` entry); on the wire always a float, or an integer for 5 and 6 of `COMMAND_INT`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ParamInfo {
    /// 1 to 7.
    pub index: u8,
    /// Short name for display.
    pub label: Option<&'static str>,
    /// Unit in the XML's spelling.
    pub units: Option<&'static str>,
    /// Name in the XML of the enum that lists the values.
    pub values: Option<&'static str>,
    /// Smallest sensible value.
    pub min: Option<f32>,
    /// Largest sensible value.
    pub max: Option<f32>,
    /// Step between sensible values.
    pub increment: Option<f32>,
    /// Value to send when nothing else is known; may be NaN.
    pub default: Option<f32>,
    /// Not in use: send `default`, or zero.
    pub reserved: bool,
}

impl ParamInfo {
    /// A parameter about which nothing is known but its index, 1 to 7.
    #[must_use]
    pub const fn new(index: u8) -> Self {
        Self {
            index,
            label: None,
            units: None,
            values: None,
            min: None,
            max: None,
            increment: None,
            default: None,
            reserved: false,
        }
    }

    /// Sets the short name.
    #[must_use]
    pub const fn label(mut self, label: &'static str) -> Self {
        self.label = Some(label);
        self
    }

    /// Sets the unit, in the XML's spelling.
    #[must_use]
    pub const fn units(mut self, units: &'static str) -> Self {
        self.units = Some(units);
        self
    }

    /// Sets the name in the XML of the enum that lists the values.
    #[must_use]
    pub const fn values(mut self, name: &'static str) -> Self {
        self.values = Some(name);
        self
    }

    /// Sets the smallest sensible value.
    #[must_use]
    pub const fn min(mut self, min: f32) -> Self {
        self.min = Some(min);
        self
    }

    /// Sets the largest sensible value.
    #[must_use]
    pub const fn max(mut self, max: f32) -> Self {
        self.max = Some(max);
        self
    }

    /// Sets the step between sensible values.
    #[must_use]
    pub const fn increment(mut self, increment: f32) -> Self {
        self.increment = Some(increment);
        self
    }

    /// Sets the value to send when nothing else is known.
    #[must_use]
    pub const fn default(mut self, default: f32) -> Self {
        self.default = Some(default);
        self
    }

    /// Marks the parameter as not in use.
    #[must_use]
    pub const fn reserved(mut self) -> Self {
        self.reserved = true;
        self
    }
}
