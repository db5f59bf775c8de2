//! Holds generated code against golden vectors: what pymavlink makes of the same definitions.
//!
//! [`vectors`] reads the vectors and [`subject`] hides the message types behind one type. The build script writes code that
//! names every field of every message; [`frames`], [`facts`] and [`constants`] are the checks. They return [`fault`]s instead
//! of panicking, so that a test can show that they notice what they should.

pub mod autoquad;
pub mod constants;
pub mod definition;
pub mod dialects;
pub mod facts;
pub mod fault;
pub mod frames;
pub mod golden;
mod layout;
pub mod payload;
pub mod sequences;
pub mod signature;
pub mod subject;
pub mod values;
pub mod vectors;

pub use random_dialects as random;
