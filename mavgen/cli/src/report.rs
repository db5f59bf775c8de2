//! What goes to standard error, and text to standard output.

pub(super) mod json;

use std::fmt;
use std::io::{ErrorKind, Write};

use clap::{Args, ValueEnum};
use mavgen::diag::{Diagnostics, Severity, Style, render};
use mavgen::source::Sources;
use mavgen::{Failure, Problems};

/// How commands speak of problems.
#[derive(Args, Default)]
pub(super) struct Report {
    /// What diagnostics look like on standard error.
    #[arg(long, value_name = "FORMAT", value_enum, default_value_t = Format::Human, global = true)]
    message_format: Format,
}

/// What a diagnostic looks like.
#[derive(Clone, Copy, Default, ValueEnum)]
enum Format {
    /// Drawn, with the line of the source, for people.
    #[default]
    Human,
    /// One JSON object on one line each, for programs.
    Json,
}

impl Report {
    /// Why a command did not do what it was asked for.
    pub(super) fn failure(&self, failure: &Failure) {
        match failure {
            Failure::Definitions(problems) => self.problems(problems),
            Failure::Denied(problems) => {
                self.problems(problems);
                self.denied();
            }
            other => self.error(&other.to_string()),
        }
    }

    fn problems(&self, Problems { diagnostics, sources, .. }: &Problems) {
        self.diagnostics(diagnostics, sources);
    }

    /// Problems with their places.
    pub(super) fn diagnostics(&self, diagnostics: &Diagnostics, sources: &Sources) {
        for diagnostic in diagnostics.iter() {
            match self.message_format {
                Format::Human => say(format_args!("{}\n", render(diagnostic, sources, Style::Coloured))),
                Format::Json => say(format_args!("{}", json::diagnostic(diagnostic, sources))),
            }
        }
    }

    /// Says why warnings made a command fail.
    pub(super) fn denied(&self) {
        self.error("warnings about the dialect's own file and its overlays are denied");
    }

    fn error(&self, message: &str) {
        match self.message_format {
            Format::Human => say(format_args!("error: {message}")),
            Format::Json => say(format_args!("{}", json::message(Severity::Error, message))),
        }
    }

    /// One line on what was done, or what to do.
    pub(super) fn note(&self, message: &str) {
        match self.message_format {
            Format::Human => say(format_args!("{message}")),
            Format::Json => say(format_args!("{}", json::message(Severity::Note, message))),
        }
    }
}

/// One more line on standard error. If that is closed or full there is nobody to tell; the exit status still says it.
fn say(line: fmt::Arguments<'_>) {
    let _ = writeln!(anstream::stderr(), "{line}");
}

/// Prints a command's result as it is.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    printed(std::io::stdout().lock().write_all(text.as_bytes()))
}

/// Prints a command's result, without its colours where nobody sees them.
pub(super) fn print_coloured(text: &str) -> Result<(), Failure> {
    printed(anstream::stdout().lock().write_all(text.as_bytes()))
}

fn printed(result: std::io::Result<()>) -> Result<(), Failure> {
    match result {
        // A reader that has seen enough, like `head`, is no error.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::Usage(format!("standard output: {error}"))),
        _ => Ok(()),
    }
}

/// `1 error`, `2 errors`.
pub(super) fn plural(count: usize, what: &str) -> String {
    let s = if count == 1 { "" } else { "s" };
    format!("{count} {what}{s}")
}
