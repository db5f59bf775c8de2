//! Files that include each other in a circle.

use super::Edge;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::FileIndex;

/// Reports every include that leads back to a file on the way to it.
///
/// `edges` are the includes of each file, `names` the files as diagnostics show them. The way is kept in a list and not in
/// calls: a hostile dialect can make it as long as it likes.
pub(super) fn report(edges: &[Vec<Edge>], names: &[String], diagnostics: &mut Diagnostics) {
    let mut done = vec![false; edges.len()];
    let mut way = vec![Stop { file: FileIndex(0), next: 0 }];
    while let Some(stop) = way.last_mut() {
        let edge = edges.get(stop.file.0).and_then(|edges| edges.get(stop.next)).copied();
        let Some(edge) = edge else {
            if let Some(done) = done.get_mut(stop.file.0) {
                *done = true;
            }
            way.pop();
            continue;
        };
        stop.next += 1;
        if done.get(edge.to.0).copied().unwrap_or(true) {
            continue;
        }
        match way.iter().position(|stop| stop.file == edge.to) {
            Some(start) => {
                let circle = way.iter().skip(start).filter_map(|stop| stop.taken(edges));
                diagnostics.push(describe(&circle.collect_vec(), edge, names));
            }
            None => way.push(Stop { file: edge.to, next: 0 }),
        }
    }
}

/// A file on the way, and which of its includes comes next.
struct Stop {
    file: FileIndex,
    next: usize,
}

impl Stop {
    /// The include by which the way goes on.
    fn taken(&self, edges: &[Vec<Edge>]) -> Option<Edge> {
        edges.get(self.file.0)?.get(self.next.checked_sub(1)?).copied()
    }
}

/// `circle` are the includes from the file that is come back to; the last of them is `closing`.
fn describe(circle: &[Edge], closing: Edge, names: &[String]) -> Diagnostic {
    let name = |edge: &Edge| names.get(edge.to.0).map(String::as_str).unwrap_or_default();
    let target = name(&closing);
    let error = match circle {
        [_] => format!("`{target}` includes itself"),
        _ => format!("`{target}` includes itself through other files"),
    };
    let error = Diagnostic::new(Code::IncludeCycle, closing.span, error);
    let error = error.label(format!("includes `{target}` again"));
    let before = circle.split_last().map(|(_, before)| before).unwrap_or_default();
    before.iter().fold(error, |error, edge| error.related(edge.span, format!("includes `{}`", name(edge))))
}
