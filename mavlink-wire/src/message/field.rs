//! Metadata of message fields.

use core::fmt;

use crate::EnumInfo;

/// A field of a message. Messages list theirs in the order of the XML; [`offset`](Self::offset) says where each lies.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct FieldInfo {
    /// Name in the XML's spelling.
    pub name: &'static str,
    /// Type of the field, or of one element of it.
    pub kind: Kind,
    /// Number of elements if the field is an array, 1 to 255.
    pub array: Option<u8>,
    /// Offset in the payload, in bytes.
    pub offset: u8,
    /// Added to the message later: not part of `crc_extra`, absent in MAVLink 1.
    pub extension: bool,
    /// Unit in the XML's spelling, `cdegC`.
    pub units: Option<&'static str>,
    /// The enum that lists the values or bits.
    pub values: Option<&'static EnumInfo>,
    /// The value that means "not known".
    pub invalid: Option<Invalid>,
    /// Holds a secret key. `Debug` of the message, [`reflect`](crate::reflect) and `defmt` do not show it; serde, which loses
    /// nothing, carries it.
    pub secret: bool,
}

impl FieldInfo {
    /// A single value at this offset of the payload.
    #[must_use]
    pub const fn new(name: &'static str, kind: Kind, offset: u8) -> Self {
        Self {
            name,
            kind,
            array: None,
            offset,
            extension: false,
            units: None,
            values: None,
            invalid: None,
            secret: false,
        }
    }

    /// An array of `length` elements at this offset of the payload.
    #[must_use]
    pub const fn array(name: &'static str, kind: Kind, length: u8, offset: u8) -> Self {
        Self { array: Some(length), ..Self::new(name, kind, offset) }
    }

    /// Marks an extension field.
    #[must_use]
    pub const fn extension(mut self) -> Self {
        self.extension = true;
        self
    }

    /// Sets the unit, in the XML's spelling.
    #[must_use]
    pub const fn units(mut self, units: &'static str) -> Self {
        self.units = Some(units);
        self
    }

    /// Sets the enum that lists the values or bits.
    #[must_use]
    pub const fn values(mut self, values: &'static EnumInfo) -> Self {
        self.values = Some(values);
        self
    }

    /// Sets the value that means "not known".
    #[must_use]
    pub const fn invalid(mut self, invalid: Invalid) -> Self {
        self.invalid = Some(invalid);
        self
    }

    /// Marks a secret key.
    #[must_use]
    pub const fn secret(mut self) -> Self {
        self.secret = true;
        self
    }

    /// Bytes that the field takes in the payload, all elements together.
    #[must_use]
    pub const fn size(&self) -> usize {
        let elements = match self.array {
            Some(length) => length as usize,
            None => 1,
        };
        elements * self.kind.size()
    }
}

/// The type of a field, or of one element of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// `char`: one byte of text.
    Char,
    /// `uint8_t`.
    U8,
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
    /// `uint8_t_mavlink_version`: a `uint8_t` that senders fill with the version of the XML file.
    Version,
}

impl Kind {
    /// Bytes of one value.
    #[must_use]
    pub const fn size(self) -> usize {
        match self {
            Self::Char | Self::U8 | Self::I8 | Self::Version => 1,
            Self::U16 | Self::I16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
            Self::U64 | Self::I64 | Self::F64 => 8,
        }
    }

    /// The type's name as it enters `crc_extra`: `uint8_t` also for [`Kind::Version`].
    #[must_use]
    pub const fn wire_name(self) -> &'static str {
        match self {
            Self::Char => "char",
            Self::U8 | Self::Version => "uint8_t",
            Self::I8 => "int8_t",
            Self::U16 => "uint16_t",
            Self::I16 => "int16_t",
            Self::U32 => "uint32_t",
            Self::I32 => "int32_t",
            Self::U64 => "uint64_t",
            Self::I64 => "int64_t",
            Self::F32 => "float",
            Self::F64 => "double",
        }
    }
}

/// The type's name in the XML: `uint16_t`, `uint8_t_mavlink_version`.
impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Version => "uint8_t_mavlink_version",
            other => other.wire_name(),
        })
    }
}

/// A value that stands for "not known".
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sentinel {
    /// A value of an unsigned field.
    Unsigned(u64),
    /// A value of a signed field.
    Signed(i64),
    /// A value of a floating point field.
    Float(f64),
    /// Any NaN.
    NotANumber,
}

/// The value, or `NaN`.
impl fmt::Display for Sentinel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unsigned(value) => value.fmt(f),
            Self::Signed(value) => value.fmt(f),
            Self::Float(value) => value.fmt(f),
            Self::NotANumber => f.pad("NaN"),
        }
    }
}

/// Which elements an `invalid` attribute speaks about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Invalid {
    /// `V` or `[V]`: the field, or every element of its own.
    Each(Sentinel),
    /// `[V:]`: this value in the first element says that no element is known.
    All(Sentinel),
    /// `[V,]`: only the first element can be unknown.
    First(Sentinel),
}

/// As in the XML: `65535`, `[65535:]`, `[65535,]`.
impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Each(sentinel) => sentinel.fmt(f),
            Self::All(sentinel) => write!(f, "[{sentinel}:]"),
            Self::First(sentinel) => write!(f, "[{sentinel},]"),
        }
    }
}
