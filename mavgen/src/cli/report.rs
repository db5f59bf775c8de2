//! What goes to standard error, and text to standard output.

use std::io::{ErrorKind, IsTerminal, Write};

use mavgen::Failure;
use mavgen::diag::{Diagnostics, Style, render};
use mavgen::source::Sources;

/// Why a command did not do what it was asked for.
pub(super) fn failure(failure: &Failure) {
    match failure {
        Failure::Definitions(problems) => diagnostics(&problems.diagnostics, &problems.sources),
        other => anstream::eprintln!("error: {other}"),
    }
}

/// Problems, drawn.
pub(super) fn diagnostics(diagnostics: &Diagnostics, sources: &Sources) {
    let style = if std::io::stderr().is_terminal() { Style::Coloured } else { Style::Plain };
    for diagnostic in diagnostics.iter() {
        anstream::eprintln!("{}\n", render(diagnostic, sources, style));
    }
}

/// Prints a command's result.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        // A reader that has seen enough, like `head`, is no error.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::Usage(format!("standard output: {error}"))),
        _ => Ok(()),
    }
}
