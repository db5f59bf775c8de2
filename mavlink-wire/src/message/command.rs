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
/// [`long`](Self::long) and [`int`](Self::int) make messages of it; [`from_long`](Self::from_long) and
/// [`from_int`](Self::from_int) read it, and fail for another command. Params without a field are sent with their default, and
/// ignored on receipt.
pub trait Command: Copy + 'static {
    /// The messages of the dialect that carry it.
    type Carriers;

    /// Its number in `MAV_CMD`.
    const ID: u16;

    /// The defaults of the XML. Without one, a coordinate is NaN ("not known"), and any other param zero.
    const DEFAULT: Self;

    /// Maps fields to params: writes the fields to a message that is being made, and reads them from a received one.
    #[doc(hidden)]
    fn params(&mut self, params: &mut Params);

    /// The command for this system and component; zero means all. Each param is sent as the nearest float, so that latitude and
    /// longitude are off by up to a metre. [`int`](Self::int) sends them exactly.
    ///
    /// # Errors
    /// [`CommandError::Param`] if a float cannot represent the value of an enum, or a number is greater than any float.
    #[inline]
    fn long(
        &self,
        system_id: impl Into<SystemId>,
        component_id: impl Into<ComponentId>,
    ) -> Result<<Self::Carriers as CarriesLong>::Long, CommandError>
    where
        Self::Carriers: CarriesLong,
    {
        const { is_long::<<Self::Carriers as CarriesLong>::Long>() }
        let params = Params::long((system_id.into(), component_id.into()));
        Ok(Message::decode(&params.made_of(self)?))
    }

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
        frame: <Self::Carriers as CarriesInt>::Frame,
        system_id: impl Into<SystemId>,
        component_id: impl Into<ComponentId>,
    ) -> Result<<Self::Carriers as CarriesInt>::Int, CommandError>
    where
        Self::Carriers: CarriesInt,
    {
        const { is_int::<<Self::Carriers as CarriesInt>::Int>() }
        let params = Params::int((system_id.into(), component_id.into()), frame.into());
        Ok(Message::decode(&params.made_of(self)?))
    }

    /// Reads the command from a `COMMAND_LONG`.
    ///
    /// # Errors
    /// - [`CommandError::OtherCommand`] if the message carries another command.
    /// - [`CommandError::Param`] if a param is no value of its enum.
    #[inline]
    fn from_long(message: &<Self::Carriers as CarriesLong>::Long) -> Result<Self, CommandError>
    where
        Self::Carriers: CarriesLong,
    {
        const { is_long::<<Self::Carriers as CarriesLong>::Long>() }
        Params::of_long(&payload(message)).read()
    }

    /// Reads the command from a `COMMAND_INT`.
    ///
    /// # Errors
    /// - [`CommandError::OtherCommand`] if the message carries another command.
    /// - [`CommandError::Param`] if a param is no value of its enum.
    /// - [`CommandError::Frame`] if coordinates have no meaning in the frame of the message.
    #[inline]
    fn from_int(message: &<Self::Carriers as CarriesInt>::Int) -> Result<Self, CommandError>
    where
        Self::Carriers: CarriesInt,
    {
        const { is_int::<<Self::Carriers as CarriesInt>::Int>() }
        Params::of_int(&payload(message)).read()
    }
}

/// The carriers of a dialect that has `COMMAND_LONG`: seven floats.
pub trait CarriesLong {
    /// The dialect's `COMMAND_LONG`.
    type Long: Message;
}

/// The carriers of a dialect that has `COMMAND_INT`: params 5 and 6 are integers, so that coordinates are exact.
pub trait CarriesInt {
    /// The dialect's `COMMAND_INT`.
    type Int: Message;

    /// The dialect's `MAV_FRAME`.
    type Frame: Into<u8>;
}

const fn is_long<M: Message>() {
    assert!(M::INFO.id == 76 && M::INFO.crc_extra == 152, "this is COMMAND_LONG");
}

const fn is_int<M: Message>() {
    assert!(M::INFO.id == 75 && M::INFO.crc_extra == 158, "this is COMMAND_INT");
}

fn payload<M: Message>(message: &M) -> [u8; crate::MAX_PAYLOAD] {
    let mut payload = [0; crate::MAX_PAYLOAD];
    crate::Encode::write(message, &mut payload);
    payload
}

/// Completes a command: `Default`.
#[macro_export]
macro_rules! command {
    ($name:ident) => {
        impl ::core::default::Default for $name {
            #[inline]
            fn default() -> Self {
                <Self as $crate::Command>::DEFAULT
            }
        }
    };
}
