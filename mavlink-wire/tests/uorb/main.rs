//! Records of PX4 logs as a topic: three eras of `EscStatus`, damage, and hostile files.
#![cfg(feature = "uorb")]
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod binding;
mod cdr;
mod damage;
mod golden;
mod messages;
mod mutants;
mod real;
mod topic;
mod written;
