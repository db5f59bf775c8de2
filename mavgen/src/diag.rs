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
pub use json::json;
pub use nearest::nearest;
pub use render::{Style, one_line, render};

use crate::source::Span;

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

/// The problems found so far.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
}

impl Diagnostics {
    /// Adds one.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        self.list.push(diagnostic);
    }

    /// Adds several, or the one that there may be.
    pub fn extend(&mut self, diagnostics: impl IntoIterator<Item = Diagnostic>) {
        self.list.extend(diagnostics);
    }

    /// Whether one of them is an error.
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|diagnostic| diagnostic.severity() == Severity::Error)
    }

    /// All of them, in the order in which they were found.
    pub fn iter(&self) -> std::slice::Iter<'_, Diagnostic> {
        self.list.iter()
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }
}
