//! Stages of life: `<wip>`, `<superseded>` and `<deprecated>`.

use super::text;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Lifecycle, Origin, Successor};
use crate::syntax::{self, Stage};

/// Reads a lifecycle element. A missing or odd date is worth a warning, since only people read it.
pub(super) fn resolve(element: &syntax::Lifecycle, diagnostics: &mut Diagnostics) -> Lifecycle {
    check_date(element, diagnostics);
    let successor = Successor {
        since: text::non_empty(element.since.as_ref()),
        replaced_by: text::non_empty(element.replaced_by.as_ref()),
        description: text::or_empty(element.description.as_ref()),
    };
    match element.stage {
        Stage::Wip => Lifecycle::Wip,
        Stage::Superseded => Lifecycle::Superseded(successor),
        Stage::Deprecated => Lifecycle::Deprecated(successor),
    }
}

/// Turns "deprecated" into a paragraph of the description: an overlay says that the item is in use all the same.
pub(super) fn tell(origin: &mut Origin) {
    let Some(Lifecycle::Deprecated(successor)) = &origin.lifecycle else { return };
    let mut text = "Deprecated".to_owned();
    if let Some(since) = &successor.since {
        text += &format!(" since {since}");
    }
    if let Some(other) = &successor.replaced_by {
        text += &format!(", replaced by {other}");
    }
    let why = successor.description.trim();
    origin.append(&if why.is_empty() { format!("{text}.") } else { format!("{text}: {why}") });
    origin.lifecycle = None;
}

fn check_date(element: &syntax::Lifecycle, diagnostics: &mut Diagnostics) {
    let name = match element.stage {
        Stage::Wip => "wip",
        Stage::Superseded => "superseded",
        Stage::Deprecated => "deprecated",
    };
    match &element.since {
        Some(since) if !is_date(&since.value) => {
            let message = format!("`{}` is not a date", since.value);
            let problem = Diagnostic::new(Code::Lifecycle, since.span, message);
            diagnostics
                .push(problem.label("not a year and a month; pymavlink refuses it").help("write it as `2024-07`"));
        }
        None if element.stage != Stage::Wip => {
            let message = format!("`<{name}>` does not say since when");
            let problem = Diagnostic::new(Code::Lifecycle, element.span, message);
            diagnostics.push(problem.label("`since` is missing; pymavlink refuses it").help("add `since=\"YYYY-MM\"`"));
        }
        _ => {}
    }
    if element.stage != Stage::Wip && element.replaced_by.is_none() {
        let message = format!("`<{name}>` does not say what replaces it");
        let problem = Diagnostic::new(Code::Lifecycle, element.span, message);
        diagnostics.push(
            problem
                .label("`replaced_by` is missing; pymavlink refuses it")
                .help("add `replaced_by=\"…\"`; it may be empty"),
        );
    }
}

/// Whether a text is `YYYY-MM`.
fn is_date(text: &str) -> bool {
    let all_digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    text.split_once('-').is_some_and(|(year, month)| {
        year.len() == 4 && all_digits(year) && month.len() == 2 && all_digits(month) && ("01"..="12").contains(&month)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates() {
        for date in ["2018-04", "2026-12", "2026-01"] {
            assert!(is_date(date), "{date}");
        }
        for date in
            ["", "2018", "2018-4", "2018-13", "2018-00", "18-04", "2018-04-01", "April 2018", "２018-04", "2018-+4"]
        {
            assert!(!is_date(date), "{date}");
        }
    }
}
