//! Messages and fields of the resolved dialect.

use std::num::NonZeroU8;
use std::ops::RangeInclusive;

use super::{Binding, EnumId, FileIndex, Name, Origin, Repr, View};
use crate::collect::CollectVec as _;
use crate::order;

/// Ids of messages have 24 bits.
pub(crate) const LARGEST_ID: u32 = 0xFF_FFFF;

/// pymavlink's limit on the fields of a message.
pub(crate) const MOST_FIELDS: usize = 64;

/// A message.
#[derive(Clone, Debug)]
pub struct Message {
    /// The id, at most 24 bits.
    pub id: u32,
    /// Its name.
    pub name: Name,
    /// Seeds the checksum of its frames (MAVLink guide, "CRC_EXTRA calculation").
    pub crc_extra: u8,
    /// Payload length in MAVLink 1 in bytes: the fields before `<extensions/>`.
    pub len_v1: u8,
    /// Payload length in MAVLink 2 in bytes, before trailing zeros are trimmed.
    pub len_v2: u8,
    /// The fields in the order of the XML.
    pub fields: Vec<Field>,
    /// Views of packed bits, from overlays.
    pub views: Vec<View>,
    /// Enums that overlays bind to fields.
    pub bindings: Vec<Binding>,
    /// Where it comes from.
    pub origin: Origin,
}

impl Message {
    /// Every file that it is written in, once: its own, and the overlays.
    pub fn files(&self) -> Vec<FileIndex> {
        let origins = self.fields.iter().map(|field| &field.origin);
        Origin::files_of([&self.origin].into_iter().chain(origins))
    }

    /// The fields in wire order: by offset.
    pub fn wire_order(&self) -> Vec<&Field> {
        let mut fields = self.fields.iter().collect_vec();
        order::sort_by_key(&mut fields, |field| field.offset);
        fields
    }

    /// The field that names the system a message is meant for, if it has one that is a plain `uint8_t`.
    ///
    /// `target_system`, or `target` of MANUAL_CONTROL (pymavlink's `native` target offsets).
    pub fn target_system(&self) -> Option<&Field> {
        self.plain_u8("target_system")
            .or_else(|| if self.name.text == "MANUAL_CONTROL" { self.plain_u8("target") } else { None })
    }

    /// The field that names the component a message is meant for, if it has one that is a plain `uint8_t`.
    pub fn target_component(&self) -> Option<&Field> {
        self.plain_u8("target_component")
    }

    /// The field that holds a secret key, which no text may show: `secret_key` of message 256, `SETUP_SIGNING` (MAVLink guide,
    /// "Message Signing").
    pub fn secret(&self) -> Option<&Field> {
        self.fields.iter().find(|field| self.id == 256 && field.name.text == "secret_key")
    }

    fn plain_u8(&self, name: &str) -> Option<&Field> {
        let plain = FieldType { scalar: Scalar::U8, array: None };
        self.fields.iter().find(|field| field.name.text == name && field.ty == plain)
    }
}

/// A field of a message.
#[derive(Clone, Debug)]
pub struct Field {
    /// Its name.
    pub name: Name,
    /// Its type on the wire.
    pub ty: FieldType,
    /// Its first byte in the payload.
    pub offset: u8,
    /// Whether it stands after `<extensions/>`: absent in MAVLink 1, not part of the checksum.
    pub extension: bool,
    /// The enum whose values it carries.
    pub values: Option<Values>,
    /// The unit, as the XML spells it: `cdegC`, `m/s`.
    pub units: Option<String>,
    /// Which value means "not known".
    pub invalid: Option<Invalid>,
    /// Documented range and step.
    pub limits: Limits,
    /// `multiplier`, as the XML spells it: `1E-2`.
    pub multiplier: Option<String>,
    /// `default`, as the XML spells it.
    pub default: Option<String>,
    /// `print_format`, as the XML spells it: `0x%04x`.
    pub print_format: Option<String>,
    /// `display="bitmask"`: best shown as bits.
    pub display_bitmask: bool,
    /// Whether the field tells instances of its sender apart (`instance="true"`).
    pub instance: bool,
    /// Where it comes from.
    pub origin: Origin,
}

impl Field {
    /// Bytes on the wire.
    pub fn size(&self) -> usize {
        self.ty.size()
    }
}

/// The type of a field on the wire.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FieldType {
    /// The element.
    pub scalar: Scalar,
    /// The number of elements; an array of one element is not a scalar (its checksum differs).
    pub array: Option<NonZeroU8>,
}

impl FieldType {
    /// Bytes on the wire.
    pub fn size(self) -> usize {
        self.scalar.size() * self.array.map_or(1, |n| usize::from(n.get()))
    }
}

/// The element types of the wire (MAVLink guide, "Field types").
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Scalar {
    /// `char`.
    Char,
    /// `uint8_t`.
    U8,
    /// `uint8_t_mavlink_version`: a `uint8_t` that senders set to the version of the file.
    Version(u8),
    /// `int8_t`.
    I8,
    /// `uint16_t`.
    U16,
    /// `int16_t`.
    I16,
    /// `uint32_t`.
    U32,
    /// `int32_t`.
    I32,
    /// `uint64_t`.
    U64,
    /// `int64_t`.
    I64,
    /// `float`.
    F32,
    /// `double`.
    F64,
}

impl Scalar {
    /// All of them but the version.
    #[rustfmt::skip]
    pub(crate) const ALL: [Self; 11] = [
        Self::Char, Self::U8, Self::I8, Self::U16, Self::I16, Self::U32, Self::I32, Self::U64, Self::I64, Self::F32, Self::F64,
    ];

    /// Name on the wire, bytes, and the integer that can carry an enum.
    fn facts(self) -> (&'static str, usize, Option<Repr>) {
        match self {
            Self::Char => ("char", 1, None),
            Self::U8 => ("uint8_t", 1, Some(Repr::U8)),
            Self::Version(_) => ("uint8_t", 1, None),
            Self::I8 => ("int8_t", 1, Some(Repr::I8)),
            Self::U16 => ("uint16_t", 2, Some(Repr::U16)),
            Self::I16 => ("int16_t", 2, Some(Repr::I16)),
            Self::U32 => ("uint32_t", 4, Some(Repr::U32)),
            Self::I32 => ("int32_t", 4, Some(Repr::I32)),
            Self::U64 => ("uint64_t", 8, Some(Repr::U64)),
            Self::I64 => ("int64_t", 8, Some(Repr::I64)),
            Self::F32 => ("float", 4, None),
            Self::F64 => ("double", 8, None),
        }
    }

    /// Bytes of one element.
    pub fn size(self) -> usize {
        self.facts().1
    }

    /// The type as the checksum spells it: the version type counts as `uint8_t`.
    pub fn wire_name(self) -> &'static str {
        self.facts().0
    }

    /// The integer that it is; `None` for what carries no enum: floats, characters and the version.
    pub fn repr(self) -> Option<Repr> {
        self.facts().2
    }

    /// Whether a view can read its bits: they are as they were sent, with no sign to drag along and no text to keep.
    pub fn is_word(self) -> bool {
        self.is_unsigned() || self.is_float()
    }

    /// Whether it is an unsigned integer, which can be a count or a switch.
    pub fn is_unsigned(self) -> bool {
        self.repr().is_some_and(|repr| !repr.is_signed())
    }

    /// Whether it is a float or a double.
    pub fn is_float(self) -> bool {
        matches!(self, Self::F32 | Self::F64)
    }

    /// Smallest and largest value; `None` for floats.
    pub fn range(self) -> Option<RangeInclusive<i128>> {
        let bits = 8 * self.size();
        match self.repr() {
            _ if self.is_float() => None,
            Some(repr) if repr.is_signed() => Some(-(1 << (bits - 1))..=(1 << (bits - 1)) - 1),
            _ => Some(0..=(1 << bits) - 1),
        }
    }

    /// Whether a number is finite in it, if it is a float or a double.
    pub(crate) fn holds_float(self, value: f64) -> bool {
        match self {
            Self::F32 => (value as f32).is_finite(),
            Self::F64 => value.is_finite(),
            _ => false,
        }
    }
}

/// How a field carries the values of an enum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Values {
    /// The field has the enum's own width and sign.
    Typed(EnumId),
    /// The field is narrower, wider or of another sign, so that it may not hold every value of the enum.
    Converted(EnumId),
}

impl Values {
    /// The enum.
    pub fn id(self) -> EnumId {
        match self {
            Self::Typed(id) | Self::Converted(id) => id,
        }
    }
}

/// Which value of a field means "not known" (MAVLink guide, "`invalid`").
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Invalid {
    /// Which elements say it.
    pub scope: Scope,
    /// The value; it fits the field.
    pub sentinel: Sentinel,
}

/// Which elements of an array a sentinel is looked for in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Each element for itself, and scalars: `V`, `[V]`.
    Each,
    /// The first element speaks for the whole array: `[V:]`.
    Whole,
    /// Only the first element can be unknown: `[V,]`.
    First,
}

/// The value that means "not known".
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sentinel {
    /// Of an integer or character field.
    Integer(i128),
    /// Of a float or double.
    Float(f64),
    /// Any NaN of a float or double.
    NotANumber,
}

/// A documented range and step; nothing enforces it on the wire.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// `minValue`.
    pub min: Option<f64>,
    /// `maxValue`.
    pub max: Option<f64>,
    /// `increment`.
    pub increment: Option<f64>,
}
