//! Time synchronisation: how far the clock of another component is ahead of one's own.
//!
//! [`Measure`] asks several times and takes the answer with the shortest round trip. A [`Responder`] answers.

mod measure;
mod responder;

pub use measure::{Failure, Measure, Offset, Options};
pub use responder::Responder;
