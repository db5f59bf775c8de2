//! Random dialects with random overlays: every construct of both, and names that ask for trouble.
//!
//! A seed is the same case everywhere and for ever, unless this crate changes. Most cases are legal, as far as can be told
//! without mavgen: what mavgen makes of them is for tests to see. [`mutant`] adds the mistakes that people make.

mod bits;
mod case;
mod chance;
mod commands;
mod construct;
mod enums;
mod layout;
mod messages;
mod mutate;
mod names;
mod overlay;
mod switch;
mod topics;
mod view;
mod xml;

pub use case::{Case, case};
pub use chance::Random;
pub use construct::Construct;
pub use mutate::{elements, mutant};
pub use topics::{Topics, topics};

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn a_seed_is_one_case() {
        let (one, again) = (case(7), case(7));
        assert_eq!((one.files, one.roots, one.overlays), (again.files, again.roots, again.overlays));
        assert_ne!(case(8).files, case(7).files);
        assert_eq!(mutant(7).files, mutant(7).files);
    }

    #[test]
    fn every_construct_comes_up() {
        let said: BTreeSet<Construct> = (1..=300).flat_map(|seed| case(seed).constructs).collect();
        let missing: Vec<&Construct> = Construct::ALL.iter().filter(|one| !said.contains(one)).collect();
        assert!(missing.is_empty(), "{missing:?}");
    }

    #[test]
    fn a_mutant_differs_from_its_case() {
        assert!((1..=100).filter(|seed| mutant(*seed).files != case(*seed).files).count() > 95);
    }
}
