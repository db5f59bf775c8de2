//! What the optional features add to messages, enums, flags, dialects, views and slots: nothing, where they are off.
//!
//! Generated code cannot ask for the features of this crate, so its macros call these in any case.

#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __serde {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_message_views {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_dialect_views {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_view {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_record {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_topic {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_variants {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "defmt"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __defmt {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "defmt"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __defmt_view {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "defmt"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __defmt_record {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "defmt"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __defmt_variants {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "arbitrary"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __arbitrary {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "arbitrary"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __arbitrary_record {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "bitflags"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __bitflags {
    ($($any:tt)*) => {};
}

#[cfg(not(feature = "mavlink-core"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __mavlink_core {
    ($($any:tt)*) => {};
}
