//! `mavgen check`.

use std::process::ExitCode;

use clap::Args;
use mavgen::Failure;
use mavgen::output::Differences;

use super::input::Output;

/// Compares a folder with what `generate` would write, and says no (exit status 1) if they differ.
#[derive(Args)]
#[command(after_help = "Example, in CI: mavgen check xml/acme.xml --out src/acme")]
pub(super) struct Check {
    #[command(flatten)]
    output: Output,
}

impl Check {
    pub(super) fn run(&self) -> Result<ExitCode, Failure> {
        let Differences { changed, missing, stale } = self.output.builder().check()?;
        let lists = [("differs", &changed), ("is missing", &missing), ("is no longer generated", &stale)];
        for (what, paths) in lists {
            for path in paths {
                anstream::eprintln!("{} {what}", path.display());
            }
        }
        if changed.is_empty() && missing.is_empty() && stale.is_empty() {
            return Ok(ExitCode::SUCCESS);
        }
        let (xml, out) = (self.output.input.xml.display(), self.output.out.display());
        let overlays = self.output.input.overlay.iter().map(|file| format!(" --overlay {}", file.display()));
        let overlays: String = overlays.collect();
        anstream::eprintln!("run `mavgen generate {xml}{overlays} --out {out}`");
        Ok(ExitCode::from(1))
    }
}
