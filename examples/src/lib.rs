//! What one would write first: the programs are in `src/bin`. The library only holds the README's examples to their word.

#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
mod readme {}
