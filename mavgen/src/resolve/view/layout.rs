//! The layouts of a view: bits that are always there, and a switch between others.

use super::piece::{self, PlacedBits};
use super::selector::{self, Selector};
use super::switch::{self, Branch};
use super::words::Words;
use super::{all_bits, branches, coverage};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Member, Switch};
use crate::resolve::boolean;
use crate::resolve::message_scope::{EnumUse, MessageScope};
use crate::syntax::overlay::{self, Part, View};

/// The members of a view and what selects between them.
#[derive(Default)]
pub(super) struct Layout {
    pub(super) members: Vec<Member>,
    pub(super) switch: Option<Switch>,
}

/// Resolves all parts of a view.
pub(super) fn resolve<'a>(
    scope: &MessageScope<'_, 'a>,
    element: &'a View,
    words: &Words,
    enum_uses: &mut Vec<EnumUse<'a>>,
    diagnostics: &mut Diagnostics,
) -> Layout {
    let partial = element.partial.as_ref().and_then(|text| boolean::of_overlay(text, diagnostics)) == Some(true);
    let switch = only_switch(element, diagnostics);
    let mut common: Vec<Option<PlacedBits<'a>>> = Vec::new();
    // Where the members of the switch belong among the others.
    let mut before_switch = 0;
    for part in &element.parts {
        match part {
            Part::Piece(piece) => common.push(piece::resolve(scope, piece, words, enum_uses, diagnostics)),
            Part::Switch(one) if switch.is_some_and(|switch| std::ptr::eq(switch, one)) => before_switch = common.len(),
            Part::Switch(_) => {}
        }
    }
    let whole = common.iter().all(Option::is_some);
    let pieces = |pieces: Vec<Option<PlacedBits<'a>>>| pieces.into_iter().flatten().collect_vec();
    let after = pieces(common.split_off(before_switch));
    let (mut common, count) = (pieces(common), after.len());
    common.extend(after);
    let selector = switch.and_then(|switch| selector::resolve(scope, switch, words, &common, diagnostics));
    let branches = match switch {
        Some(one) => switch::branches((scope, words), one, selector.as_ref(), enum_uses, diagnostics),
        None => Some(Vec::new()),
    };
    if let Some(branches) = branches.as_ref().filter(|_| whole) {
        // An empty view was spoken of, and what was lost in reading or in a second switch may have covered the rest.
        let lost = !scope.whole || switches(element).count() > 1;
        let complete = !partial && !lost && !all_bits(element).is_empty();
        coverage::check(element, words, (&common, branches), complete, diagnostics);
    }
    joined(common, count, selector, branches.unwrap_or_default(), diagnostics)
}

/// Puts the members of the branches before the last `after` of the others.
fn joined(
    common: Vec<PlacedBits<'_>>,
    after: usize,
    selector: Option<Selector>,
    branches: Vec<Branch<'_>>,
    diagnostics: &mut Diagnostics,
) -> Layout {
    let mut members = Vec::new();
    let position = common.len() - after.min(common.len());
    let mut switched = Some(branches);
    for (index, piece) in common.into_iter().enumerate() {
        if index == position
            && let (Some(branches), Some(selector)) = (switched.take(), &selector)
        {
            members.extend(branches::members(branches, selector.most, diagnostics));
        }
        members.extend(piece.member.map(|(member, _)| member));
    }
    if let (Some(branches), Some(selector)) = (switched, &selector) {
        members.extend(branches::members(branches, selector.most, diagnostics));
    }
    let switch = selector.map(|selector| Switch { name: selector.name, on: selector.on, span: selector.named });
    Layout { members, switch }
}

/// The switch of a view, which has at most one.
fn only_switch<'a>(element: &'a View, diagnostics: &mut Diagnostics) -> Option<&'a overlay::Switch> {
    let mut switches = switches(element);
    let first = switches.next()?;
    for second in switches {
        let problem = Diagnostic::new(Code::SecondSwitch, second.span, "a second switch in one view");
        let problem = problem.related(first.span, "the first one");
        diagnostics.push(problem.help("join their cases, or write two views with `partial=\"true\"`"));
    }
    Some(first)
}

fn switches(element: &View) -> impl Iterator<Item = &overlay::Switch> {
    element.parts.iter().filter_map(|part| match part {
        Part::Switch(switch) => Some(switch),
        Part::Piece(_) => None,
    })
}
