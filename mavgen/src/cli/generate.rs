//! `mavgen generate`.

use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use mavgen::Failure;

use super::input::Output;
use super::report;

/// Writes Rust sources into a folder.
///
/// Files that are already right are left untouched, files of an earlier run that are no longer generated are removed,
/// everything else in the folder is left alone.
#[derive(Args)]
#[command(after_help = "Example: mavgen generate xml/acme.xml --out src/acme")]
pub(super) struct Generate {
    #[command(flatten)]
    output: Output,
}

impl Generate {
    pub(super) fn run(&self) -> Result<ExitCode, Failure> {
        let (start, builder) = (Instant::now(), self.output.builder());
        let resolved = builder.resolve()?;
        report::diagnostics(&resolved.diagnostics, &resolved.sources);
        let done = builder.write(&resolved)?;
        let (written, kept, removed) = (done.written, done.kept, done.removed);
        let (out, elapsed) = (self.output.out.display(), start.elapsed().as_millis());
        anstream::eprintln!("{out}: {written} files written, {kept} kept, {removed} removed, in {elapsed} ms");
        Ok(ExitCode::SUCCESS)
    }
}
