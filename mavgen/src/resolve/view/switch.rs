//! `<switch>`: what it looks at, and its cases.

use std::ops::RangeInclusive;

use super::case::{self, Values};
use super::piece::{self, Piece};
use super::ranges::{complement, joined, list};
use super::words::Words;
use super::{place, ranges, spelling};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{EnumId, Label, Meaning, SwitchOn};
use crate::resolve::message_scope::{EnumUse, MessageScope};
use crate::source::Span;
use crate::syntax::Text;
use crate::syntax::overlay::{Case, Switch};

/// What a switch looks at.
pub(super) struct Selector {
    /// The name of its getter.
    pub(super) name: Label,
    /// What a message calls it.
    pub(super) title: String,
    /// Where it is read.
    pub(super) on: SwitchOn,
    /// The largest value.
    pub(super) most: u64,
    /// The enum of its values.
    pub(super) values: Option<EnumId>,
    /// Where it is defined.
    pub(super) span: Span,
    /// Where the switch names it.
    pub(super) named: Span,
}

/// One of the layouts.
pub(super) struct Branch<'a> {
    /// The values it is for: sorted and apart.
    pub(super) ranges: Vec<RangeInclusive<u64>>,
    /// Its parts, beside those of every layout.
    pub(super) pieces: Vec<Piece<'a>>,
    /// The start tag.
    pub(super) span: Span,
}

/// Resolves what a switch looks at: a field, or bits that stand before it in every layout.
pub(super) fn selector(
    scope: &MessageScope<'_, '_>,
    element: &Switch,
    words: &Words,
    common: &[Piece<'_>],
    diagnostics: &mut Diagnostics,
) -> Option<Selector> {
    let message = match (&element.field, &element.bits) {
        (Some(field), None) => return on_field(scope, field, words, diagnostics),
        (None, Some(bits)) => return on_bits(bits, common, diagnostics),
        (None, None) => "a switch does not say what it looks at",
        (Some(_), Some(_)) => "a switch looks at a field and at bits",
    };
    let problem = Diagnostic::new(Code::SwitchOn, element.span, message);
    diagnostics.push(problem.help("write `field=\"…\"` or `bits=\"…\"`"));
    None
}

fn on_field(
    scope: &MessageScope<'_, '_>,
    text: &Text,
    words: &Words,
    diagnostics: &mut Diagnostics,
) -> Option<Selector> {
    let (place, found) = place::beside(scope, text, words, diagnostics)?;
    let (name, ty) = (&found.syntax.name, &found.syntax.ty);
    let Some(repr) = found.field.ty.scalar.repr().filter(|repr| !repr.is_signed()) else {
        let message = format!("`{}.{}` is `{}`, which no switch can look at", scope.name(), name.value, ty.value);
        let problem = Diagnostic::new(Code::SwitchOn, text.span, message).related(ty.span, "the field");
        diagnostics.push(problem.help("a switch looks at an unsigned integer"));
        return None;
    };
    Some(Selector {
        name: spelling::label(name),
        title: format!("`{}`", name.value),
        on: SwitchOn::Field(place, repr),
        most: repr.highest(),
        values: scope.values_of(found.syntax),
        span: ty.span,
        named: text.span,
    })
}

fn on_bits(text: &Text, common: &[Piece<'_>], diagnostics: &mut Diagnostics) -> Option<Selector> {
    let name = spelling::label(text);
    let members = || common.iter().filter_map(|piece| piece.member.as_ref());
    let Some((member, bits)) = members().find(|(member, _)| member.name == name) else {
        let message = format!("`{}` is not in every layout of the view", text.value);
        let problem = Diagnostic::new(Code::SwitchOn, text.span, message).label("no such bits outside of the switch");
        let names = members().map(|(_, bits)| bits.name.value.as_str());
        let problem = crate::resolve::suggest::suggest(problem, &text.value, names, diagnostics);
        diagnostics.push(problem);
        return None;
    };
    let values = match member.meaning {
        Meaning::Values(values) => Some(values),
        Meaning::Number { .. } | Meaning::Flag | Meaning::Scaled(_) => None,
    };
    let plain = !matches!(member.meaning, Meaning::Scaled(_)) && !member.signed && member.repeat.is_none();
    if !plain || member.width > 64 {
        let message = format!("`{}` is no plain number, which no switch can look at", text.value);
        let problem = Diagnostic::new(Code::SwitchOn, text.span, message).related(bits.span, "the bits");
        diagnostics.push(problem.help("a switch looks at up to 64 bits without sign, scale or repetition"));
        return None;
    }
    Some(Selector {
        name,
        title: format!("`{}`", text.value),
        on: SwitchOn::Bits { at: member.at, width: member.width },
        most: u64::MAX >> (64 - u32::from(member.width)),
        values,
        span: bits.width.span,
        named: text.span,
    })
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
        let pieces: Vec<Option<Piece<'a>>> = pieces.collect();
        whole &= pieces.iter().all(Option::is_some);
        branches.push(Branch { ranges, pieces: pieces.into_iter().flatten().collect(), span: case.span });
    }
    Some(branches).filter(|_| whole)
}

/// The values of every case, of which none may be in two.
fn cases(
    scope: &MessageScope<'_, '_>,
    element: &Switch,
    selector: &Selector,
    diagnostics: &mut Diagnostics,
) -> Vec<Vec<Values>> {
    let mut all: Vec<Vec<Values>> = Vec::new();
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

fn in_two_cases(first: &Values, second: &Values, selector: &Selector) -> Option<Diagnostic> {
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
