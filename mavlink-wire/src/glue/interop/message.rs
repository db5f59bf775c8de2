//! The trait `mavlink_core::Message` of a dialect's enum.

use ::mavlink_core::MavlinkVersion;
use ::mavlink_core::error::ParserError;

use crate::{Dialect, Encode, MAX_PAYLOAD};

/// Implements `mavlink_core::Message`.
#[doc(hidden)]
#[macro_export]
macro_rules! __mavlink_core {
    ($dialect:ident { $($message:ident)* }) => {
        impl $crate::generated::interop::Targets for $dialect {
            fn target_mut(
                &mut self,
            ) -> (::core::option::Option<&mut u8>, ::core::option::Option<&mut u8>) {
                match self {
                    $(Self::$message(message) => $crate::Message::target_mut(message),)*
                }
            }
        }

        impl $crate::generated::interop::mavlink_core::Message for $dialect {
            fn message_id(&self) -> u32 {
                $crate::Encode::info(self).id
            }

            fn message_name(&self) -> &'static str {
                $crate::Encode::info(self).name
            }

            fn target_system_id(&self) -> ::core::option::Option<u8> {
                $crate::generated::interop::target(self, $crate::Encode::info(self).target_system)
            }

            fn target_component_id(&self) -> ::core::option::Option<u8> {
                $crate::generated::interop::target(self, $crate::Encode::info(self).target_component)
            }

            fn target_system_id_mut(&mut self) -> ::core::option::Option<&mut u8> {
                $crate::generated::interop::Targets::target_mut(self).0
            }

            fn target_component_id_mut(&mut self) -> ::core::option::Option<&mut u8> {
                $crate::generated::interop::Targets::target_mut(self).1
            }

            fn ser(&self, version: $crate::generated::interop::mavlink_core::MavlinkVersion, bytes: &mut [u8]) -> usize {
                $crate::generated::interop::write(self, version, bytes)
            }

            fn parse(
                _: $crate::generated::interop::mavlink_core::MavlinkVersion,
                id: u32,
                payload: &[u8],
            ) -> ::core::result::Result<Self, $crate::generated::interop::mavlink_core::error::ParserError> {
                $crate::generated::interop::parse(id, payload)
            }

            fn message_id_from_name(name: &str) -> ::core::option::Option<u32> {
                $crate::generated::interop::id_of::<Self>(name)
            }

            fn default_message_from_id(id: u32) -> ::core::option::Option<Self> {
                $(if id == <$message as $crate::Message>::ID {
                    return ::core::option::Option::Some(Self::$message(<$message as $crate::Message>::DEFAULT));
                })*
                ::core::option::Option::None
            }

            $crate::__random_message!();

            fn extra_crc(id: u32) -> u8 {
                $crate::generated::interop::crc_extra::<Self>(id)
            }
        }
    };
}

/// The method that the trait has when `mavlink-core/arbitrary` is on.
#[cfg(feature = "arbitrary")]
#[doc(hidden)]
#[macro_export]
macro_rules! __random_message {
    () => {
        fn random_message_from_id<R>(id: u32, random: &mut R) -> ::core::option::Option<Self>
        where
            R: $crate::generated::interop::rand_core::TryRng<Error = ::core::convert::Infallible>,
        {
            $crate::generated::interop::random(id, random)
        }
    };
}

/// [`Message::target_mut`](crate::Message::target_mut) of whatever message there is.
pub trait Targets {
    /// The fields with the ids of the addressed system and component.
    fn target_mut(&mut self) -> (Option<&mut u8>, Option<&mut u8>);
}

/// The byte at the offset of a target field.
pub fn target(message: &dyn Encode, offset: Option<u8>) -> Option<u8> {
    let mut payload = [0; MAX_PAYLOAD];
    message.write(&mut payload);
    payload.get(usize::from(offset?)).copied()
}

/// Writes a payload as it is sent, as far as there is room.
pub fn write(message: &dyn Encode, version: MavlinkVersion, bytes: &mut [u8]) -> usize {
    let mut buffer = [0; MAX_PAYLOAD];
    let payload = message.payload(version.into(), &mut buffer);
    bytes.iter_mut().zip(payload).map(|(to, from)| *to = *from).count()
}

/// The message with this id.
///
/// # Errors
///
/// The dialect does not have it.
pub fn parse<D: Dialect>(id: u32, payload: &[u8]) -> Result<D, ParserError> {
    D::decode(id, payload).ok_or(ParserError::UnknownMessage { id })
}

/// The id of the message with this name.
pub fn id_of<D: Dialect>(name: &str) -> Option<u32> {
    D::TABLE.iter().find(|info| info.name == name).map(|info| info.id)
}

/// Zero for an unknown message, as the trait's other implementations give.
pub fn crc_extra<D: Dialect>(id: u32) -> u8 {
    D::TABLE.get(id).map_or(0, |info| info.crc_extra)
}

/// A message of any payload.
#[cfg(feature = "arbitrary")]
pub fn random<D: Dialect, R>(id: u32, random: &mut R) -> Option<D>
where
    R: ::rand_core::TryRng<Error = core::convert::Infallible>,
{
    let mut payload = [0; MAX_PAYLOAD];
    let Ok(()) = random.try_fill_bytes(&mut payload);
    D::decode(id, &payload)
}
