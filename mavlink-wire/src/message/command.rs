//! Typed commands: an entry of `MAV_CMD` with its params as fields, over `COMMAND_LONG` and `COMMAND_INT`.
//!
//! A command says which param each of its fields is. The conversion of params to both messages is here.

mod carrier;
mod error;

pub use carrier::Params;
pub use error::{CommandError, ParamError};

use crate::{ComponentId, Message, SystemId};

/// A command of a dialect: an entry of `MAV_CMD`, with its params as fields.
///
/// [`AsLong::long`] and [`AsInt::int`] make messages of it. `TryFrom` of a reference to either message reads it, and fails for
/// another command. Params without a field are sent with their default, and ignored on receipt.
pub trait Command: Copy + 'static {
    /// Its number in `MAV_CMD`.
    const ID: u16;

    /// The defaults of the XML. Without one, a coordinate is NaN ("not known"), and any other param zero.
    const DEFAULT: Self;

    /// Maps fields to params: writes the fields to a message that is being made, and reads them from a received one.
    #[doc(hidden)]
    fn params(&mut self, params: &mut Params);
}

/// A command of a dialect that has `COMMAND_LONG`: seven floats.
pub trait AsLong: Command {
    /// The dialect's `COMMAND_LONG`.
    type Long: Message;

    /// The command for this system and component; zero means all. Each param is sent as the nearest float, so that latitude and
    /// longitude are off by up to a metre. [`AsInt::int`] sends them exactly.
    ///
    /// # Errors
    /// [`CommandError::Param`] if a float cannot represent the value of an enum, or a number is greater than any float.
    #[inline]
    fn long(
        &self,
        system_id: impl Into<SystemId>,
        component_id: impl Into<ComponentId>,
    ) -> Result<Self::Long, CommandError> {
        const { assert!(Self::Long::INFO.id == 76 && Self::Long::INFO.crc_extra == 152, "this is COMMAND_LONG") }
        let params = Params::long((system_id.into(), component_id.into()));
        Ok(Self::Long::decode(&params.made_of(self)?))
    }
}

/// A command of a dialect that has `COMMAND_INT`: params 5 and 6 are integers, so that coordinates are exact.
pub trait AsInt: Command {
    /// The dialect's `COMMAND_INT`.
    type Int: Message;

    /// The dialect's `MAV_FRAME`.
    type Frame: Into<u8>;

    /// The command for this system and component; zero means all. The frame says how coordinates are sent: latitude and longitude
    /// in 1e-7 degrees, or in local frames x and y in 1e-4 metres. A command without coordinates ignores the frame.
    ///
    /// # Errors
    /// - [`CommandError::Param`] if param 5 or 6 does not fit an `int32_t`, or is not a whole number although it is no coordinate.
    /// - [`CommandError::Param`] if a float cannot represent the value of an enum.
    /// - [`CommandError::Frame`] if coordinates have no meaning in the frame.
    #[inline]
    fn int(
        &self,
        frame: Self::Frame,
        system_id: impl Into<SystemId>,
        component_id: impl Into<ComponentId>,
    ) -> Result<Self::Int, CommandError> {
        const { assert!(Self::Int::INFO.id == 75 && Self::Int::INFO.crc_extra == 158, "this is COMMAND_INT") }
        let params = Params::int((system_id.into(), component_id.into()), frame.into());
        Ok(Self::Int::decode(&params.made_of(self)?))
    }
}

/// Reads a command from a `COMMAND_LONG`.
#[doc(hidden)]
#[inline]
pub fn from_long<C: Command, M: Message>(message: &M) -> Result<C, CommandError> {
    Params::of_long(&payload(message)).read()
}

/// Reads a command from a `COMMAND_INT`.
#[doc(hidden)]
#[inline]
pub fn from_int<C: Command, M: Message>(message: &M) -> Result<C, CommandError> {
    Params::of_int(&payload(message)).read()
}

fn payload<M: Message>(message: &M) -> [u8; crate::MAX_PAYLOAD] {
    let mut payload = [0; crate::MAX_PAYLOAD];
    crate::Encode::write(message, &mut payload);
    payload
}

/// Implements the rest of a command: `Default`, and the conversions to the dialect's messages that carry it.
///
/// `command!(NavTakeoff, long CommandLong, int CommandInt, MavFrame)`; a dialect has both messages, or one.
#[macro_export]
macro_rules! command {
    ($name:ident $(, long $long:ty)? $(, int $int:ty, $frame:ty)?) => {
        impl ::core::default::Default for $name {
            #[inline]
            fn default() -> Self {
                <Self as $crate::Command>::DEFAULT
            }
        }

        $(
            impl $crate::AsLong for $name {
                type Long = $long;
            }

            impl ::core::convert::TryFrom<&$long> for $name {
                type Error = $crate::CommandError;

                #[inline]
                fn try_from(message: &$long) -> ::core::result::Result<Self, $crate::CommandError> {
                    $crate::generated::from_long(message)
                }
            }
        )?

        $(
            impl $crate::AsInt for $name {
                type Int = $int;
                type Frame = $frame;
            }

            impl ::core::convert::TryFrom<&$int> for $name {
                type Error = $crate::CommandError;

                #[inline]
                fn try_from(message: &$int) -> ::core::result::Result<Self, $crate::CommandError> {
                    $crate::generated::from_int(message)
                }
            }
        )?
    };
}
