//! Coverage: no bit in two members of one layout, and none forgotten.

use super::piece::PlacedBits;
use super::ranges;
use super::switch::Branch;
use super::words::Words;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic};
use crate::ir::mask;
use crate::resolve::message_scope::MessageScope;
use crate::syntax::overlay::View;

/// Checks that every bit of every layout has at most one meaning and, if the view has to be `complete`, at least one.
pub(super) fn check(
    scope: &mut MessageScope<'_, '_>,
    element: &View,
    words: &Words,
    (common, branches): (&[PlacedBits<'_>], &[Branch<'_>]),
    complete: bool,
) {
    let shared = overlaps(scope, common, &[]);
    let covered = branches.iter().map(|branch| shared | overlaps(scope, &branch.pieces, common)).collect_vec();
    if !complete {
        return;
    }
    // What no layout covers is said once, of the view.
    let anywhere = covered.iter().fold(shared, |sum, covered| sum | covered);
    let missing = mask(0, words.width, None) & !anywhere;
    if missing != 0 {
        let message = format!("view `{}` says nothing of {}", element.name.value, bits(missing));
        let problem = Diagnostic::new(Code::BitsUncovered, element.name.span, message);
        let problem = problem.related(words.span, format!("{} bits", words.width));
        scope.report(problem.help(help(missing)));
    }
    for (branch, covered) in branches.iter().zip(covered) {
        let missing = anywhere & !covered;
        if missing != 0 {
            let message = format!("view `{}` says nothing of {} in this case", element.name.value, bits(missing));
            let problem = Diagnostic::new(Code::BitsUncovered, branch.span, message);
            scope.report(problem.help(help(missing)));
        }
    }
}

fn help(missing: u128) -> String {
    let first = missing.trailing_zeros();
    let width = (missing >> first).trailing_ones();
    let reserved = format!("<reserved at=\"{first}\" width=\"{width}\"/>");
    format!("add `{reserved}` if they mean nothing, or `partial=\"true\"` to the view")
}

/// Reports bits that `pieces` share with each other or with those of `before`. Returns all bits of `pieces`.
fn overlaps(scope: &mut MessageScope<'_, '_>, pieces: &[PlacedBits<'_>], before: &[PlacedBits<'_>]) -> u128 {
    let mut covered = 0;
    for (index, piece) in pieces.iter().enumerate() {
        let earlier = before.iter().chain(pieces.iter().take(index));
        if let Some(first) = earlier.into_iter().find(|first| first.mask & piece.mask != 0) {
            let (own, other) = (piece.title(), first.title());
            let message = format!("{other} and {own} have {} in common", bits(first.mask & piece.mask));
            let problem = Diagnostic::new(Code::BitsOverlap, piece.at.span, message);
            let problem = problem.label(format!("{own}: {}", bits(piece.mask)));
            let problem = problem.related(first.at.span, format!("{other}: {}", bits(first.mask)));
            scope.report(problem.help("of one layout, a bit can be in one member only"));
        }
        covered |= piece.mask;
    }
    covered
}

/// `bits 29 to 31`.
fn bits(mask: u128) -> String {
    let positions = (0..128_u64).filter(|&bit| mask >> bit & 1 == 1).map(|bit| bit..=bit);
    let list = ranges::list(&ranges::joined(positions.collect_vec()));
    if mask.is_power_of_two() { format!("bit {list}") } else { format!("bits {list}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_listed_from_the_least() {
        assert_eq!(bits(0b1), "bit 0");
        assert_eq!(bits(0b1110_0101), "bits 0, 2, 5 to 7");
        assert_eq!(bits(u128::MAX), "bits 0 to 127");
        let expected = "add `<reserved at=\"5\" width=\"3\"/>` if they mean nothing, or `partial=\"true\"` to the view";
        assert_eq!(help(0b1110_0000), expected);
    }
}
