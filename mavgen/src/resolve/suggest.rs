//! What somebody may have meant: the nearest of the names that exist, as help.

use crate::diag::{Diagnostic, Diagnostics, nearest};

/// After so many problems there are no more suggestions.
const MOST_PROBLEMS: usize = 25;

/// Adds what may have been meant to a problem, unless there are so many problems already that nobody would read it: looking
/// for it takes long.
pub(super) fn suggest<'c>(
    problem: Diagnostic,
    name: &str,
    candidates: impl IntoIterator<Item = &'c str>,
    before: &Diagnostics,
) -> Diagnostic {
    suggest_by(problem, before, || nearest(name, candidates))
}

/// Adds what `find` says was meant, on the same terms.
pub(super) fn suggest_by<'c>(
    problem: Diagnostic,
    before: &Diagnostics,
    find: impl FnOnce() -> Option<&'c str>,
) -> Diagnostic {
    let meant = if before.are_at_least(MOST_PROBLEMS) { None } else { find() };
    match meant {
        Some(meant) => problem.help(format!("did you mean `{meant}`?")),
        None => problem,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::Code;

    #[test]
    fn suggestions_end_where_nobody_reads_them() {
        let problem = Diagnostic::without_place(Code::UnknownEnum, "");
        let mut diagnostics = Diagnostics::default();
        for count in 0..=MOST_PROBLEMS {
            let suggested = suggest(problem.clone(), "MAV_STAT", ["MAV_STATE"], &diagnostics);
            assert_eq!(suggested.help.is_some(), count < MOST_PROBLEMS, "{count}");
            diagnostics.push(problem.clone());
        }
    }
}
