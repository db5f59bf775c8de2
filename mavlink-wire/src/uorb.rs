//! PX4's uORB messages, in the two forms in which they leave a vehicle.
//!
//! A [`Topic`] is the Rust struct of a `.msg` file, and of what it was before. As [`cdr`] it comes through ROS 2's middleware;
//! as records it stands in a log: [`ulog`] reads logs of any era, since each log says what its records look like, and fields
//! are found by name.

pub(crate) mod any;
pub mod cdr;
pub(crate) mod code;
mod definition;
mod field;
mod kind;
pub(crate) mod member;
mod place;
mod topic;
pub mod ulog;

pub use any::Topics;
pub use cdr::CdrError;
pub use definition::{Definition, ZenohKey};
pub use field::{Element, Field, places};
pub use kind::{Kind, Value};
pub use member::{Fields, Member, Visit};
pub use place::Place;
pub use topic::{Topic, TopicByLength};
