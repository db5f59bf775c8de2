//! Why the program ends early.

use std::fmt::Display;
use std::io::{self, ErrorKind};
use std::path::Path;

/// Why the program ends before its work is done.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A sentence for the user.
    Sentence(String),
    /// Whoever reads the output has seen enough: no fault of anybody.
    ReaderGone,
}

impl Failure {
    pub(crate) fn new(sentence: impl Into<String>) -> Self {
        Self::Sentence(sentence.into())
    }

    /// What went wrong with a file, a device or an address.
    pub(crate) fn with(subject: impl Display, error: impl Display) -> Self {
        Self::Sentence(format!("{subject}: {error}"))
    }

    /// What went wrong with a file.
    pub(crate) fn file(path: &Path, error: impl Display) -> Self {
        Self::with(path.display(), error)
    }

    /// What went wrong with an [`Output`](crate::output::Output), whose name the error has.
    pub(crate) fn written(error: io::Error) -> Self {
        match error.kind() {
            ErrorKind::BrokenPipe => Self::ReaderGone,
            _ => Self::new(error.to_string()),
        }
    }

    /// The same of a table.
    pub(crate) fn table(error: csv::Error) -> Self {
        match error.into_kind() {
            csv::ErrorKind::Io(error) => Self::written(error),
            other => Self::new(format!("{other:?}")),
        }
    }
}
