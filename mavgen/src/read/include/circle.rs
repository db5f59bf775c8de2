//! Files that include each other in a circle.

use super::Edge;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::FileIndex;

/// A file on the way: by which include it was come to, and those of its own that were not followed yet.
struct Stop<'e> {
    file: FileIndex,
    by: Option<Edge>,
    next: std::slice::Iter<'e, Edge>,
}

/// Reports every include that leads back to a file on the way to it.
///
/// `edges` are the includes of each file, `names` the files as diagnostics show them. The way is kept in a list and not in
/// calls: a hostile dialect can make it as long as it likes.
pub(super) fn report(edges: &[Vec<Edge>], names: &[String], diagnostics: &mut Diagnostics) {
    let stop = |file: FileIndex, by| edges.get(file.0).map(|edges| Stop { file, by, next: edges.iter() });
    let mut done = vec![false; edges.len()];
    let mut way = Vec::new();
    way.extend(stop(FileIndex(0), None));
    while let Some(last) = way.last_mut() {
        let Some(&edge) = last.next.next() else {
            done.get_mut(last.file.0).into_iter().for_each(|done| *done = true);
            way.pop();
            continue;
        };
        if done.get(edge.to.0).copied().unwrap_or(true) {
            continue;
        }
        match way.iter().position(|stop| stop.file == edge.to) {
            Some(start) => {
                let before = way.iter().skip(start + 1).filter_map(|stop| stop.by).collect_vec();
                diagnostics.push(describe(&before, edge, names));
            }
            None => way.extend(stop(edge.to, Some(edge))),
        }
    }
}

/// `before` are the includes from the file that is come back to by `closing`.
fn describe(before: &[Edge], closing: Edge, names: &[String]) -> Diagnostic {
    let name = |edge: &Edge| names.get(edge.to.0).map(String::as_str).unwrap_or_default();
    let target = name(&closing);
    let way = if before.is_empty() { "" } else { " through other files" };
    let error = Diagnostic::new(Code::IncludeCycle, closing.span, format!("`{target}` includes itself{way}"));
    let error = error.label(format!("includes `{target}` again"));
    before.iter().fold(error, |error, edge| error.related(edge.span, format!("includes `{}`", name(edge))))
}
