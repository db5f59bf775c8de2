//! Members that are not in every layout: the same name in several cases is one member.

use std::ops::RangeInclusive;

use super::ranges::joined;
use super::switch::Branch;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Member, Presence};
use crate::source::Span;
use crate::syntax::overlay::Bits;

/// A member, and the layouts that it was found in.
struct Merged<'a> {
    member: Member,
    bits: &'a Bits,
    /// The start tag of the last case that has it.
    case: Span,
    ranges: Vec<RangeInclusive<u64>>,
}

/// The members of all branches, each with the values of the switch for which it is there.
///
/// `most` is the largest value of the switch.
pub(super) fn members(branches: Vec<Branch<'_>>, most: u64, diagnostics: &mut Diagnostics) -> Vec<Member> {
    let mut merged: Vec<Merged<'_>> = Vec::new();
    for branch in branches {
        for (member, bits) in branch.pieces.into_iter().filter_map(|piece| piece.member) {
            match merged.iter_mut().find(|merged| merged.member.name == member.name) {
                None => merged.push(Merged { member, bits, case: branch.span, ranges: branch.ranges.clone() }),
                Some(first) if first.case == branch.span => diagnostics.push(twice(first, bits)),
                Some(first) if !same_layout(&first.member, &member) => diagnostics.push(differs(first, bits)),
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
    merged.into_iter().map(|merged| present(merged, most)).collect_vec()
}

fn present(merged: Merged<'_>, most: u64) -> Member {
    let ranges = joined(merged.ranges);
    let always = ranges == [0..=most];
    Member { presence: if always { Presence::Always } else { Presence::When(ranges) }, ..merged.member }
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
