//! Diagnostics: what is wrong with a source, where, and what to do about it.
//!
//! They are collected, never thrown; a stage pushes and goes on, and its caller stops when one was an error.

mod code;
#[cfg(feature = "cli")]
mod json;
mod nearest;
mod render;

pub use code::{Code, Severity};
#[cfg(feature = "cli")]
pub use json::{json, json_message};
pub use nearest::nearest;
pub use render::{Style, one_line, render};

use std::collections::BTreeSet;

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

    /// Whether it is an error or a warning.
    pub fn severity(&self) -> Severity {
        self.code.severity()
    }
}

/// How many problems of one severity are kept: more than anybody reads, few enough for a file that is nothing but mistakes.
const MOST: usize = 200;

/// The problems found so far: the first 200 of each severity, and how many more there were.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
    errors: Count,
    warnings: Count,
    notes: Count,
    broken: BTreeSet<Option<FileId>>,
}

/// How many problems of a severity there are.
#[derive(Clone, Copy, Debug, Default)]
struct Count {
    listed: usize,
    more: usize,
}

impl Diagnostics {
    /// Adds one.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        let count = match diagnostic.severity() {
            Severity::Error => &mut self.errors,
            Severity::Warning => &mut self.warnings,
            Severity::Note => &mut self.notes,
        };
        if diagnostic.severity() == Severity::Error {
            self.broken.insert(diagnostic.span.map(|span| span.file));
        }
        if count.listed < MOST {
            count.listed += 1;
            self.list.push(diagnostic);
        } else {
            count.more += 1;
        }
    }

    /// Adds several, or the one that there may be.
    pub fn extend(&mut self, diagnostics: impl IntoIterator<Item = Diagnostic>) {
        diagnostics.into_iter().for_each(|diagnostic| self.push(diagnostic));
    }

    /// Puts them in the order in which a person mends them, file by file as they were loaded and from top to bottom, and says
    /// at the end how many are not listed. Those without a place come first.
    pub(crate) fn arrange(&mut self) {
        self.list.sort_by_key(|diagnostic| diagnostic.span.map(|span| (span.file, span.start)));
        let counts = [(self.errors.more, "error"), (self.warnings.more, "warning"), (self.notes.more, "note")];
        let more = counts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| match count {
            1 => format!("1 more {what}"),
            _ => format!("{count} more {what}s"),
        });
        let more: Vec<String> = more.collect();
        if !more.is_empty() {
            let message = format!("not listed: {}", more.join(", "));
            let help = "mend some of these first";
            self.list.push(Diagnostic::without_place(Code::NotListed, message).help(help));
        }
        (self.errors.more, self.warnings.more, self.notes.more) = (0, 0, 0);
    }

    /// The files that have an error; `None` stands for those that could not be read.
    pub(crate) fn broken_files(&self) -> impl Iterator<Item = Option<FileId>> {
        self.broken.iter().copied()
    }

    /// Whether one of them is an error.
    pub fn has_errors(&self) -> bool {
        !self.broken.is_empty()
    }

    /// All that are listed: by file and place once the dialect is resolved, before that in the order in which they were found.
    pub fn iter(&self) -> std::slice::Iter<'_, Diagnostic> {
        self.list.iter()
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
