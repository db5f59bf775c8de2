//! What the optional features add to messages, enums, flags and dialects: nothing, where they are off.
//!
//! Generated code cannot ask for the features of this crate, so its macros call these in any case.

#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __serde {
    ($($any:tt)*) => {};
}
