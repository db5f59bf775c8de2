//! `<case value="3..=9 30..">`: which values of the switch a case is for.

use std::ops::RangeInclusive;

use super::selector::Selector;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::resolve::message_scope::{MessageScope, parts};
use crate::resolve::number;
use crate::resolve::suggest::suggest;
use crate::syntax::Text;

/// A range of values, and where it is written.
pub(super) struct CaseValues {
    pub(super) range: RangeInclusive<u64>,
    pub(super) text: Text,
}

/// Why a part of a case is no range.
enum Refusal {
    Unknown(String),
    NoStart,
    Exclusive,
    Empty,
}

/// The ranges of a case, inside of what the switch can be; what is wrong is reported.
pub(super) fn ranges(
    scope: &MessageScope<'_, '_>,
    text: &Text,
    selector: &Selector,
    diagnostics: &mut Diagnostics,
) -> Vec<CaseValues> {
    let parts = parts(text);
    if parts.is_empty() {
        let problem = Diagnostic::new(Code::CaseValue, text.span, "a case of no values");
        diagnostics.push(problem.help(HELP));
    }
    let mut ranges = Vec::new();
    for part in parts {
        match range(scope, &part.value, selector) {
            Ok(range) if *range.end() <= selector.most => ranges.push(CaseValues { range, text: part }),
            Ok(range) => diagnostics.push(unreachable(&part, &range, selector)),
            Err(Refusal::Unknown(_)) if !scope.entries.complete => {}
            Err(refusal) => {
                let problem = refused(scope, &part, refusal, selector, diagnostics);
                diagnostics.push(problem);
            }
        }
    }
    ranges
}

const HELP: &str = "write `3`, `3..=9` or `30..`; several are separated by blanks";

/// One part: `a`, `a..=b` or `a..`.
fn range(scope: &MessageScope<'_, '_>, text: &str, selector: &Selector) -> Result<RangeInclusive<u64>, Refusal> {
    let value = |text: &str| {
        let number = number::unsigned(text).ok();
        let number = number.or_else(|| selector.enum_.and_then(|enum_| scope.entry(enum_, text)));
        number.ok_or_else(|| Refusal::Unknown(text.to_owned()))
    };
    let Some((start, end)) = text.split_once("..") else {
        let value = value(text)?;
        return Ok(value..=value);
    };
    if start.is_empty() {
        return Err(Refusal::NoStart);
    }
    let start = value(start)?;
    let end = match end.strip_prefix('=') {
        Some(end) => value(end)?,
        // A start beyond what there is makes a range that is refused as such.
        None if end.is_empty() => selector.most.max(start),
        None => return Err(Refusal::Exclusive),
    };
    if start > end { Err(Refusal::Empty) } else { Ok(start..=end) }
}

fn unreachable(text: &Text, range: &RangeInclusive<u64>, selector: &Selector) -> Diagnostic {
    let (name, most) = (&selector.title, selector.most);
    let beyond = (*range.start()).max(most.saturating_add(1));
    let message = format!("{name} is never {beyond}: it is at most {most}");
    let problem = Diagnostic::new(Code::UnreachableCase, text.span, message);
    problem.related(selector.span, format!("{name} is 0 to {most}")).help("leave it out, or correct it")
}

fn refused(
    scope: &MessageScope<'_, '_>,
    text: &Text,
    refusal: Refusal,
    selector: &Selector,
    before: &Diagnostics,
) -> Diagnostic {
    let problem = |message: String| Diagnostic::new(Code::CaseValue, text.span, message);
    match refusal {
        Refusal::Empty => {
            problem(format!("`{}` is no value: it ends before it starts", text.value)).help("the smaller one is first")
        }
        Refusal::NoStart => {
            problem(format!("`{}` does not say where it starts", text.value)).help(format!("write `0{}`", text.value))
        }
        Refusal::Exclusive => {
            let fixed = text.value.replace("..", "..=");
            problem(format!("`{}` is not a range of values", text.value)).help(format!("write `{fixed}`, end included"))
        }
        Refusal::Unknown(value) => {
            let problem = problem(format!("`{value}` is not a value of {}", selector.title)).help(HELP);
            let problem = problem.related(selector.span, "what the switch looks at");
            suggest(problem, &value, scope.entry_names(selector.enum_), before)
        }
    }
}
