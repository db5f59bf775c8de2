//! How messages are written by [serde](https://docs.rs/serde) (feature `serde`): everything that is serialized comes back
//! as it was, to the bit, where the format can.
//!
//! # Human readable formats (JSON, YAML, TOML, RON)
//!
//! A message is a struct, its fields in the order and the spelling of the XML. A dialect's enum adds the key `type` with the
//! name of the message, as `rust-mavlink` and `mavlink2rest` do, and like them calls a field `type` `mavtype`:
//!
//! ```json
//! { "type": "HEARTBEAT", "mavtype": "MAV_TYPE_QUADROTOR", "autopilot": "MAV_AUTOPILOT_AUTOQUAD",
//!   "base_mode": "MAV_MODE_FLAG_SAFETY_ARMED | MAV_MODE_FLAG_HIL_ENABLED", "custom_mode": 4,
//!   "system_status": 200, "mavlink_version": 3 }
//! ```
//!
//! - Enums are the names of their entries, and numbers where no entry has the value. Reading also takes a number for a name,
//!   numbers in text (`"0x10"`), and `{"type": "MAV_STATE_ACTIVE"}`, as `rust-mavlink` writes it.
//! - Flags are text as the crate `bitflags` writes it: `A | B | 0x40`, empty for none. Reading also takes a number, and
//!   `{"bits": 5}`, as `rust-mavlink` wrote it up to 0.14.
//! - Floats are numbers; what JSON has no number for is `"NaN"`, `"Infinity"` and `"-Infinity"`. A NaN other than the usual
//!   one keeps its bits: `"NaN(0x7fc00001)"`. Reading also takes `null` for NaN. `serde_json` reads some `double`s one bit
//!   off, unless its feature `float_roundtrip` is on; `float`s it reads exactly.
//! - `char` arrays are text; arrays of numbers if they are not UTF-8, or if something follows a NUL. Reading also takes arrays
//!   of characters, `["t", "a", "\u0000"]`, as `rust-mavlink` wrote them up to 0.14.
//! - What stands for "not known" is written as the number that it is. Reading also takes `null` for it, where a field has such
//!   a value: `mavgen decode` writes that.
//!
//! Fields that are missing are an error, but for extension fields: they are zero, as in a frame of a sender that does not
//! know them. Fields that the message does not have are ignored. `type` may come after other fields, as long as those take no
//! more than 8 KiB: they are kept on the stack, since there may be no allocator.
//!
//! # Views
//!
//! [`WithViews`] writes a message, or a dialect's enum, and behind the fields the object `views`: what overlays see in the message,
//! by the names that `mavgen decode` has for it. A message by itself stays without them, and either is read as the message: `views`
//! is ignored, since the fields say it all. `Envelope::new(header, WithViews(&message))` has the header as well.
//!
//! # Other formats (postcard, bincode, MessagePack, CBOR)
//!
//! A message is a tuple of its fields in the order of the XML, an enum or flags value the number on the wire, a `char` array
//! its bytes. A dialect's enum is a variant whose index is the message id, so that data survives new messages; MessagePack and
//! CBOR write the variant's name, which is the message's. CBOR by `ciborium` makes signalling NaNs of `float`s quiet.
//!
//! # uORB messages
//!
//! A message of PX4 is a struct of its fields, as the `.msg` file spells them, or a tuple of them. The enum of a package is
//! `{"EscStatus": {…}}`, or a tuple of the name and the message, so that data survives new messages.
//!
//! # Frames, ids and counters
//!
//! An [`Envelope`] is a message with its [`Header`]. A frame is written with all of its bytes, but not read, since a checksum
//! needs a table: parse the bytes. Ids, timestamps and versions are numbers; `Statistics`, `Received` and the verifier's
//! `Stream`, which is to be saved, are structs.
//!
//! # Keys
//!
//! The key in a `SETUP_SIGNING` is written like any field, since nothing is lost here: keep such a message out of what others
//! read ([`Frame::carries_key`](crate::Frame::carries_key)). As a frame it is not written at all. `Debug`, [`reflect`](crate::reflect) and `defmt` do not show it.

mod chars;
pub(crate) mod dialect;
mod early;
mod facts;
mod field;
mod float;
pub(crate) mod held;
pub(crate) mod message;
mod named;
mod record;
pub(crate) mod topic;
pub(crate) mod topics;
pub(crate) mod value;
pub(crate) mod views;

pub use facts::{Envelope, Header};
pub use views::{HasViews, WithViews};

/// Implements serde's traits by two of the functions above: `(type, serialize, deserialize, arguments…)`.
#[doc(hidden)]
#[macro_export]
macro_rules! __serde {
    ($name:ident, $serialize:ident, $deserialize:ident $(, $argument:expr)?) => {
        impl $crate::generated::serde::Serialize for $name {
            fn serialize<S: $crate::generated::serde::Serializer>(
                &self,
                serializer: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                $crate::generated::serde::$serialize(self, $($argument,)? serializer)
            }
        }

        impl<'de> $crate::generated::serde::Deserialize<'de> for $name {
            fn deserialize<D: $crate::generated::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                $crate::generated::serde::$deserialize($($argument,)? deserializer)
            }
        }
    };
}
