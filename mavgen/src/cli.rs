//! The command line: parses, calls one library function, prints.
//!
//! Exit status: 0 fine, 1 the answer is no (`check`), 2 the input or the usage is wrong.

mod dump;

use std::io::{IsTerminal, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use clap::{Args, Parser, Subcommand};
use mavgen::diag::{Diagnostics, Style, render};
use mavgen::output::Differences;
use mavgen::source::Sources;
use mavgen::{Builder, Failure, Resolved};

/// The MAVLink dialect compiler: typed Rust from dialect XML.
#[derive(Parser)]
#[command(version, after_help = "Exit status: 0 fine, 1 `check` found differences, 2 the input or the usage is wrong.")]
struct Command {
    #[command(subcommand)]
    action: Action,
}

#[derive(Subcommand)]
enum Action {
    /// Writes Rust sources into a folder.
    ///
    /// Files that are already right are left untouched, files of an earlier run that are no longer generated are removed,
    /// everything else in the folder is left alone.
    #[command(after_help = "Example: mavgen generate xml/acme.xml --out src/acme")]
    Generate(#[command(flatten)] Output),
    /// Compares a folder with what `generate` would write, and says no (exit status 1) if they differ.
    #[command(after_help = "Example, in CI: mavgen check xml/acme.xml --out src/acme")]
    Check(#[command(flatten)] Output),
    /// Prints the resolved dialect: wire order, offsets, checksums, merged enums.
    #[command(after_help = "Example: mavgen dump xml/acme.xml --json | jq '.messages[].name'")]
    Dump {
        #[command(flatten)]
        input: Input,
        /// As JSON, in a stable schema.
        #[arg(long)]
        json: bool,
    },
}

#[derive(Args)]
struct Input {
    /// The dialect's XML file.
    xml: PathBuf,
    /// Where to look for includes that do not lie beside the file that names them; may be given several times.
    #[arg(long, value_name = "DIR")]
    include_dir: Vec<PathBuf>,
    /// A file that says what the XML cannot, like the meaning of packed bits; may be given several times.
    #[arg(long, value_name = "FILE")]
    overlay: Vec<PathBuf>,
}

#[derive(Args)]
struct Output {
    #[command(flatten)]
    input: Input,
    /// The folder for the sources.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

impl Input {
    fn builder(&self) -> Builder {
        let builder = Builder::new(&self.xml);
        let builder = self.include_dir.iter().fold(builder, |builder, folder| builder.include_dir(folder));
        self.overlay.iter().fold(builder, |builder, file| builder.overlay(file))
    }
}

/// Runs the command that the arguments name.
pub(crate) fn run() -> ExitCode {
    let outcome = match Command::parse().action {
        Action::Generate(output) => generate(&output),
        Action::Check(output) => check(&output),
        Action::Dump { input, json } => dump(&input, json),
    };
    outcome.unwrap_or_else(|failure| {
        fail(&failure);
        ExitCode::from(2)
    })
}

fn generate(output: &Output) -> Result<ExitCode, Failure> {
    let (start, builder) = (Instant::now(), output.input.builder().out_dir(&output.out));
    let resolved = builder.resolve()?;
    print_diagnostics(&resolved.diagnostics, &resolved.sources);
    let report = builder.write(&resolved)?;
    let (written, kept, removed) = (report.written, report.kept, report.removed);
    let (out, elapsed) = (output.out.display(), start.elapsed().as_millis());
    anstream::eprintln!("{out}: {written} files written, {kept} kept, {removed} removed, in {elapsed} ms");
    Ok(ExitCode::SUCCESS)
}

fn check(output: &Output) -> Result<ExitCode, Failure> {
    let Differences { changed, missing, stale } = output.input.builder().out_dir(&output.out).check()?;
    let lists = [("differs", &changed), ("is missing", &missing), ("is no longer generated", &stale)];
    for (what, paths) in lists {
        for path in paths {
            anstream::eprintln!("{} {what}", path.display());
        }
    }
    if changed.is_empty() && missing.is_empty() && stale.is_empty() {
        return Ok(ExitCode::SUCCESS);
    }
    let (xml, out) = (output.input.xml.display(), output.out.display());
    let overlays = output.input.overlay.iter().map(|file| format!(" --overlay {}", file.display()));
    let overlays: String = overlays.collect();
    anstream::eprintln!("run `mavgen generate {xml}{overlays} --out {out}`");
    Ok(ExitCode::from(1))
}

fn dump(input: &Input, json: bool) -> Result<ExitCode, Failure> {
    let Resolved { dialect, diagnostics, sources, .. } = input.builder().resolve()?;
    print_diagnostics(&diagnostics, &sources);
    let text = if json { dump::json(&dialect) } else { dump::text(&dialect) };
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        // A reader that has seen enough, like `head`, is no error.
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::Usage(format!("standard output: {error}")))
        }
        _ => Ok(ExitCode::SUCCESS),
    }
}

fn fail(failure: &Failure) {
    match failure {
        Failure::Definitions(problems) => print_diagnostics(&problems.diagnostics, &problems.sources),
        other => anstream::eprintln!("error: {other}"),
    }
}

fn print_diagnostics(diagnostics: &Diagnostics, sources: &Sources) {
    let style = if std::io::stderr().is_terminal() { Style::Coloured } else { Style::Plain };
    for diagnostic in diagnostics.iter() {
        anstream::eprintln!("{}\n", render(diagnostic, sources, style));
    }
}
