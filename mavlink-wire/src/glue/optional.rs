//! What the optional features add to generated types: nothing, where they are off.
//!
//! Generated code cannot ask for the features of this crate, so its macros call these in any case.

/// Nothing.
#[doc(hidden)]
#[macro_export]
macro_rules! __nothing {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "arbitrary"))]
pub use crate::{
    __nothing as __arbitrary, __nothing as __arbitrary_record, __nothing as __arbitrary_topics,
    __nothing as __random_message,
};

#[cfg(not(feature = "bitflags"))]
pub use crate::__nothing as __bitflags;

#[cfg(not(feature = "defmt"))]
pub use crate::{
    __nothing as __defmt, __nothing as __defmt_record, __nothing as __defmt_topics, __nothing as __defmt_variants,
    __nothing as __defmt_view,
};

#[cfg(not(feature = "mavlink-core"))]
pub use crate::__nothing as __mavlink_core;

#[cfg(not(feature = "serde"))]
pub use crate::{
    __nothing as __serde, __nothing as __serde_dialect_views, __nothing as __serde_message_views,
    __nothing as __serde_record, __nothing as __serde_topic, __nothing as __serde_topics,
    __nothing as __serde_variants, __nothing as __serde_view,
};
