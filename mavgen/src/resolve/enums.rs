//! The enums of all files, merged by name.

mod block;
mod merge;

pub(super) use block::ValuedEntry;
pub(super) use merge::{Enums, Merged};
