//! The program for people who have an AutoQuad: `autoquad --help` says what it does.

mod bridge;
mod csv;
mod failure;
mod input;
mod interrupt;
mod monitor;
mod output;
mod plot;
mod progress;
mod px4_log;
mod quantity;
mod record;
mod recording;
mod salvage;
mod simulate;
mod station;
mod telemetry;
mod time;
mod ulog;

use std::io::Error;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use failure::Failure;

/// Watches, records, plots and bridges the motor controllers of an AutoQuad.
#[derive(Parser)]
#[command(version, after_help = AFTER_HELP, max_term_width = 120)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const AFTER_HELP: &str = "\
Connect an AutoQuad:
  autoquad monitor serial:/dev/ttyUSB0:57600
  autoquad bridge serial:/dev/ttyUSB0:57600 udpout:127.0.0.1:14550

Or try it without one:
  autoquad simulate --tlog flight.tlog
  autoquad monitor flight.tlog
  autoquad plot flight.tlog --out flight.svg

`autoquad COMMAND --help` has more examples.

Exit status: 0 fine, 1 something failed, 2 the arguments are wrong.";

#[derive(Subcommand)]
enum Command {
    Simulate(simulate::Simulate),
    Monitor(monitor::Monitor),
    Bridge(bridge::Bridge),
    Record(record::Record),
    Csv(csv::Csv),
    Plot(plot::Plot),
    Ulog(ulog::Ulog),
    Px4Log(px4_log::Px4Log),
    Salvage(salvage::Salvage),
}

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return shown(&error),
    };
    let result = match cli.command {
        Command::Simulate(simulate) => simulate.run(),
        Command::Monitor(monitor) => monitor.run(),
        Command::Bridge(bridge) => bridge.run(),
        Command::Record(record) => record.run(),
        Command::Csv(csv) => csv.run(),
        Command::Plot(plot) => plot.run(),
        Command::Ulog(ulog) => ulog.run(),
        Command::Px4Log(log) => log.run(),
        Command::Salvage(salvage) => salvage.run(),
    };
    ended(result, ExitCode::SUCCESS)
}

/// Help, the version, or what is wrong with the arguments.
fn shown(text: &clap::Error) -> ExitCode {
    let printed = text.print().map_err(|error| Failure::written(Error::new(error.kind(), format!("help: {error}"))));
    ended(printed, u8::try_from(text.exit_code()).map_or(ExitCode::FAILURE, ExitCode::from))
}

/// The exit status: this one, unless something failed.
fn ended(result: Result<(), Failure>, status: ExitCode) -> ExitCode {
    match result {
        Ok(()) | Err(Failure::ReaderGone) => status,
        Err(Failure::Sentence(sentence)) => {
            eprintln!("autoquad: {sentence}");
            ExitCode::FAILURE
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_commands_are_consistent_and_have_examples() {
        Cli::command().debug_assert();
        for command in Cli::command().get_subcommands() {
            let help = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            assert!(help.contains(&format!("autoquad {}", command.get_name())), "{}", command.get_name());
        }
    }

    /// Every example of the help is a command that the program takes.
    #[test]
    fn the_examples_of_the_help_are_taken() {
        let commands: Vec<clap::Command> =
            std::iter::once(Cli::command()).chain(Cli::command().get_subcommands().cloned()).collect();
        let helps = commands.iter().filter_map(|command| Some(command.get_after_help()?.to_string()));
        let lines: Vec<String> =
            helps.flat_map(|help| help.lines().map(str::trim).map(str::to_owned).collect::<Vec<_>>()).collect();
        for line in lines.iter().filter(|line| line.starts_with("autoquad ")) {
            let words = line.split(" (").next().unwrap_or_default().split(['>', '|']).next().unwrap_or_default();
            if let Err(error) = Cli::try_parse_from(words.split_whitespace()) {
                panic!("{line}: {error}");
            }
        }
    }
}
