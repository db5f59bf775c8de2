//! What every item says of itself, and optional texts as the model keeps them.

use crate::decimal::is_year_and_month;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{FileIndex, Lifecycle, Origin, Successor};
use crate::source::Span;
use crate::syntax::{self, Stage, Text};

/// The text, if it says anything.
pub(super) fn non_empty(text: &Option<Text>) -> Option<String> {
    text.as_ref().map(|text| text.value.clone()).filter(|value| !value.is_empty())
}

/// The text, or an empty one.
pub(super) fn or_empty(text: &Option<Text>) -> String {
    text.as_ref().map(|text| text.value.clone()).unwrap_or_default()
}

/// The origin of an element, which overlays may add to later.
pub(super) fn origin(file: FileIndex, span: Span, description: &Option<Text>, lifecycle: Option<Lifecycle>) -> Origin {
    Origin { file, overlays: Vec::new(), span, description: or_empty(description), lifecycle }
}

/// Reads a lifecycle element. A missing or odd date is worth a warning, since only people read it.
pub(super) fn lifecycle(element: &Option<syntax::Lifecycle>, diagnostics: &mut Diagnostics) -> Option<Lifecycle> {
    let element = element.as_ref()?;
    let successor = || Successor {
        since: non_empty(&element.since),
        replaced_by: non_empty(&element.replaced_by),
        description: or_empty(&element.description),
    };
    let (name, lifecycle) = match element.stage {
        Stage::Wip => ("wip", Lifecycle::Wip),
        Stage::Superseded => ("superseded", Lifecycle::Superseded(successor())),
        Stage::Deprecated => ("deprecated", Lifecycle::Deprecated(successor())),
    };
    check(element, name, diagnostics);
    Some(lifecycle)
}

/// Turns "deprecated" into a paragraph of the description: an overlay says that the item is in use all the same.
pub(super) fn tell_deprecated(origin: &mut Origin) {
    let Some(Lifecycle::Deprecated(successor)) = &origin.lifecycle else { return };
    let text = format!("Deprecated{successor}");
    let why = successor.description.trim();
    origin.append(&if why.is_empty() { format!("{text}.") } else { format!("{text}: {why}") });
    origin.lifecycle = None;
}

/// Checks the date, and that something is said of what comes after.
fn check(element: &syntax::Lifecycle, name: &str, diagnostics: &mut Diagnostics) {
    let mut report = |span, message, label: &str, help| {
        let label = format!("{label}; pymavlink refuses it");
        diagnostics.push(Diagnostic::new(Code::Lifecycle, span, message).label(label).help(help));
    };
    let replaced = element.stage != Stage::Wip;
    match &element.since {
        Some(since) if !is_year_and_month(&since.value) => {
            let message = format!("`{}` is not a date", since.value);
            report(since.span, message, "not a year and a month", "write it as `2024-07`");
        }
        None if replaced => {
            let message = format!("`<{name}>` does not say since when");
            report(element.span, message, "`since` is missing", "add `since=\"YYYY-MM\"`");
        }
        _ => {}
    }
    if replaced && element.replaced_by.is_none() {
        let message = format!("`<{name}>` does not say what replaces it");
        let help = "add `replaced_by=\"…\"`; it may be empty";
        report(element.span, message, "`replaced_by` is missing", help);
    }
}
