//! A dialect that mavgen accepts and rustc or clippy does not.

use std::fs;
use std::ops::Range;
use std::path::PathBuf;

use random_dialects::{Case, elements};

use crate::package::{self, Package};
use crate::sample::{self, Fate, Sample};

/// So many smaller inputs are tried.
const TRIES: usize = 60;

/// So many errors are told of a dialect.
const TOLD: usize = 3;

/// The seed, what is said of it, and the input.
pub(crate) struct Failure {
    pub(crate) seed: u64,
    said: Vec<String>,
    case: Case,
}

impl Failure {
    pub(crate) fn new(sample: &Sample, said: Vec<String>) -> Self {
        Self { seed: sample.case.seed, said, case: sample.case.clone() }
    }

    /// What to tell; keeps the input, and a smaller one if that is wanted.
    pub(crate) fn report(&self, small: bool) -> String {
        let folder = package::folder().join(format!("failures/{}", self.seed));
        keep(&folder, &self.case);
        let said: Vec<&str> = self.said.iter().take(TOLD).map(String::as_str).collect();
        let mut report = format!("seed {}, kept in {}:\n{}\n", self.seed, folder.display(), said.join("\n\n"));
        if small {
            let smaller = self.smaller();
            keep(&folder.join("small"), &smaller);
            for (name, text) in &smaller.files {
                report += &format!("--- {name}\n{text}\n");
            }
        }
        report
    }

    /// The case without the elements that it fails without, as far as that is found quickly.
    fn smaller(&self) -> Case {
        let (mut case, mut tries) = (self.case.clone(), 0);
        for file in 0..case.files.len() {
            let mut at = 0;
            while let Some(range) = largest_first(&case.files[file].1).get(at).cloned().filter(|_| tries < TRIES) {
                tries += 1;
                let mut fewer = case.clone();
                fewer.files[file].1.replace_range(range, "");
                if self.fails_with(&fewer) { case = fewer } else { at += 1 }
            }
        }
        case
    }

    /// Whether a case is accepted and fails in the same way.
    fn fails_with(&self, case: &Case) -> bool {
        let sample = Sample::of(case.clone());
        if matches!(sample.fate, Fate::Refused) {
            return false;
        }
        let kind = |said: &[String]| said.first().map(|one| words(one));
        Package::tried(&[&sample]).values().any(|said| kind(said) == kind(&self.said))
    }
}

/// The first line without what stands in ticks.
fn words(said: &str) -> String {
    let line = said.lines().next().unwrap_or_default();
    line.split('`').step_by(2).collect()
}

fn keep(folder: &PathBuf, case: &Case) {
    fs::create_dir_all(folder).unwrap();
    sample::write(folder, case);
}

fn largest_first(text: &str) -> Vec<Range<usize>> {
    let mut ranges = elements(text);
    ranges.sort_by_key(|range| std::cmp::Reverse(range.len()));
    ranges
}
