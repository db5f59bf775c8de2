//! Arguments that are not understood, and those that ask for help.

use std::env;
use std::ffi::OsString;
use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use clap::{Error, Parser};

use super::Command;
use super::report::{Report, json};

/// The command that the arguments name; if they name none, the exit status.
pub(super) fn parse() -> Result<Command, ExitCode> {
    Command::try_parse().map_err(|error| {
        if !error.use_stderr() {
            return shown(&error);
        }
        if asks_for_json(env::args_os().skip(1)) {
            // As with all that is said on standard error: if that is closed or full, the exit status still says it.
            let _ = writeln!(io::stderr(), "{}", as_json(&error));
        } else {
            let _ = error.print();
        }
        ExitCode::from(2)
    })
}

/// Help or the version, on standard output.
fn shown(text: &Error) -> ExitCode {
    match text.print() {
        // A reader that has seen enough, like `head`, is no error.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Report::default().failure(&mavgen::Failure::Usage(format!("standard output: {error}")));
            ExitCode::from(2)
        }
        _ => ExitCode::SUCCESS,
    }
}

/// Whether `--message-format json` is among the arguments, of which something is not understood.
fn asks_for_json(arguments: impl Iterator<Item = OsString>) -> bool {
    let options: Vec<OsString> = arguments.take_while(|argument| argument != "--").collect();
    options.iter().any(|option| option == "--message-format=json")
        || options
            .windows(2)
            .any(|pair| matches!(pair, [option, value] if option == "--message-format" && value == "json"))
}

/// The mistake as one object: its first paragraph is what is wrong, a tip or else the usage is what to do.
fn as_json(error: &Error) -> String {
    let text = error.render().to_string();
    let mut paragraphs =
        text.split("\n\n").map(|paragraph| paragraph.lines().map(str::trim).collect::<Vec<_>>().join(" "));
    let message = paragraphs.next().unwrap_or_default();
    let message = message.strip_prefix("error: ").unwrap_or(&message);
    let (tips, others): (Vec<String>, Vec<String>) = paragraphs.partition(|paragraph| paragraph.starts_with("tip: "));
    let usage = others.iter().find(|paragraph| paragraph.starts_with("Usage: "));
    let help = tips.first().and_then(|tip| tip.strip_prefix("tip: ")).or(usage.map(String::as_str));
    json::usage(message, help.unwrap_or("`mavgen --help` says more"), text.trim_end())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_format_is_found_wherever_it_stands() {
        let asks = |arguments: &[&str]| asks_for_json(arguments.iter().map(OsString::from));
        for arguments in [
            &["--message-format", "json", "lint", "--wrong"][..],
            &["lint", "--wrong", "--message-format", "json"],
            &["--message-format=json"],
            &["lint", "--wrong", "--message-format=json", "--", "x"],
        ] {
            assert!(asks(arguments), "{arguments:?}");
        }
        for arguments in [
            &[][..],
            &["json"],
            &["--message-format", "human", "json"],
            &["--message-format"],
            &["lint", "--", "--message-format", "json"],
            &["--message-format=jsonl"],
        ] {
            assert!(!asks(arguments), "{arguments:?}");
        }
    }
}
