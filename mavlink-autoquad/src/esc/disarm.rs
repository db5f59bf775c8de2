//! Why a motor controller disarmed.

use core::fmt;

use crate::autoquad::{Esc32DisarmV2, Esc32DisarmV3, Esc32State, Esc32Status, EscFailureFlags};
use crate::wire;

/// Why an ESC32 disarmed: one type for the numbers of both firmware versions, which differ.
///
/// Three bits carry the reason, and both versions know more than eight. Version 2 sends its `CAN_TIMEOUT`, 8, as
/// [`Startup`](Self::Startup) (ESC32 `main.h`). The numbers of version 3 are known from AutoQuad's ground station alone
/// (`ESCtelemetryWidget.h`); how it sends `LOW_VOLTAGE`, 8, and `CAN_TIMEOUT`, 9, is not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum DisarmReason {
    /// No reason; only version 3 says so.
    None,
    /// It has not been armed since it started.
    Startup,
    /// Too many zero crossings of the motor were missed.
    BadDetects,
    /// No zero crossing of the motor came in time.
    CrossingTimeout,
    /// The PWM input fell silent.
    PwmTimeout,
    /// The input voltage was too low.
    LowVoltage,
    /// A command on its text interface.
    CliUser,
    /// A command of its binary protocol.
    BinaryUser,
    /// A command over CAN.
    CanUser,
    /// A number without a meaning.
    Undefined(u8),
}

wire::variants!(
    DisarmReason {
        None, Startup, BadDetects, CrossingTimeout, PwmTimeout, LowVoltage, CliUser, BinaryUser, CanUser
    } Undefined(u8)
);

impl DisarmReason {
    /// The reason of a controller that is disarmed; `None` in any other state, where the bits mean nothing.
    #[must_use]
    pub fn of(status: Esc32Status) -> Option<Self> {
        if status.state() != Esc32State::DISARMED {
            return None;
        }
        status.disarm_v3().map(Self::from).or_else(|| status.disarm_v2().map(Self::from))
    }

    /// Whether it is a fault, and not somebody's wish or the state after a start. What is undefined is one.
    ///
    /// As AutoQuad's ground station decides (`ESCtelemetryWidget.cpp`).
    #[must_use]
    pub const fn is_fault(self) -> bool {
        !matches!(self, Self::None | Self::Startup | Self::CliUser | Self::BinaryUser | Self::CanUser)
    }

    /// The nearest failures of `ESC_INFO`; empty if it is not a fault.
    #[must_use]
    pub const fn failure_flags(self) -> EscFailureFlags {
        match self {
            Self::BadDetects | Self::CrossingTimeout => EscFailureFlags::MOTOR_STUCK,
            Self::PwmTimeout => EscFailureFlags::INCONSISTENT_CMD,
            Self::LowVoltage | Self::Undefined(_) => EscFailureFlags::GENERIC,
            Self::None | Self::Startup | Self::CliUser | Self::BinaryUser | Self::CanUser => EscFailureFlags::empty(),
        }
    }
}

impl From<Esc32DisarmV2> for DisarmReason {
    fn from(reason: Esc32DisarmV2) -> Self {
        match reason {
            Esc32DisarmV2::STARTUP => Self::Startup,
            Esc32DisarmV2::BAD_DETECTS => Self::BadDetects,
            Esc32DisarmV2::CROSSING_TIMEOUT => Self::CrossingTimeout,
            Esc32DisarmV2::PWM_TIMEOUT => Self::PwmTimeout,
            Esc32DisarmV2::LOW_VOLTAGE => Self::LowVoltage,
            Esc32DisarmV2::CLI_USER => Self::CliUser,
            Esc32DisarmV2::BINARY_USER => Self::BinaryUser,
            Esc32DisarmV2::CAN_USER => Self::CanUser,
            other => Self::Undefined(other.into()),
        }
    }
}

impl From<Esc32DisarmV3> for DisarmReason {
    fn from(reason: Esc32DisarmV3) -> Self {
        match reason {
            Esc32DisarmV3::NONE => Self::None,
            Esc32DisarmV3::CLI_USER => Self::CliUser,
            Esc32DisarmV3::BINARY_USER => Self::BinaryUser,
            Esc32DisarmV3::CAN_USER => Self::CanUser,
            Esc32DisarmV3::STARTUP => Self::Startup,
            Esc32DisarmV3::BAD_DETECTS => Self::BadDetects,
            Esc32DisarmV3::CROSSING_TIMEOUT => Self::CrossingTimeout,
            Esc32DisarmV3::PWM_TIMEOUT => Self::PwmTimeout,
            other => Self::Undefined(other.into()),
        }
    }
}

impl fmt::Display for DisarmReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::None => "no reason",
            Self::Startup => "not armed since it started",
            Self::BadDetects => "zero crossings missed",
            Self::CrossingTimeout => "no zero crossing in time",
            Self::PwmTimeout => "PWM input silent",
            Self::LowVoltage => "voltage too low",
            Self::CliUser => "by a text command",
            Self::BinaryUser => "by a binary command",
            Self::CanUser => "by a CAN command",
            Self::Undefined(number) => return write!(f, "undefined reason {number}"),
        })
    }
}
