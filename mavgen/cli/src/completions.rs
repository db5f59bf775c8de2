//! `mavgen completions`.

use std::process::ExitCode;

use clap::{Args, CommandFactory};
use clap_complete::{Shell, generate};
use mavgen::Failure;

use super::{Command, report};

/// Prints a script that teaches a shell the commands and options.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Completions {
    /// The shell.
    shell: Shell,
}

const AFTER_HELP: &str = "\
Examples:
  mavgen completions bash > ~/.local/share/bash-completion/completions/mavgen
  mavgen completions zsh > ~/.zfunc/_mavgen
  mavgen completions fish > ~/.config/fish/completions/mavgen.fish";

impl Completions {
    pub(super) fn run(&self) -> Result<ExitCode, Failure> {
        let mut script = Vec::new();
        generate(self.shell, &mut Command::command(), "mavgen", &mut script);
        report::print(&String::from_utf8_lossy(&script))?;
        Ok(ExitCode::SUCCESS)
    }
}
