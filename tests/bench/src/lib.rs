//! What the benchmarks share: corpora, a source of pseudo-random numbers, interleaved rounds.

#![forbid(unsafe_code)]

pub mod corpus;
pub mod damage;
pub mod golden;
pub mod random;
pub mod rounds;
pub mod stream;
