//! `mavgen check`.

mod unified;

use std::env;
use std::ffi::OsString;
use std::process::ExitCode;

use clap::Args;
use mavgen::output::{self, Differences};
use mavgen::{Failure, GeneratedFile};

use super::input::{Output, resolve, resolve_topics};
use super::report::{Report, plural, print_coloured};
use unified::Unified;

/// Compares a folder with what `generate` would write, and says no (exit status 1) if they differ.
///
/// The differences go to standard output: unified diffs from what is there to what would be written, and the files that are
/// missing or no longer generated. A long list is cut, and says so. Line ends count, but what differs in them alone is one line.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Check {
    #[command(flatten)]
    output: Output,
}

const AFTER_HELP: &str = "\
Examples, in CI, with the options that the sources were generated with:
  mavgen check xml/acme.xml --out src/acme
  mavgen check xml/acme.xml --out src/acme --deny-warnings
  mavgen check xml/acme.xml --overlay xml/overlay/acme.xml --out src/acme
  mavgen check px4_msgs/msg --messages VehicleStatus --out src/px4

Exit status: 0 current, 1 not current, 2 the definitions are wrong or a file cannot be read.";

impl Check {
    pub(super) fn run(&self, report: &Report) -> Result<ExitCode, Failure> {
        let builder = self.output.builder()?;
        let files = match builder.is_uorb() {
            true => builder.emit_topics(&resolve_topics(&builder, report)?)?,
            false => builder.emit(&resolve(&builder, report)?)?,
        };
        let differences = output::check(&self.output.out, &files).map_err(Failure::Output)?;
        if differences.is_empty() {
            return Ok(ExitCode::SUCCESS);
        }
        print_coloured(&self.text(&differences, &files))?;
        let Differences { changed, line_ends, missing, stale } = &differences;
        let (out, changed, missing, stale) = (self.output.out.display(), changed.len(), missing.len(), stale.len());
        let line_ends = match line_ends.len() {
            0 => String::new(),
            count => format!(", {count} with other line ends"),
        };
        report.note(&format!("{out}: {changed} changed, {missing} missing, {stale} stale{line_ends}"));
        report.note(&format!("run: {}", generate_instead(env::args_os().skip(1))));
        Ok(ExitCode::from(1))
    }

    fn text(&self, differences: &Differences, files: &[GeneratedFile]) -> String {
        let mut unified = Unified::default();
        if !differences.line_ends.is_empty() {
            let (out, files) = (self.output.out.display(), plural(differences.line_ends.len(), "file"));
            let attributes = self.output.out.join(".gitattributes");
            unified.line(format_args!(
                "{out}: {files} with the line ends of Windows (CRLF), and current otherwise: `* text eol=lf` in {} keeps git from it",
                attributes.display()
            ));
        }
        for file in files {
            let path = self.output.out.join(&file.path);
            if differences.changed.contains(&path) {
                unified.file(&path, &file.text);
            }
        }
        for path in &differences.missing {
            unified.line(format_args!("{} is missing", path.display()));
        }
        for path in &differences.stale {
            unified.line(format_args!("{} is no longer generated", path.display()));
        }
        unified.finish()
    }
}

/// The command that was given, all options included, with `generate` in place of `check`.
fn generate_instead(arguments: impl Iterator<Item = OsString>) -> String {
    let mut arguments: Vec<String> = arguments.map(|argument| argument.to_string_lossy().into_owned()).collect();
    if let Some(check) = arguments.iter_mut().find(|argument| *argument == "check") {
        "generate".clone_into(check);
    }
    let quoted: Vec<String> = arguments.iter().map(|argument| quoted(argument)).collect();
    format!("mavgen {}", quoted.join(" "))
}

/// An argument as a POSIX shell takes it.
fn quoted(argument: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./,:=@%+".contains(c);
    if !argument.is_empty() && argument.chars().all(plain) {
        argument.to_owned()
    } else {
        format!("'{}'", argument.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_that_mends_it_has_all_options() {
        let instead = |arguments: &[&str]| generate_instead(arguments.iter().map(OsString::from));
        assert_eq!(
            instead(&[
                "--color",
                "never",
                "check",
                "a b.xml",
                "--overlay=x.xml",
                "--out",
                "it's",
                "--messages",
                "A,B_*"
            ]),
            r"mavgen --color never generate 'a b.xml' --overlay=x.xml --out 'it'\''s' --messages 'A,B_*'"
        );
        assert_eq!(instead(&["check", "check", "--out", ""]), "mavgen generate check --out ''");
    }
}
