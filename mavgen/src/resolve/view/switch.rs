//! `<switch>`: what it looks at, a field or bits that are in every layout; its cases, `<case value="3..=9 30..">`, and which
//! values each is for.

use std::ops::RangeInclusive;

use super::piece::{self, PlacedBits};
use super::ranges::{complement, joined, list};
use super::words::{Words, beside, parts};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic};
use crate::ir::{self, EnumId, Meaning, SwitchOn};
use crate::resolve::message_scope::MessageScope;
use crate::resolve::{names, number, suggest};
use crate::source::Span;
use crate::syntax::Text;
use crate::syntax::overlay::{Case, Switch};

/// What a switch looks at.
pub(super) struct Selector {
    pub(super) switch: ir::Switch,
    /// The enum of its values.
    pub(super) enum_: Option<EnumId>,
    /// Where its width is defined.
    pub(super) span: Span,
}

impl Selector {
    pub(super) fn title(&self) -> String {
        format!("`{}`", self.switch.name.name.text)
    }

    pub(super) fn most(&self) -> u64 {
        self.switch.on.highest()
    }
}

/// Resolves what a switch looks at: a field, or bits that stand before it in every layout.
pub(super) fn selector(
    scope: &mut MessageScope<'_, '_>,
    element: &Switch,
    words: &Words,
    common: &[PlacedBits<'_>],
) -> Option<Selector> {
    let message = match (&element.field, &element.bits) {
        (Some(field), None) => return on_field(scope, field, words),
        (None, Some(bits)) => return on_bits(scope, bits, common),
        (None, None) => "a switch does not say what it looks at",
        (Some(_), Some(_)) => "a switch looks at a field and at bits",
    };
    let problem = Diagnostic::new(Code::SwitchOn, element.span, message);
    scope.refuse(problem.help("write `field=\"…\"` or `bits=\"…\"`"))
}

fn on_field(scope: &mut MessageScope<'_, '_>, text: &Text, words: &Words) -> Option<Selector> {
    let (place, found) = beside(scope, text, words)?;
    let Some(repr) = found.field.ty.scalar.repr().filter(|repr| !repr.is_signed()) else {
        let why = ("no switch can look at", "a switch looks at an unsigned integer");
        return scope.refuse_type(Code::SwitchOn, text.span, found, why);
    };
    let name = names::label(&found.syntax.name);
    Some(Selector {
        switch: ir::Switch { name, on: SwitchOn::Field(place, repr), span: text.span },
        enum_: scope.enum_of(found.syntax),
        span: found.syntax.ty.span,
    })
}

fn on_bits(scope: &mut MessageScope<'_, '_>, text: &Text, common: &[PlacedBits<'_>]) -> Option<Selector> {
    let name = names::label(text);
    let members = common.iter().filter_map(|piece| piece.member.as_ref());
    let Some((member, bits)) = members.clone().find(|(member, _)| member.name == name) else {
        let message = format!("`{}` is not in every layout of the view", text.value);
        let problem = Diagnostic::new(Code::SwitchOn, text.span, message).label("no such bits outside of the switch");
        let mut names = members.map(|(_, bits)| bits.name.value.as_str());
        suggest::report(problem, &text.value, &mut names, scope.diagnostics);
        return None;
    };
    let enum_ = match member.meaning {
        Meaning::Values(enum_) => Some(enum_),
        Meaning::Number { .. } | Meaning::Flag | Meaning::Scaled(_) => None,
    };
    let plain = !matches!(member.meaning, Meaning::Scaled(_)) && !member.signed && member.repeat.is_none();
    if !plain || member.width > 64 {
        let message = format!("`{}` is no plain number, which no switch can look at", text.value);
        let problem = Diagnostic::new(Code::SwitchOn, text.span, message).related(bits.span, "the bits");
        return scope.refuse(problem.help("a switch looks at up to 64 bits without sign, scale or repetition"));
    }
    let on = SwitchOn::Bits { at: member.at, width: member.width };
    Some(Selector { switch: ir::Switch { name, on, span: text.span }, enum_, span: bits.width.span })
}

pub(super) struct Branch<'a> {
    /// The values it is for: sorted and apart.
    pub(super) ranges: Vec<RangeInclusive<u64>>,
    /// Its parts, beside those of every layout.
    pub(super) pieces: Vec<PlacedBits<'a>>,
    pub(super) span: Span,
}

/// A range of values, and where it is written.
type CaseValues = (RangeInclusive<u64>, Span);

/// Resolves the cases. Without a selector their parts are looked at all the same, for what is wrong with them.
pub(super) fn branches<'a>(
    scope: &mut MessageScope<'_, 'a>,
    element: &'a Switch,
    words: &Words,
    selector: Option<&Selector>,
) -> Option<Vec<Branch<'a>>> {
    let taken = selector.map(|selector| cases(scope, element, selector)).unwrap_or_default();
    let rest = selector.map(|selector| {
        let ranges = joined(taken.iter().flatten().map(|(range, _)| range.clone()).collect_vec());
        complement(&ranges, selector.most())
    });
    let rest = rest.unwrap_or_default();
    check_default(scope, element, selector, &rest);
    let mut branches = Vec::new();
    let mut whole = true;
    for (index, case) in element.cases.iter().enumerate() {
        let ranges = match (&case.value, taken.get(index)) {
            (Some(_), Some(values)) => joined(values.iter().map(|(range, _)| range.clone()).collect_vec()),
            _ => rest.clone(),
        };
        let pieces = case.pieces.iter().map(|piece| piece::resolve(scope, piece, words)).collect_vec();
        whole &= pieces.iter().all(Option::is_some);
        branches.push(Branch { ranges, pieces: pieces.into_iter().flatten().collect_vec(), span: case.span });
    }
    Some(branches).filter(|_| whole)
}

/// The values of every case, of which none may be in two.
fn cases(scope: &mut MessageScope<'_, '_>, element: &Switch, selector: &Selector) -> Vec<Vec<CaseValues>> {
    let mut all: Vec<Vec<CaseValues>> = Vec::new();
    for case in &element.cases {
        let own = case.value.as_ref().map(|text| ranges(scope, text, selector)).unwrap_or_default();
        for (index, (range, span)) in own.iter().enumerate() {
            let mut before = all.iter().flatten().chain(own.iter().take(index));
            let twice = before.find_map(|(first, first_span)| Some((overlap(first, range)?, *first_span)));
            if let Some((both, first)) = twice {
                let verb = if both.start() == both.end() { "is" } else { "are" };
                let message = format!("{} of {} {verb} in two cases", list(&[both]), selector.title());
                let problem = Diagnostic::new(Code::CaseOverlap, *span, message).label("again here");
                scope.report(problem.related(first, "first here").help("a value can be in one case only"));
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

const HELP: &str = "write `3`, `3..=9` or `30..`; several are separated by blanks";

/// The ranges of a case, inside of what the switch can be; what is wrong is reported.
fn ranges(scope: &mut MessageScope<'_, '_>, text: &Text, selector: &Selector) -> Vec<CaseValues> {
    let parts = parts(text);
    if parts.is_empty() {
        scope.report(Diagnostic::new(Code::CaseValue, text.span, "a case of no values").help(HELP));
    }
    let mut ranges = Vec::new();
    for part in parts {
        let Some(range) = range(scope, &part, selector) else { continue };
        let most = selector.most();
        if *range.end() <= most {
            ranges.push((range, part.span));
            continue;
        }
        let title = selector.title();
        let beyond = (*range.start()).max(most.saturating_add(1));
        let message = format!("{title} is never {beyond}: it is at most {most}");
        let problem = Diagnostic::new(Code::UnreachableCase, part.span, message);
        let problem = problem.related(selector.span, format!("{title} is 0 to {most}"));
        scope.report(problem.help("leave it out, or correct it"));
    }
    ranges
}

/// One part: `a`, `a..=b` or `a..`.
fn range(scope: &mut MessageScope<'_, '_>, text: &Text, selector: &Selector) -> Option<RangeInclusive<u64>> {
    let Some((start, end)) = text.value.split_once("..") else {
        let value = value(scope, text, &text.value, selector)?;
        return Some(value..=value);
    };
    let problem = |what: &str| Diagnostic::new(Code::CaseValue, text.span, format!("`{}` {what}", text.value));
    if start.is_empty() {
        return scope.refuse(problem("does not say where it starts").help(format!("write `0{}`", text.value)));
    }
    let start = value(scope, text, start, selector)?;
    let end = match end.strip_prefix('=') {
        Some(end) => value(scope, text, end, selector)?,
        // A start beyond what there is makes a range that is refused as such.
        None if end.is_empty() => selector.most().max(start),
        None => {
            let fixed = text.value.replace("..", "..=");
            return scope.refuse(problem("is not a range of values").help(format!("write `{fixed}`, end included")));
        }
    };
    if start > end {
        return scope.refuse(problem("is no value: it ends before it starts").help("the smaller one is first"));
    }
    Some(start..=end)
}

/// A number, or the name of an entry, in a part of a case.
fn value(scope: &mut MessageScope<'_, '_>, part: &Text, text: &str, selector: &Selector) -> Option<u64> {
    let entry = || selector.enum_.and_then(|enum_| scope.entry(enum_, text));
    let value = number::unsigned(text).ok().or_else(entry);
    if value.is_none() && scope.entries.complete {
        let message = format!("`{text}` is not a value of {}", selector.title());
        let problem = Diagnostic::new(Code::CaseValue, part.span, message).help(HELP);
        let problem = problem.related(selector.span, "what the switch looks at");
        scope.report_value(problem, text, selector.enum_);
    }
    value
}

/// Checks that there is one default if there has to be, and none if it is never reached; `rest` is what no case has.
fn check_default(
    scope: &mut MessageScope<'_, '_>,
    element: &Switch,
    selector: Option<&Selector>,
    rest: &[RangeInclusive<u64>],
) {
    let mut defaults = element.cases.iter().filter(|case| case.value.is_none());
    let first = defaults.next();
    if let (Some(first), Some(second)) = (first, defaults.next()) {
        let problem = Diagnostic::new(Code::SecondDefault, second.span, "a second `<default>`");
        scope.report(problem.label("again here").related(first.span, "first here").help("join them"));
    }
    let Some(selector) = selector.filter(|_| scope.whole) else { return };
    let (code, span, message, help) = match (first, rest) {
        (Some(Case { span, .. }), []) => {
            let message = format!("the default is never reached: the cases have every value of {}", selector.title());
            (Code::UnreachableCase, *span, message, "leave it out")
        }
        (None, [_, ..]) => {
            let message = format!("no case has the values {} of {}", list(rest), selector.title());
            (Code::MissingCase, element.span, message, "add a `<default>`")
        }
        _ => return,
    };
    let problem = Diagnostic::new(code, span, message);
    scope.report(problem.related(selector.span, format!("0 to {}", selector.most())).help(help));
}
