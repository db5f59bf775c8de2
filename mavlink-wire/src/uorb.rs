//! PX4's uORB messages, as its logs carry them.
//!
//! A [`Topic`] is the Rust struct of a `.msg` file. [`ulog`] reads logs of any era: each log says what its records look like,
//! and fields are found by name.

mod field;
mod kind;
mod place;
mod topic;
pub mod ulog;

pub use field::{Element, Field, places};
pub use kind::{Char, Kind, Value};
pub use place::Place;
pub use topic::Topic;
