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
        let rendered = clap_mangen::Man::new(page).render(&mut text);
        rendered.map_err(|error| Failure::Usage(format!("the manual page: {error}")))?;
        report::print(&String::from_utf8_lossy(&text))?;
        Ok(ExitCode::SUCCESS)
    }
}

fn unknown(name: &str, all: &clap::Command) -> Failure {
    let near = nearest(name, all.get_subcommands().map(clap::Command::get_name));
    let near = near.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
    Failure::Usage(format!("there is no command `{name}`{near}"))
}
