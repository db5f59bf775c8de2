//! Time synchronisation: how far the clock of another component is ahead of one's own.
//!
//! [`Measure`] asks a few times and takes the quickest answer; a [`Responder`] answers.

mod measure;
mod responder;

pub use measure::{Failure, Measure, Offset, Options};
pub use responder::Responder;
