//! `mavgen explain`.

use std::fmt::Write;
use std::process::ExitCode;

use clap::Args;
use mavgen::Failure;
use mavgen::diag::{Code, nearest};

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
            Some(text) => report::print(&page(find(text)?))?,
            None => report::print(&list())?,
        }
        Ok(ExitCode::SUCCESS)
    }
}

/// The code of that spelling; case and the letter do not matter.
fn find(text: &str) -> Result<Code, Failure> {
    let wanted = text.trim().trim_start_matches(['M', 'm']);
    let number = wanted.parse().ok();
    Code::ALL.iter().copied().find(|code| Some(code.number()) == number).ok_or_else(|| {
        let codes: Vec<String> = Code::ALL.iter().map(Code::to_string).collect();
        let help = match nearest(text, codes.iter().map(String::as_str)) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => "`mavgen explain` lists all".to_owned(),
        };
        Failure::Usage(format!("there is no diagnostic `{text}`; {help}"))
    })
}

fn list() -> String {
    let mut text = String::new();
    for code in Code::ALL {
        // Writing into a String cannot fail.
        let _ = writeln!(text, "{code}  {:<7}  {}", code.severity().to_string(), code.title());
    }
    text
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
    fn any_spelling_of_a_code() {
        for text in ["M304", "m304", "304", " M304 "] {
            assert_eq!(find(text).ok(), Some(Code::UnknownType), "{text}");
        }
        assert_eq!(find("M007").ok(), find("7").ok());
        for (text, help) in [("M3O4", "did you mean `M304`?"), ("M9999", "lists all"), ("", "lists all")] {
            let Err(Failure::Usage(message)) = find(text) else { panic!("{text}") };
            assert!(message.contains(help), "{message}");
        }
    }

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
