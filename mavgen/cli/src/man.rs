//! `mavgen man`.

use std::process::ExitCode;

use clap::{Args, CommandFactory};
use mavgen::Failure;
use mavgen::diag::nearest;

use super::{Command, report};

/// Prints a manual page.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Man {
    /// The command that it is about; without one, all of them.
    command: Option<String>,
}

const AFTER_HELP: &str = "\
Examples:
  mavgen man | man -l -
  mavgen man generate > ~/.local/share/man/man1/mavgen-generate.1";

impl Man {
    pub(super) fn run(&self) -> Result<ExitCode, Failure> {
        let mut all = Command::command();
        all.build();
        let page = match &self.command {
            None => all,
            Some(name) => all.find_subcommand(name).cloned().ok_or_else(|| unknown(name, &all))?,
        };
        let mut text = Vec::new();
        let page = clap_mangen::Man::new(page).source(concat!("mavgen ", env!("CARGO_PKG_VERSION")));
        let rendered = page.render(&mut text);
        rendered.map_err(|error| Failure::Usage(format!("the manual page: {error}")))?;
        report::print(&with_examples(&String::from_utf8_lossy(&text)))?;
        Ok(ExitCode::SUCCESS)
    }
}

/// The page with its examples as they are written: clap_mangen has their lines filled and justified like prose.
fn with_examples(page: &str) -> String {
    let Some((before, after)) = page.split_once(".SH EXTRA\n") else { return page.to_owned() };
    let (examples, after) = after.split_at(after.find(".SH ").unwrap_or(after.len()));
    format!("{before}.SH EXAMPLES\n.nf\n{examples}.fi\n{after}")
}

fn unknown(name: &str, all: &clap::Command) -> Failure {
    let near = nearest(name, all.get_subcommands().map(clap::Command::get_name));
    let near = near.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
    Failure::Usage(format!("there is no command `{name}`{near}"))
}
