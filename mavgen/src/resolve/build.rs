//! The last pass: finished items of the model out of what the others found.

mod command;
mod enums;
mod message;

pub(super) use enums::build as build_enum;
pub(super) use message::{Links, build as build_message};
