//! The layouts of a view: bits that are always there, and a switch between others.

use std::ops::RangeInclusive;

use super::piece::{self, PlacedBits};
use super::ranges::joined;
use super::switch::{self, Branch};
use super::words::Words;
use super::{all_bits, coverage, selector};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic};
use crate::ir::{Member, Presence, Switch};
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
    let selector = switch.and_then(|switch| selector::resolve(scope, switch, words, &common));
    let branches = match switch {
        Some(one) => switch::branches(scope, one, words, selector.as_ref()),
        None => Some(Vec::new()),
    };
    if let Some(branches) = branches.as_ref().filter(|_| whole) {
        // An empty view was spoken of, and what was lost in reading or in a second switch may have covered the rest.
        let lost = !scope.whole || switches(element).count() > 1;
        let complete = !partial && !lost && !all_bits(element).is_empty();
        coverage::check(scope, element, words, (&common, branches), complete);
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
        let ranges = joined(merged.ranges);
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
