//! Stages of life: `<wip>`, `<superseded>` and `<deprecated>`.

use super::text;
use crate::decimal::is_year_and_month;
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
    let text = format!("Deprecated{successor}");
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
        Some(since) if !is_year_and_month(&since.value) => {
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
