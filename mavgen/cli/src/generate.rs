//! `mavgen generate`.

use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use mavgen::{Failure, is_identifier};

use super::input::{Output, resolve, resolve_topics};
use super::report::{Report, plural};

/// Writes Rust sources into a folder.
///
/// Files that are already right are left untouched, files of an earlier run that are no longer generated are removed,
/// everything else in the folder is left alone. If something is wrong, with the definitions or with the folder, it stays as
/// it was.
///
/// Several dialects become one tree with a module for each. What is the same in them is one type. Of uORB messages, several
/// definitions become one type for each message.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Generate {
    #[command(flatten)]
    output: Output,
}

const AFTER_HELP: &str = "\
Examples:
  mavgen generate xml/acme.xml --out src/acme
  mavgen generate xml/acme.xml --overlay xml/overlay/acme.xml --out src/acme
  mavgen generate xml/acme.xml xml/ardupilotmega.xml --out src/dialects
  mavgen generate xml/common.xml --messages 'HEARTBEAT,PARAM_*' --out src/small
  mavgen generate px4_msgs/msg --messages VehicleStatus --out src/px4
  mavgen generate msg/main --older v1_14=msg/v1_14 --out src/px4

In the crate, `mod acme;` takes the sources in; they need the crate mavlink-wire and nothing else.

Exit status: 0 the folder holds the sources, 2 something is wrong and nothing was written.";

impl Generate {
    pub(super) fn run(&self, report: &Report) -> Result<ExitCode, Failure> {
        let (start, builder) = (Instant::now(), self.output.builder()?);
        let done = match builder.is_uorb() {
            true => builder.write_topics(&resolve_topics(&builder, report)?)?,
            false => builder.write(&resolve(&builder, report)?)?,
        };
        let (written, kept, removed) = (plural(done.written, "file"), done.kept, done.removed);
        let (out, elapsed) = (self.output.out.display(), start.elapsed().as_millis());
        report.note(&format!("{out}: {written} written, {kept} kept, {removed} removed, in {elapsed} ms"));
        if done.written > 0 && kept == 0 && removed == 0 {
            report.note(&next(&self.output.out));
        }
        Ok(ExitCode::SUCCESS)
    }
}

/// What one does next, after the first time.
fn next(out: &Path) -> String {
    let messages = out.join("messages.rs");
    let read = if messages.exists() { messages } else { out.join("mod.rs") };
    // Only `.` and `..` have no name of their own.
    let folder =
        out.file_name().map(ToOwned::to_owned).or_else(|| Some(out.canonicalize().ok()?.file_name()?.to_owned()));
    let folder = folder.unwrap_or_default().display().to_string();
    let module = match is_identifier(&folder) && !folder.starts_with("r#") {
        true => format!("mod {folder};"),
        false => format!("#[path = \"{folder}/mod.rs\"] mod dialect;"),
    };
    let read = read.display();
    format!("next: read {read}, and write `#[rustfmt::skip] {module}` in a crate that depends on mavlink-wire")
}
