//! The `mavgen` command: parses its arguments, calls one function of the library, prints. One file per command.
//!
//! Exit status: 0 fine, 1 the answer is no (`check`, `diff`, `lint`), 2 the input or the usage is wrong.

mod check;
mod completions;
mod decode;
mod diff;
mod dump;
mod explain;
mod generate;
mod input;
mod lint;
mod man;
mod report;
mod topics;
mod usage;
mod vendor;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use check::Check;
use completions::Completions;
use decode::Decode;
use diff::Diff;
use dump::Dump;
use explain::Explain;
use generate::Generate;
use lint::Lint;
use man::Man;
use report::Report;
use vendor::Vendor;

/// The MAVLink dialect compiler: typed Rust from dialect XML.
///
/// It reads a dialect and all that it includes, understands it exactly as pymavlink does, and says what is wrong with it, with
/// file, line and column.
#[derive(Parser)]
#[command(name = "mavgen", version, after_help = AFTER_HELP, term_width = WIDTH)]
struct Command {
    #[command(subcommand)]
    action: Action,
    #[command(flatten)]
    color: colorchoice_clap::Color,
    #[command(flatten)]
    report: Report,
}

/// Columns of help on every terminal. Examples are written for them: where clap breaks a line, the second half of a command would
/// be a command of its own.
const WIDTH: usize = 80;

const AFTER_HELP: &str = "\
Examples:
  mavgen lint xml/acme.xml                     what is wrong with it?
  mavgen generate xml/acme.xml --out src/acme  write Rust
  mavgen check xml/acme.xml --out src/acme     in CI: is what is there current?
  mavgen dump xml/acme.xml                     ids, offsets, crc_extra, values
  mavgen decode xml/acme.xml flight.tlog       what did it say?
  mavgen diff old/acme.xml xml/acme.xml        what breaks, and what in Rust?
  mavgen vendor up/acme.xml --out xml          copy it and its includes
  mavgen explain M304                          what does a diagnostic mean?
  mavgen lint px4_msgs/msg --messages 'Esc*'   PX4's .msg files, as well

Exit status: 0 fine, 1 the answer is no (check, diff, lint), 2 the input or the usage is wrong.";

#[derive(Subcommand)]
enum Action {
    Generate(Generate),
    Check(Check),
    Lint(Lint),
    Dump(Dump),
    Decode(Decode),
    Diff(Diff),
    Explain(Explain),
    Vendor(Vendor),
    Completions(Completions),
    Man(Man),
}

fn main() -> ExitCode {
    let Command { action, color, report } = match usage::parse() {
        Ok(command) => command,
        Err(status) => return status,
    };
    color.write_global();
    let outcome = match action {
        Action::Generate(generate) => generate.run(&report),
        Action::Check(check) => check.run(&report),
        Action::Lint(lint) => lint.run(&report),
        Action::Dump(dump) => dump.run(&report),
        Action::Decode(decode) => decode.run(&report),
        Action::Diff(diff) => diff.run(&report),
        Action::Explain(explain) => explain.run(),
        Action::Vendor(vendor) => vendor.run(&report),
        Action::Completions(completions) => completions.run(),
        Action::Man(man) => man.run(),
    };
    outcome.unwrap_or_else(|failure| {
        report.failure(&failure);
        ExitCode::from(2)
    })
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_arguments_are_consistent() {
        Command::command().debug_assert();
    }

    #[test]
    fn every_command_teaches_by_example() {
        for command in Command::command().get_subcommands() {
            let help = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            let example = format!("mavgen {} ", command.get_name());
            assert!(help.starts_with("Example") && format!("{help} ").contains(&example), "{}", command.get_name());
            assert!(command.get_about().is_some(), "{}", command.get_name());
        }
    }

    /// What is copied from help is what was written: no example is broken into two lines.
    #[test]
    fn examples_are_not_wrapped() {
        let mut all = Command::command();
        all.build();
        let subcommands: Vec<clap::Command> = all.get_subcommands().cloned().collect();
        for mut command in std::iter::once(all).chain(subcommands) {
            let written = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            let shown = command.render_long_help().to_string();
            for line in written.lines().filter(|line| line.starts_with("  ")) {
                assert!(shown.lines().any(|shown| shown == line), "{}: {line}", command.get_name());
            }
        }
    }
}
