//! How four bytes carry a value of any type.

use super::number::Number;
use super::{ParamValue, ValueError};
use crate::common::{MavAutopilot, MavParamType, MavProtocolCapability};

/// What a component puts into the field `param_value`, which is a float whatever the parameter is.
///
/// There are two habits, and nothing in a parameter's message tells which: both sides have to know.
///
/// ```
/// use mavlink_services::common::{MavAutopilot, MavParamType, MavProtocolCapability};
/// use mavlink_services::param::{Encoding, ParamValue, ValueError};
///
/// let capabilities = MavProtocolCapability::PARAM_ENCODE_BYTEWISE;
/// assert_eq!(Encoding::of(Some(capabilities), MavAutopilot::GENERIC), Encoding::Bytewise);
/// assert_eq!(Encoding::of(None, MavAutopilot::ARDUPILOTMEGA), Encoding::Cast);
///
/// let value = ParamValue::I32(-123_456_789);
/// assert_eq!(Encoding::Bytewise.encode(value).map(f32::to_bits), Ok(-123_456_789_i32 as u32));
/// assert_eq!(Encoding::Cast.encode(value), Err(ValueError::Inexact));
/// assert_eq!(Encoding::Cast.encode(ParamValue::I32(-5)), Ok(-5.0));
/// assert_eq!(Encoding::Cast.decode(-5.0, MavParamType::INT32), Ok(ParamValue::I32(-5)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// The bytes of the value, whatever its type: as PX4 does. Types of 64 bits do not fit.
    Bytewise,
    /// The value as a float: as ArduPilot does. An integer of more than 24 binary digits does not fit.
    Cast,
}

impl Encoding {
    /// What a component uses, by the capabilities in its `AUTOPILOT_VERSION`, if they say; else by the autopilot in its
    /// `HEARTBEAT`: ArduPilot casts, all others do as the MAVLink guide has it, bytewise.
    #[must_use]
    pub fn of(capabilities: Option<MavProtocolCapability>, autopilot: MavAutopilot) -> Self {
        let says = |flag| capabilities.is_some_and(|capabilities| capabilities.contains(flag));
        let bytewise = says(MavProtocolCapability::PARAM_ENCODE_BYTEWISE);
        let cast = says(MavProtocolCapability::PARAM_ENCODE_C_CAST);
        match (bytewise, cast) {
            (true, false) => Self::Bytewise,
            (false, true) => Self::Cast,
            // Both or none: it does not say.
            _ if autopilot == MavAutopilot::ARDUPILOTMEGA => Self::Cast,
            _ => Self::Bytewise,
        }
    }

    /// The capability that says so, for the `AUTOPILOT_VERSION` of a component.
    #[must_use]
    pub const fn capability(self) -> MavProtocolCapability {
        match self {
            Self::Bytewise => MavProtocolCapability::PARAM_ENCODE_BYTEWISE,
            Self::Cast => MavProtocolCapability::PARAM_ENCODE_C_CAST,
        }
    }

    /// The field `param_value` for a value; `param_type` is its [`kind`](ParamValue::kind).
    ///
    /// # Errors
    ///
    /// The field cannot carry the value: it would arrive as another one.
    pub fn encode(self, value: ParamValue) -> Result<f32, ValueError> {
        match self {
            Self::Cast => Number::from(value).f32(),
            Self::Bytewise => Ok(f32::from_bits(match value {
                ParamValue::U8(value) => value.into(),
                ParamValue::I8(value) => value.cast_unsigned().into(),
                ParamValue::U16(value) => value.into(),
                ParamValue::I16(value) => value.cast_unsigned().into(),
                ParamValue::U32(value) => value,
                ParamValue::I32(value) => value.cast_unsigned(),
                ParamValue::F32(value) => value.to_bits(),
                ParamValue::U64(_) | ParamValue::I64(_) | ParamValue::F64(_) => return Err(ValueError::TooWide),
            })),
        }
    }

    /// The value that the fields `param_value` and `param_type` carry.
    ///
    /// # Errors
    ///
    /// The type is unknown or does not fit, or the float is not a value of that type: then the sender may use the other encoding.
    pub fn decode(self, field: f32, kind: MavParamType) -> Result<ParamValue, ValueError> {
        if self == Self::Cast {
            return ParamValue::F32(field).to_kind(kind);
        }
        let bits = field.to_bits();
        Ok(match kind {
            MavParamType::UINT8 => ParamValue::U8(bits as u8),
            MavParamType::INT8 => ParamValue::I8(bits as i8),
            MavParamType::UINT16 => ParamValue::U16(bits as u16),
            MavParamType::INT16 => ParamValue::I16(bits as i16),
            MavParamType::UINT32 => ParamValue::U32(bits),
            MavParamType::INT32 => ParamValue::I32(bits.cast_signed()),
            MavParamType::REAL32 => ParamValue::F32(field),
            MavParamType::UINT64 | MavParamType::INT64 | MavParamType::REAL64 => return Err(ValueError::TooWide),
            _ => return Err(ValueError::UnknownType(kind)),
        })
    }
}
