//! Numbers that look random and are the same on every run.

use std::collections::BTreeSet;

use crate::Construct;

/// A sequence of pseudo-random numbers (SplitMix64).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The sequence of a seed.
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next number, all bits of it.
    pub fn number(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// A number below `limit`.
    pub fn below(&mut self, limit: usize) -> usize {
        (self.number() % limit as u64) as usize
    }
}

/// Decisions, and which constructs came of them.
pub(crate) struct Chance {
    random: Random,
    pub(crate) said: BTreeSet<Construct>,
}

impl Chance {
    pub(crate) fn new(seed: u64) -> Self {
        // Neighbouring seeds begin far from each other.
        let seed = Random::new(seed).number();
        Self { random: Random::new(seed), said: BTreeSet::new() }
    }

    pub(crate) fn number(&mut self) -> u64 {
        self.random.number()
    }

    pub(crate) fn below(&mut self, limit: usize) -> usize {
        self.random.below(limit.max(1))
    }

    /// A number from `least` to `most`.
    pub(crate) fn between(&mut self, least: usize, most: usize) -> usize {
        least + self.below(most.saturating_sub(least) + 1)
    }

    /// True once in so many times.
    pub(crate) fn one_in(&mut self, times: usize) -> bool {
        self.below(times) == 0
    }

    /// As [`Chance::one_in`], and notes the construct if so.
    pub(crate) fn maybe(&mut self, times: usize, construct: Construct) -> bool {
        let so = self.one_in(times);
        if so {
            self.say(construct);
        }
        so
    }

    pub(crate) fn pick<'t, T>(&mut self, list: &'t [T]) -> Option<&'t T> {
        if list.is_empty() { None } else { list.get(self.below(list.len())) }
    }

    /// One of some words.
    pub(crate) fn word(&mut self, list: &[&'static str]) -> &'static str {
        self.pick(list).copied().unwrap_or("word")
    }

    pub(crate) fn say(&mut self, construct: Construct) {
        self.said.insert(construct);
    }
}
