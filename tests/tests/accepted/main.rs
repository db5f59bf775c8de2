//! Whatever mavgen accepts compiles, without a warning of rustc or clippy: random dialects with random overlays.
//!
//! Many dialects are the modules of one crate, so that one run of rustc covers them. A dialect that fails is left behind, and
//! the others are tried again: errors of one hide those of another. What fails is written to `target/tmp/accepted/failures`,
//! as it came and as small as it gets.
//!
//! `MAVGEN_SEEDS=1..2000 cargo test -p mavlink-conformance --test accepted` tries others than [`SEEDS`].

mod failure;
mod meaning;
mod package;
mod program;
mod sample;
mod topics;

use std::collections::BTreeSet;
use std::ops::Range;

use random_dialects::Construct;

use package::Package;
use sample::{Fate, Sample};

/// The seeds of every run.
const SEEDS: Range<u64> = 1..161;

/// Dialects of one crate.
const TOGETHER: usize = 60;

/// At least so many of a hundred dialects are accepted: a generator of what is refused proves nothing.
const ACCEPTED_OF_100: usize = 60;

/// `MAVGEN_SEEDS=7..8`, or [`SEEDS`].
fn seeds() -> Range<u64> {
    let Ok(text) = std::env::var("MAVGEN_SEEDS") else { return SEEDS };
    let parsed = text.split_once("..").and_then(|(first, end)| Some(first.parse().ok()?..end.parse().ok()?));
    parsed.unwrap_or_else(|| panic!("`{text}` is no range of seeds, as `1..200`"))
}

#[test]
fn what_is_accepted_compiles_without_a_warning() {
    let seeds = seeds();
    let samples: Vec<Sample> = seeds.clone().map(|seed| Sample::of(random_dialects::case(seed))).collect();
    let accepted: Vec<&Sample> = samples.iter().filter(|sample| matches!(sample.fate, Fate::Accepted(_))).collect();
    println!("seeds {seeds:?}: {} of {} accepted", accepted.len(), samples.len());
    assert!(accepted.len() * 100 >= ACCEPTED_OF_100 * samples.len());
    let failures: Vec<_> = accepted.chunks(TOGETHER).flat_map(Package::failures).collect();
    for (nth, failure) in failures.iter().enumerate() {
        println!("{}", failure.report(nth == 0));
    }
    assert!(failures.is_empty(), "seeds {:?}", failures.iter().map(|failure| failure.seed).collect::<Vec<_>>());
}

/// In what is accepted, not only in what is made.
#[test]
fn every_construct_is_among_them() {
    let accepted = SEEDS.map(|seed| Sample::of(random_dialects::case(seed)));
    let accepted = accepted.filter(|sample| matches!(sample.fate, Fate::Accepted(_)));
    let said: BTreeSet<Construct> = accepted.flat_map(|sample| sample.case.constructs).collect();
    let missing: Vec<&Construct> = Construct::ALL.iter().filter(|one| !said.contains(one)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
