//! Links that lose and invent bytes.

use crate::corpus::Corpus;
use crate::random::Random;

/// Every hundredth frame has one wrong byte, and garbage stands in every hundredth gap.
#[must_use]
pub fn lossy(corpus: &Corpus) -> Vec<u8> {
    let (mut random, mut bytes) = (Random::new(3), Vec::new());
    for (_, frame) in corpus.iter() {
        let start = bytes.len();
        bytes.extend_from_slice(frame);
        if random.once_in(100) {
            let at = start + random.below(frame.len());
            flip(&mut bytes, at, &mut random);
        }
        garbage(&mut bytes, 100, &mut random);
    }
    bytes
}

/// Every hundredth byte is wrong, and garbage stands in every tenth gap.
#[must_use]
pub fn corrupt(corpus: &Corpus) -> Vec<u8> {
    let (mut random, mut bytes) = (Random::new(4), Vec::new());
    for (_, frame) in corpus.iter() {
        bytes.extend_from_slice(frame);
        garbage(&mut bytes, 10, &mut random);
    }
    for at in 0..bytes.len() {
        if random.once_in(100) {
            flip(&mut bytes, at, &mut random);
        }
    }
    bytes
}

fn flip(bytes: &mut [u8], at: usize, random: &mut Random) {
    if let Some(byte) = bytes.get_mut(at) {
        *byte ^= 1 + random.below(255) as u8;
    }
}

/// 1 to 40 bytes that nobody sent, once in so many gaps.
fn garbage(bytes: &mut Vec<u8>, once_in: usize, random: &mut Random) {
    if random.once_in(once_in) {
        let count = 1 + random.below(40);
        bytes.extend((0..count).map(|_| random.bits() as u8));
    }
}
