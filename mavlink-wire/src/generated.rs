//! What generated code calls, and nothing else does. People need none of it.
//!
//! A dialect is made for one version of this crate: these names change with mavgen, without notice.

pub use crate::message::dialect::{decode_variant, decode_variant_into};
pub use crate::message::enums::{debug_entry, fmt_entry, parse};
pub use crate::message::flags::{fmt_flags, parse_flags, union};
pub use crate::message::record::Several;
pub use crate::message::scale::raw_of;
pub use crate::message::wire::{Wire, get, put, zero_extended};
pub use crate::parser::table::{index, index_length};

pub use crate::reflect::{debug_message, debug_variant, fmt_message, fmt_variant};

#[cfg(feature = "uorb")]
pub use crate::uorb::code::{
    body, body_mut, boolean, booleans, each, elements, elements_mut, fill, first, fit, narrow, narrow_each, record_mut,
};
#[cfg(feature = "uorb")]
pub use crate::uorb::{
    any::{Bound, Reader},
    member::read_nested,
};

#[cfg(feature = "bitflags")]
#[doc(hidden)]
pub use ::bitflags;

#[cfg(feature = "arbitrary")]
#[doc(hidden)]
pub use crate::glue::arbitrary;
#[cfg(feature = "defmt")]
#[doc(hidden)]
pub use crate::glue::defmt;

/// What implements serde's traits.
#[cfg(feature = "serde")]
#[doc(hidden)]
pub mod serde {
    pub use serde_core::de::{EnumAccess, MapAccess, SeqAccess, Visitor};
    pub use serde_core::ser::SerializeMap;
    pub use serde_core::{Deserialize, Deserializer, Serialize, Serializer};

    pub use crate::glue::serde::dialect::{deserialize_dialect, serialize_dialect};
    pub use crate::glue::serde::held::{
        Fields, needed, next_element, next_name, no_variant, number, read_fields, read_once, serialize_variant, skip,
        unit, variant,
    };
    pub use crate::glue::serde::message::{deserialize_message, serialize_message};
    pub use crate::glue::serde::topic::{Exact, Exactly, exactly};
    pub use crate::glue::serde::topics::{AnyTopic, Content, deserialize_topics, serialize_topic};
    pub use crate::glue::serde::value::{deserialize_enum, serialize_enum};
    pub use crate::glue::serde::views::{HasViews, Views};
}

/// What implements the traits of mavlink-core.
#[cfg(feature = "mavlink-core")]
#[doc(hidden)]
pub mod interop {
    pub use ::mavlink_core;
    #[cfg(feature = "arbitrary")]
    pub use ::rand_core;

    pub use crate::glue::interop::message::*;
}
