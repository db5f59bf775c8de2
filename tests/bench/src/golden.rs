//! The golden frames of `tests/vectors`, MAVLink 1 and 2 without signature.

use crate::corpus::{Corpus, Refusal};

/// The golden frames that rust-mavlink reads, and how many it does not.
#[derive(Clone, Debug, Default)]
pub struct Golden {
    /// The frames that are left.
    pub corpus: Corpus,
    /// Frames of messages that its `common` does not have with this definition.
    pub unknown: usize,
    /// Frames that it refuses for the value of an enum.
    pub refused: usize,
}

impl Golden {
    /// Takes the frames from the text of a vector file.
    #[must_use]
    pub fn read(text: &str) -> Self {
        let mut golden = Self::default();
        let frames = text.lines().filter_map(|line| line.strip_prefix("v1 ").or(line.strip_prefix("v2 ")));
        for frame in frames {
            match golden.corpus.push(&expand(frame)) {
                Ok(()) => {}
                Err(Refusal::Unknown) => golden.unknown += 1,
                Err(Refusal::Value) => golden.refused += 1,
            }
        }
        golden
    }
}

/// The bytes that a line's runs stand for: `0102,00*5,03`.
fn expand(runs: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    for token in runs.split([' ', ',']) {
        let (digits, count) = token.split_once('*').unwrap_or((token, "1"));
        for _ in 0..count.parse().unwrap_or(0) {
            let pairs = digits.as_bytes().chunks(2).filter_map(|pair| str::from_utf8(pair).ok());
            bytes.extend(pairs.filter_map(|pair| u8::from_str_radix(pair, 16).ok()));
        }
    }
    bytes
}
