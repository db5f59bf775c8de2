//! What is known of frames: ids, times, counters, streams, and frames themselves.

use core::fmt;

use serde_core::de::{Deserialize, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Unexpected, Visitor};
use serde_core::ser::{Error as _, Serialize, SerializeStruct, Serializer};

use super::held::Name;
use super::record::{Record, record};
#[cfg(feature = "signing")]
use crate::signing::Stream;
use crate::{ComponentId, Dialect, EncodeError, Frame, FrameBuf, Received, Statistics, SystemId, Timestamp, Version};

/// Implements both traits for what is a number, of which some are not allowed.
macro_rules! number {
    ($name:ident as $int:ident, $serialize:ident, $to:expr, $from:expr, $expected:literal) => {
        impl Serialize for $name {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.$serialize($to(*self))
            }
        }

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let number = $int::deserialize(deserializer)?;
                let expected: &'static str = $expected;
                $from(number).ok_or_else(|| D::Error::invalid_value(Unexpected::Unsigned(number.into()), &expected))
            }
        }
    };
}

// 32 bits, so that data outlives ids of 8.
number!(
    SystemId as u32,
    serialize_u32,
    SystemId::to_u32,
    |id: u32| id.try_into().ok().map(SystemId::from_u8),
    "an id up to 255"
);
number!(
    ComponentId as u32,
    serialize_u32,
    ComponentId::to_u32,
    |id: u32| id.try_into().ok().map(ComponentId::from_u8),
    "an id up to 255"
);
number!(
    Timestamp as u64,
    serialize_u64,
    Timestamp::units,
    |units| { (units <= Timestamp::MAX.units()).then_some(Timestamp::new(units)) },
    "units of 10 µs in 48 bits"
);
number!(
    Version as u8,
    serialize_u8,
    |version| if version == Version::V1 { 1 } else { 2 },
    |number| match number {
        1 => Some(Version::V1),
        2 => Some(Version::V2),
        _ => None,
    },
    "1 or 2"
);

record!(Statistics { frames: u64, unverified: u64, bad_checksums: u64, skipped_bytes: u64 });
record!(Received {
    system_id: SystemId,
    component_id: ComponentId,
    received: u64,
    lost: u64,
    late: u64,
    duplicates: u64,
    restarts: u64,
});
#[cfg(feature = "signing")]
record!(Stream { link_id: u8, system_id: SystemId, component_id: ComponentId, timestamp: Timestamp });
record!(Header { system_id: SystemId, component_id: ComponentId, sequence: u8 });
record!(Envelope<M> { header: Header, message: M });

/// Who sent a message, and under which number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Header {
    /// Id of the sending system.
    pub system_id: SystemId,
    /// Id of the sending component of that system.
    pub component_id: ComponentId,
    /// Number of the frame.
    pub sequence: u8,
}

/// A message with its header, as `mavlink2rest` writes and reads it:
///
/// ```json
/// { "header": { "system_id": 1, "component_id": 1, "sequence": 7 }, "message": { "type": "HEARTBEAT", … } }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Envelope<M> {
    /// Who sent it.
    pub header: Header,
    /// What was sent: a dialect's enum, or a message.
    pub message: M,
}

impl Header {
    /// The header of a frame.
    #[must_use]
    pub fn of(frame: &Frame<'_>) -> Self {
        Self { system_id: frame.system_id(), component_id: frame.component_id(), sequence: frame.sequence() }
    }
}

impl<M> Envelope<M> {
    /// A message under this header.
    #[must_use]
    pub const fn new(header: Header, message: M) -> Self {
        Self { header, message }
    }
}

impl<D: Dialect> Envelope<D> {
    /// Header and message of a frame; `None` where [`Frame::message`] gives `None`.
    #[must_use]
    pub fn of(frame: &Frame<'_>) -> Option<Self> {
        frame.message().map(|message| Self::new(Header::of(frame), message))
    }
}

/// In text its header and all of its bytes in hexadecimal, else the bytes alone. Not a frame that
/// [carries a key](Frame::carries_key): that is an error.
impl Serialize for Frame<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.carries_key() {
            return Err(S::Error::custom(EncodeError::CarriesKey));
        }
        if !serializer.is_human_readable() {
            return serializer.serialize_bytes(self.bytes());
        }
        let mut fields = serializer.serialize_struct("Frame", 6)?;
        fields.serialize_field("version", &self.version())?;
        fields.serialize_field("system_id", &self.system_id())?;
        fields.serialize_field("component_id", &self.component_id())?;
        fields.serialize_field("sequence", &self.sequence())?;
        fields.serialize_field("message_id", &self.message_id())?;
        fields.serialize_field("bytes", &Hexadecimal(self.bytes()))?;
        fields.end()
    }
}

/// As its [`Frame`].
impl Serialize for FrameBuf {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.as_frame().serialize(serializer)
    }
}

/// Two digits for a byte.
struct Hexadecimal<'b>(&'b [u8]);

impl Serialize for Hexadecimal<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl fmt::Display for Hexadecimal<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}
