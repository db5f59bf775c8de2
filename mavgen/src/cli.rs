//! The command line: parses, calls one library function, prints. One file per command in `cli/`.
//!
//! Exit status: 0 fine, 1 the answer is no (`check`), 2 the input or the usage is wrong.

mod check;
mod dump;
mod generate;
mod input;
mod report;
mod vendor;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use check::Check;
use dump::Dump;
use generate::Generate;
use vendor::Vendor;

/// The MAVLink dialect compiler: typed Rust from dialect XML.
#[derive(Parser)]
#[command(version, after_help = "Exit status: 0 fine, 1 `check` found differences, 2 the input or the usage is wrong.")]
struct Command {
    #[command(subcommand)]
    action: Action,
}

#[derive(Subcommand)]
enum Action {
    Generate(Generate),
    Check(Check),
    Dump(Dump),
    Vendor(Vendor),
}

/// Runs the command that the arguments name.
pub(crate) fn run() -> ExitCode {
    let outcome = match Command::parse().action {
        Action::Generate(generate) => generate.run(),
        Action::Check(check) => check.run(),
        Action::Dump(dump) => dump.run(),
        Action::Vendor(vendor) => vendor.run(),
    };
    outcome.unwrap_or_else(|failure| {
        report::failure(&failure);
        ExitCode::from(2)
    })
}
