//! Diagnostics: what is wrong with a source, where, and what to do about it.
//!
//! They are collected, never thrown; a stage pushes and goes on, and its caller stops when one was an error.

mod code;
mod nearest;
mod render;

pub use code::{Code, Severity, UnknownCode};
pub use nearest::nearest;
pub use render::{Style, one_line, render};

use std::collections::HashSet;

use crate::collect::CollectVec as _;
use crate::order;
use crate::source::{FileId, Span};

/// One problem.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// Which kind of problem, with its stable number and its severity.
    pub code: Code,
    /// What is wrong, in one line, with the names and numbers of this case.
    pub message: String,
    /// Where. Only problems of the file system have no place.
    pub span: Option<Span>,
    /// What the carets under the place say; may be empty.
    pub label: String,
    /// Other places that have to do with it: the first definition, the include that led here.
    pub related: Vec<Related>,
    /// What to do, in one line.
    pub help: Option<String>,
}

/// Another place that a diagnostic speaks of.
#[derive(Clone, Debug)]
pub struct Related {
    /// The place.
    pub span: Span,
    /// What is there.
    pub label: String,
}

impl Diagnostic {
    /// A problem at a place.
    pub fn new(code: Code, span: Span, message: impl Into<String>) -> Self {
        Self { span: Some(span), ..Self::without_place(code, message) }
    }

    /// A problem that no source contains: a file that cannot be read.
    pub fn without_place(code: Code, message: impl Into<String>) -> Self {
        let (label, related) = (String::new(), Vec::new());
        Self { code, message: message.into(), span: None, label, related, help: None }
    }

    /// Says what the carets under the place say.
    #[must_use]
    pub fn label(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// Adds another place.
    #[must_use]
    pub fn related(mut self, span: Span, label: impl Into<String>) -> Self {
        self.related.push(Related { span, label: label.into() });
        self
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Asks whether the name that is nearest to the wrong one was meant, if there is one: a better help than any other.
    #[must_use]
    pub(crate) fn meant(self, nearest: Option<&str>) -> Self {
        match nearest {
            Some(name) => self.help(format!("did you mean `{name}`?")),
            None => self,
        }
    }

    /// Whether it is an error or a warning.
    pub fn severity(&self) -> Severity {
        self.code.severity()
    }
}

/// How many problems of one severity are listed: more than anybody reads, few enough for a file that is nothing but mistakes.
const MOST: usize = 200;

/// The problems found so far: in the end the first 200 of each severity, and how many more there were.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
    /// How many there were of a kind; the first of them are in the list. No kind fills it, so that all are in it when it is put in order.
    kept: Vec<(Code, usize)>,
    /// How many of a severity are not in the list.
    more: Vec<(Severity, usize)>,
    /// The files with an error, each once.
    broken: Vec<Option<FileId>>,
    /// The kinds that nobody wants to hear of.
    left_out: Vec<Code>,
    /// Whether what only `lint` tells is listed.
    for_lint: bool,
}

impl Diagnostics {
    /// None yet, and none of these kinds later.
    pub(crate) fn leaving_out(codes: Vec<Code>) -> Self {
        Self { left_out: codes, ..Self::default() }
    }

    /// Takes from now on what only `lint` tells as well: see [`Code::is_for_lint`].
    #[must_use]
    pub fn for_lint(mut self) -> Self {
        self.for_lint = true;
        self
    }

    /// Adds one.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        if self.left_out.contains(&diagnostic.code) || diagnostic.code.is_for_lint() && !self.for_lint {
            return;
        }
        if diagnostic.severity() == Severity::Error {
            let file = diagnostic.span.map(|span| span.file);
            if !self.broken.contains(&file) {
                self.broken.push(file);
            }
        }
        if count(&mut self.kept, diagnostic.code) <= MOST {
            self.list.push(diagnostic);
        } else {
            count(&mut self.more, diagnostic.severity());
        }
    }

    /// Takes back warnings that turned out to be an echo of something else.
    pub(crate) fn withdraw(&mut self, is_echo: impl Fn(&Diagnostic) -> bool) {
        self.list.retain(|diagnostic| diagnostic.severity() == Severity::Error || !is_echo(diagnostic));
    }

    /// Adds a diagnostic of what leaves nothing to go on with.
    pub(crate) fn refuse<T>(&mut self, diagnostic: Diagnostic) -> Option<T> {
        self.push(diagnostic);
        None
    }

    /// Adds several, or the one that there may be.
    pub fn extend(&mut self, diagnostics: impl IntoIterator<Item = Diagnostic>) {
        diagnostics.into_iter().for_each(|diagnostic| self.push(diagnostic));
    }

    /// Puts them in the order in which a person mends them, file by file as they were loaded and from top to bottom, and says
    /// at the end how many are not listed. Those without a place come first. That pymavlink refuses something is left out
    /// where an error is told of the same place, or a warning that says so itself.
    pub(crate) fn arrange(&mut self) {
        let refusal = |diagnostic: &Diagnostic| diagnostic.code == Code::PymavlinkRefuses;
        let says_so = |one: &Diagnostic| {
            one.severity() == Severity::Error
                || [Some(&one.label), one.help.as_ref()].into_iter().flatten().any(|text| text.contains("pymavlink"))
        };
        let told = self.list.iter().filter(|one| !refusal(one) && says_so(one));
        let told: HashSet<Span> = told.filter_map(|one| one.span).collect();
        self.list.retain(|one| !refusal(one) || one.span.is_none_or(|span| !told.contains(&span)));
        order::sort_by_key(&mut self.list, |diagnostic| diagnostic.span.map(|span| (span.file, span.start)));
        let mut listed = Vec::new();
        let more = &mut self.more;
        self.list.retain(|diagnostic| {
            let fits = count(&mut listed, diagnostic.severity()) <= MOST;
            if !fits {
                count(more, diagnostic.severity());
            }
            fits
        });
        order::sort_by_key(more, |(severity, _)| *severity);
        self.list.extend(not_listed(&std::mem::take(more)));
    }

    /// The files that have an error; `None` stands for those that could not be read.
    pub(crate) fn broken_files(&self) -> &[Option<FileId>] {
        &self.broken
    }

    /// Whether one of them is an error.
    pub fn has_errors(&self) -> bool {
        !self.broken.is_empty()
    }

    /// All that are listed: by file and place once the dialect is resolved, before that in the order in which they were found.
    pub fn iter(&self) -> std::slice::Iter<'_, Diagnostic> {
        self.list.iter()
    }

    /// Whether so many concern everybody, not `lint` alone.
    pub(crate) fn are_at_least(&self, count: usize) -> bool {
        self.list.iter().filter(|diagnostic| !diagnostic.code.is_for_lint()).nth(count.saturating_sub(1)).is_some()
    }

    /// How many are listed.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }
}

/// Counts one of a kind, of which there are few, and gives how many there are now.
fn count<K: PartialEq>(counts: &mut Vec<(K, usize)>, kind: K) -> usize {
    match counts.iter_mut().find(|(known, _)| *known == kind) {
        Some((_, count)) => {
            *count += 1;
            *count
        }
        None => {
            counts.push((kind, 1));
            1
        }
    }
}

/// What is said of the problems that are not listed.
fn not_listed(more: &[(Severity, usize)]) -> Option<Diagnostic> {
    let counts: Vec<String> = (more.iter().filter(|(_, count)| *count > 0))
        .map(|(severity, count)| format!("{count} more {severity}{}", if *count == 1 { "" } else { "s" }))
        .collect_vec();
    let message = format!("not listed: {}", counts.join(", "));
    let note = Diagnostic::without_place(Code::NotListed, message).help("mend some of these first");
    if counts.is_empty() { None } else { Some(note) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Sources;

    #[test]
    fn arranged_by_file_and_place() {
        let mut sources = Sources::default();
        let (a, b) = (sources.add("a.xml", ""), sources.add("b.xml", ""));
        let mut diagnostics = Diagnostics::default();
        for (file, at) in [(b, 3), (a, 7), (b, 1), (a, 7), (a, 2)] {
            let message = diagnostics.len().to_string();
            diagnostics.push(Diagnostic::new(Code::BadName, Span::new(file, at..at), message));
        }
        diagnostics.push(Diagnostic::without_place(Code::Unreadable, "5"));
        diagnostics.arrange();
        let order: String = diagnostics.iter().map(|diagnostic| diagnostic.message.as_str()).collect();
        assert_eq!(order, "541320");
    }

    #[test]
    fn what_is_not_listed_is_counted() {
        let mut diagnostics = Diagnostics::default();
        let add = |diagnostics: &mut Diagnostics, code| diagnostics.push(Diagnostic::without_place(code, ""));
        (0..=MOST + 1).for_each(|_| add(&mut diagnostics, Code::Units));
        assert!(!diagnostics.has_errors());
        (0..=MOST).for_each(|_| add(&mut diagnostics, Code::BadName));
        assert!(diagnostics.has_errors());
        diagnostics.arrange();
        assert_eq!(diagnostics.len(), 2 * MOST + 1);
        let last = diagnostics.iter().last().unwrap();
        assert_eq!(last.message, "not listed: 1 more error, 2 more warnings");
        diagnostics.arrange();
        assert_eq!(diagnostics.len(), 2 * MOST + 1);
    }
}
