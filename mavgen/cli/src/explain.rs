//! `mavgen explain`.

use std::process::ExitCode;

use clap::Args;
use mavgen::Failure;
use mavgen::diag::{Code, UnknownCode};

use super::report;

/// Explains a diagnostic: what it means, a wrong example and a right one, and why it matters.
///
/// Without a code, lists them all.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Explain {
    /// The code, as it stands in brackets in a diagnostic.
    code: Option<String>,
}

const AFTER_HELP: &str = "\
Examples:
  mavgen explain M304
  mavgen explain | grep warning";

impl Explain {
    pub(super) fn run(&self) -> Result<ExitCode, Failure> {
        match &self.code {
            Some(text) => {
                let code = text.parse().map_err(|error: UnknownCode| Failure::Usage(error.to_string()))?;
                report::print(&page(code))?;
            }
            None => report::print(&list())?,
        }
        Ok(ExitCode::SUCCESS)
    }
}

fn list() -> String {
    Code::ALL.iter().map(|code| format!("{code}  {:<7}  {}\n", code.severity().to_string(), code.title())).collect()
}

/// The page of a code for a terminal: code is indented where markdown has fences.
fn page(code: Code) -> String {
    let mut text = format!("{code} ({}): {}\n\n{}", code.severity(), code.title(), indented(code.explanation()));
    if let Some(definition) = code.example_definition() {
        text += "\nThe overlays above are for this definition:\n\n";
        text += &indented(&format!("```\n{definition}```\n"));
    }
    text
}

/// Markdown with its fenced blocks indented.
fn indented(markdown: &str) -> String {
    let (mut text, mut code) = (String::new(), false);
    for line in markdown.lines() {
        if line.starts_with("```") {
            code = !code;
        } else if code {
            text = text + "    " + line + "\n";
        } else {
            text = text + line + "\n";
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn code_is_indented() {
        assert_eq!(
            indented("Wrong:\n\n```xml\n<a>\n  <b/>\n```\n\nRight.\n"),
            "Wrong:\n\n    <a>\n      <b/>\n\nRight.\n"
        );
    }

    #[test]
    fn overlays_come_with_their_definition() {
        let message = "\n        <message id=\"1\" name=\"PUMP_STATUS\">\n";
        assert!(page(Code::BitsPlace).contains(message));
        assert!(page(Code::BitsPlace).starts_with("M740 (error): Bits have"));
        assert!(!page(Code::PayloadTooLong).contains(message));
    }
}
