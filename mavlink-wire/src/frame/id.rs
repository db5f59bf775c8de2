//! Who sends and who is addressed.

use core::fmt;

use crate::OutOfRange;

macro_rules! id {
    ($name:ident, $all:literal, $(#[$doc:meta])*) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(u8);

        impl $name {
            #[doc = concat!("As an addressee, ", $all, ".")]
            pub const BROADCAST: Self = Self(0);

            /// The id with this number, also in a `const`.
            #[must_use]
            pub const fn from_u8(id: u8) -> Self {
                Self(id)
            }

            /// The number; today at most 255.
            #[must_use]
            pub const fn to_u32(self) -> u32 {
                self.0 as u32
            }

            #[doc = concat!("Whether this addresses ", $all, ".")]
            #[must_use]
            pub const fn is_broadcast(self) -> bool {
                self.0 == 0
            }

            /// The number as frames have it.
            pub(crate) const fn to_u8(self) -> u8 {
                self.0
            }
        }

        /// Of a `u8`, and of what becomes one: a dialect's enum of ids.
        impl<T: Into<u8>> From<T> for $name {
            fn from(id: T) -> Self {
                Self(id.into())
            }
        }

        /// To fill a field of one byte. An id over 255 does not fit; there is none yet.
        impl TryFrom<$name> for u8 {
            type Error = OutOfRange;

            fn try_from(id: $name) -> Result<Self, OutOfRange> {
                Ok(id.0)
            }
        }

        impl PartialEq<u8> for $name {
            fn eq(&self, other: &u8) -> bool {
                self.0 == *other
            }
        }

        impl PartialEq<$name> for u8 {
            fn eq(&self, other: &$name) -> bool {
                *self == other.0
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(&self.0, f)
            }
        }

        /// The number alone.
        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Debug::fmt(&self.0, f)
            }
        }

        #[cfg(feature = "defmt")]
        impl ::defmt::Format for $name {
            fn format(&self, f: ::defmt::Formatter<'_>) {
                ::defmt::Format::format(&self.0, f);
            }
        }
    };
}

id! {
    SystemId, "all systems",
    /// Id of a system: a vehicle, a ground station.
    ///
    /// A type of its own, because ids of 32 bits are under way in MAVLink: what is written with it stays as it is then. Today
    /// ids are 1 to 255, and 0 addresses all systems; frames with longer ones are refused
    /// ([`FrameError::IncompatFlags`](crate::FrameError::IncompatFlags)).
    ///
    /// ```
    /// use mavlink_wire::SystemId;
    ///
    /// const STATION: SystemId = SystemId::from_u8(255);
    /// assert!(STATION == 255 && STATION == SystemId::from(255) && !STATION.is_broadcast());
    /// assert_eq!((STATION.to_string(), STATION.to_u32(), u8::try_from(STATION)), ("255".into(), 255, Ok(255)));
    /// ```
}

id! {
    ComponentId, "all components of a system",
    /// Id of a component of a system: an autopilot, a gimbal. 1 to 255; 0 addresses all components of a system.
    ///
    /// A dialect's `MavComponent` becomes one by `into`.
}
