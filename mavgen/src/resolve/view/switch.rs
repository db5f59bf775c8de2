//! `<switch>`: its cases.

use std::ops::RangeInclusive;

use super::case::{self, CaseValues};
use super::piece::{self, PlacedBits};
use super::ranges;
use super::ranges::{complement, joined, list};
use super::selector::Selector;
use super::words::Words;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::resolve::message_scope::{EnumUse, MessageScope};
use crate::source::Span;
use crate::syntax::overlay::{Case, Switch};

/// One of the layouts.
pub(super) struct Branch<'a> {
    /// The values it is for: sorted and apart.
    pub(super) ranges: Vec<RangeInclusive<u64>>,
    /// Its parts, beside those of every layout.
    pub(super) pieces: Vec<PlacedBits<'a>>,
    /// The start tag.
    pub(super) span: Span,
}

/// Resolves the cases. Without a selector their parts are looked at all the same, for what is wrong with them.
pub(super) fn branches<'a>(
    (scope, words): (&MessageScope<'_, 'a>, &Words),
    element: &'a Switch,
    selector: Option<&Selector>,
    enum_uses: &mut Vec<EnumUse<'a>>,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<Branch<'a>>> {
    let taken = selector.map(|selector| cases(scope, element, selector, diagnostics));
    let rest = selector.zip(taken.as_deref()).map(|(selector, taken)| {
        let ranges = joined(taken.iter().flatten().map(|values| values.range.clone()));
        complement(&ranges, selector.most)
    });
    check_default(element, selector.zip(rest.as_deref()).filter(|_| scope.whole), diagnostics);
    let mut branches = Vec::new();
    let mut whole = true;
    for (index, case) in element.cases.iter().enumerate() {
        let ranges = match (&case.value, taken.as_deref().and_then(|taken| taken.get(index))) {
            (Some(_), Some(values)) => joined(values.iter().map(|values| values.range.clone())),
            _ => rest.clone().unwrap_or_default(),
        };
        let pieces = case.pieces.iter().map(|piece| piece::resolve(scope, piece, words, enum_uses, diagnostics));
        let pieces = pieces.collect_vec();
        whole &= pieces.iter().all(Option::is_some);
        branches.push(Branch { ranges, pieces: pieces.into_iter().flatten().collect_vec(), span: case.span });
    }
    Some(branches).filter(|_| whole)
}

/// The values of every case, of which none may be in two.
fn cases(
    scope: &MessageScope<'_, '_>,
    element: &Switch,
    selector: &Selector,
    diagnostics: &mut Diagnostics,
) -> Vec<Vec<CaseValues>> {
    let mut all: Vec<Vec<CaseValues>> = Vec::new();
    for case in &element.cases {
        let own = case.value.as_ref().map(|text| case::ranges(scope, text, selector, diagnostics)).unwrap_or_default();
        for (index, values) in own.iter().enumerate() {
            let mut before = all.iter().flatten().chain(own.iter().take(index));
            if let Some(first) = before.find(|first| overlap(&first.range, &values.range).is_some()) {
                diagnostics.extend(in_two_cases(first, values, selector));
            }
        }
        all.push(own);
    }
    all
}

fn overlap(a: &RangeInclusive<u64>, b: &RangeInclusive<u64>) -> Option<RangeInclusive<u64>> {
    let (start, end) = ((*a.start()).max(*b.start()), (*a.end()).min(*b.end()));
    (start <= end).then_some(start..=end)
}

fn in_two_cases(first: &CaseValues, second: &CaseValues, selector: &Selector) -> Option<Diagnostic> {
    let both = ranges::list(&[overlap(&first.range, &second.range)?]);
    let message = format!("{both} of {} are in two cases", selector.title);
    let message = if both.contains(' ') { message } else { message.replace(" are ", " is ") };
    let problem = Diagnostic::new(Code::CaseOverlap, second.text.span, message).label("again here");
    Some(problem.related(first.text.span, "first here").help("a value can be in one case only"))
}

/// Checks that there is one default if there has to be, and none if it is never reached.
fn check_default(element: &Switch, rest: Option<(&Selector, &[RangeInclusive<u64>])>, diagnostics: &mut Diagnostics) {
    let mut defaults = element.cases.iter().filter(|case| case.value.is_none());
    let first = defaults.next();
    if let (Some(first), Some(second)) = (first, defaults.next()) {
        let problem = Diagnostic::new(Code::SecondDefault, second.span, "a second `<default>`");
        diagnostics.push(problem.label("again here").related(first.span, "first here").help("join them"));
    }
    let Some((selector, rest)) = rest else { return };
    match (first, rest) {
        (Some(Case { span, .. }), []) => {
            let message = format!("the default is never reached: the cases have every value of {}", selector.title);
            let problem = Diagnostic::new(Code::UnreachableCase, *span, message);
            let problem = problem.related(selector.span, format!("0 to {}", selector.most));
            diagnostics.push(problem.help("leave it out"));
        }
        (None, [_, ..]) => {
            let message = format!("no case has the values {} of {}", list(rest), selector.title);
            let problem = Diagnostic::new(Code::MissingCase, element.span, message);
            diagnostics
                .push(problem.related(selector.span, format!("0 to {}", selector.most)).help("add a `<default>`"));
        }
        _ => {}
    }
}
