//! What somebody may have meant: the nearest of the names that exist, as help.

use crate::diag::{Diagnostic, Diagnostics, nearest};

/// After so many problems there are no more suggestions: nobody would read them, and looking for them takes long.
const MOST_PROBLEMS: usize = 25;

/// Reports a name that means nothing, with what may have been meant.
pub(super) fn report(
    problem: Diagnostic,
    name: &str,
    candidates: &mut dyn Iterator<Item = &str>,
    diagnostics: &mut Diagnostics,
) {
    report_by(problem, &mut || nearest(name, &mut *candidates), diagnostics);
}

/// Reports a problem, with what `find` says was meant.
pub(super) fn report_by<'c>(
    problem: Diagnostic,
    find: &mut dyn FnMut() -> Option<&'c str>,
    diagnostics: &mut Diagnostics,
) {
    let meant = if diagnostics.are_at_least(MOST_PROBLEMS) { None } else { find() };
    diagnostics.push(match meant {
        Some(meant) => problem.help(format!("did you mean `{meant}`?")),
        None => problem,
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::Code;

    #[test]
    fn suggestions_end_where_nobody_reads_them() {
        let mut diagnostics = Diagnostics::default();
        for count in 0..=MOST_PROBLEMS {
            let problem = Diagnostic::without_place(Code::UnknownEnum, "");
            report(problem, "MAV_STAT", &mut ["MAV_STATE"].into_iter(), &mut diagnostics);
            let suggested = diagnostics.iter().last().unwrap();
            assert_eq!(suggested.help.is_some(), count < MOST_PROBLEMS, "{count}");
        }
    }
}
