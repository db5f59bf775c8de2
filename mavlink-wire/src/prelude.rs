//! The traits, for `use mavlink_wire::prelude::*`: their methods are then at hand, and no name is taken.
//!
//! ```
//! use mavlink_wire::prelude::*;
//!
//! fn name(message: &dyn Encode) -> &'static str {
//!     message.info().name
//! }
//! ```

#[cfg(feature = "uorb")]
pub use crate::uorb::{Topic, TopicByLength};
pub use crate::{Command, Dialect, Encode, Enum, Message, Targeted};
