//! The layouts of a view: bits that are always there, and a switch between others; no bit in two members of one layout, and none
//! forgotten.

use std::ops::RangeInclusive;

use super::piece::{self, PlacedBits};
use super::switch::{self, Branch};
use super::words::Words;
use super::{all_bits, ranges};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic};
use crate::ir::{Member, Presence, Switch, mask};
use crate::resolve::boolean;
use crate::resolve::message_scope::MessageScope;
use crate::source::Span;
use crate::syntax::overlay::{self, Bits, Part, View};

/// Resolves all parts of a view: its members, and what selects between them.
pub(super) fn resolve<'a>(
    scope: &mut MessageScope<'_, 'a>,
    element: &'a View,
    words: &Words,
) -> (Vec<Member>, Option<Switch>) {
    let partial = boolean::of_overlay(&element.partial, scope.diagnostics) == Some(true);
    let switch = only_switch(scope, element);
    let mut common: Vec<PlacedBits<'a>> = Vec::new();
    let (mut whole, mut before_switch) = (true, 0);
    for part in &element.parts {
        match part {
            Part::Piece(piece) => match piece::resolve(scope, piece, words) {
                Some(piece) => common.push(piece),
                None => whole = false,
            },
            Part::Switch(one) if switch.is_some_and(|switch| std::ptr::eq(switch, one)) => {
                before_switch = common.iter().filter(|piece| piece.member.is_some()).count();
            }
            Part::Switch(_) => {}
        }
    }
    let selector = switch.and_then(|switch| switch::selector(scope, switch, words, &common));
    let branches = match switch {
        Some(one) => switch::branches(scope, one, words, selector.as_ref()),
        None => Some(Vec::new()),
    };
    if let Some(branches) = branches.as_ref().filter(|_| whole) {
        // An empty view was spoken of, and what was lost in reading or in a second switch may have covered the rest.
        let lost = !scope.whole || switches(element).count() > 1;
        let complete = !partial && !lost && !all_bits(element).is_empty();
        check_coverage(scope, element, words, (&common, branches), complete);
    }
    let mut all = common.into_iter().filter_map(|piece| Some(piece.member?.0)).collect_vec();
    if let (Some(selector), Some(branches)) = (&selector, branches) {
        let after = all.split_off(before_switch.min(all.len()));
        all.extend(members(scope, branches, selector.most()));
        all.extend(after);
    }
    (all, selector.map(|selector| selector.switch))
}

/// A member, and the layouts that it was found in.
struct Merged<'a> {
    member: Member,
    bits: &'a Bits,
    /// The start tag of the last case that has it.
    case: Span,
    ranges: Vec<RangeInclusive<u64>>,
}

/// The members of all branches, each with the values of the switch for which it is there: the same name in several cases is one
/// member. `most` is the largest value of the switch.
fn members(scope: &mut MessageScope<'_, '_>, branches: Vec<Branch<'_>>, most: u64) -> Vec<Member> {
    let mut merged: Vec<Merged<'_>> = Vec::new();
    for branch in branches {
        for (member, bits) in branch.pieces.into_iter().filter_map(|piece| piece.member) {
            match merged.iter_mut().find(|merged| merged.member.name == member.name) {
                None => merged.push(Merged { member, bits, case: branch.span, ranges: branch.ranges.clone() }),
                Some(first) if first.case == branch.span => scope.report(twice(first, bits)),
                Some(first) if !same_layout(&first.member, &member) => scope.report(differs(first, bits)),
                Some(first) => {
                    first.case = branch.span;
                    first.ranges.extend(branch.ranges.iter().cloned());
                    if first.member.description.is_empty() {
                        first.member.description = member.description;
                    }
                }
            }
        }
    }
    let present = merged.into_iter().map(|merged| {
        let ranges = ranges::joined(merged.ranges);
        let presence = if ranges == [0..=most] { Presence::Always } else { Presence::When(ranges) };
        Member { presence, ..merged.member }
    });
    present.collect_vec()
}

fn same_layout(a: &Member, b: &Member) -> bool {
    (a.at, a.width, a.signed, a.repeat) == (b.at, b.width, b.signed, b.repeat) && a.meaning == b.meaning
}

fn twice(first: &Merged<'_>, bits: &Bits) -> Diagnostic {
    let message = format!("`{}` stands twice in one case", bits.name.value);
    let problem = Diagnostic::new(Code::NameCollision, bits.name.span, message);
    problem.related(first.bits.name.span, "the first one").help("rename one of them")
}

fn differs(first: &Merged<'_>, bits: &Bits) -> Diagnostic {
    let message =
        format!("`{}` stands for different bits, or another meaning, than in an earlier case", bits.name.value);
    let problem = Diagnostic::new(Code::LayoutDiffers, bits.name.span, message);
    let problem = problem.related(first.bits.span, "the earlier one");
    problem.help("give it another name: a getter has one meaning")
}

/// The switch of a view, which has at most one.
fn only_switch<'a>(scope: &mut MessageScope<'_, '_>, element: &'a View) -> Option<&'a overlay::Switch> {
    let mut switches = switches(element);
    let first = switches.next()?;
    for second in switches {
        let problem = Diagnostic::new(Code::SecondSwitch, second.span, "a second switch in one view");
        let problem = problem.related(first.span, "the first one");
        scope.report(problem.help("join their cases, or write two views with `partial=\"true\"`"));
    }
    Some(first)
}

fn switches(element: &View) -> impl Iterator<Item = &overlay::Switch> {
    element.parts.iter().filter_map(|part| match part {
        Part::Switch(switch) => Some(switch),
        Part::Piece(_) => None,
    })
}

/// Checks that every bit of every layout has at most one meaning and, if the view has to be `complete`, at least one.
fn check_coverage(
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
