//! `mavgen lint`.

use std::process::ExitCode;

use clap::Args;
use mavgen::diag::{Code, Diagnostics, Severity};
use mavgen::source::Sources;
use mavgen::{Builder, Failure, Problems, Resolved, Topics};

use super::input::Input;
use super::report::{Report, plural};

/// Says all that there is to say about a dialect or uORB messages, and no (exit status 1) if something is wrong with it.
///
/// Warnings and notes about included files and vendored copies are shown as well, which other commands do not. A warning is no
/// reason to say no, unless warnings are denied.
#[derive(Args)]
#[command(after_help = AFTER_HELP, mut_arg("messages", |messages| messages.help(MESSAGES)))]
pub(super) struct Lint {
    #[command(flatten)]
    input: Input,
}

const AFTER_HELP: &str = "\
Examples:
  mavgen lint xml/acme.xml
  mavgen lint xml/acme.xml --overlay xml/overlay/acme.xml --deny-warnings
  mavgen lint xml/acme.xml --allow M313,M404
  mavgen lint xml/acme.xml --message-format json 2>&1 | jq .message
  mavgen lint px4_msgs/msg
  mavgen lint msg/main --overlay msg/esc.overlay.xml --older v1_14=msg/v1_14

Exit status: 0 fine, 1 errors (or denied warnings), 2 the file or an overlay cannot be read, or the usage is wrong.";

/// What `--messages` means here: the arguments of `generate` are those of `lint`, and a slip in one is found in the other.
const MESSAGES: &str = "The messages that the sources are generated for. A file is right or wrong as a whole: all of it is judged, \
but of several dialects only these messages are held against each other. A name that means no message is an error";

/// Problems that leave nothing to judge.
const UNREADABLE: [Code; 3] = [Code::Unreadable, Code::NotUtf8, Code::TooLarge];

impl Lint {
    pub(super) fn run(&self, report: &Report) -> Result<ExitCode, Failure> {
        // Denied warnings are found here, beside all the others.
        let builder = self.input.builder()?.deny_warnings(false).lint(true);
        let found = match builder.is_uorb() {
            true => builder.topics().map(|Topics { diagnostics, sources, .. }| (diagnostics, sources)),
            false => builder.resolve().map(|Resolved { diagnostics, sources, .. }| (diagnostics, sources)),
        };
        match found {
            Ok((diagnostics, sources)) => Ok(self.judge(&builder, &diagnostics, &sources, report)),
            Err(Failure::Definitions(problems)) => {
                let Problems { diagnostics, sources, .. } = &*problems;
                if diagnostics.iter().any(|diagnostic| UNREADABLE.contains(&diagnostic.code)) {
                    return Err(Failure::Definitions(problems));
                }
                Ok(self.judge(&builder, diagnostics, sources, report))
            }
            Err(other) => Err(other),
        }
    }

    fn judge(&self, builder: &Builder, found: &Diagnostics, sources: &Sources, report: &Report) -> ExitCode {
        report.diagnostics(found, sources);
        let count = |severity| found.iter().filter(|diagnostic| diagnostic.severity() == severity).count();
        let (errors, warnings, notes) = (count(Severity::Error), count(Severity::Warning), count(Severity::Note));
        let xml: Vec<String> = self.input.xml.iter().map(|xml| xml.display().to_string()).collect();
        let xml = xml.join(", ");
        report.note(&format!(
            "{xml}: {}, {}, {}",
            plural(errors, "error"),
            plural(warnings, "warning"),
            plural(notes, "note")
        ));
        // What no other command tells, none other would deny.
        let mut all = found.iter().filter(|one| one.severity() == Severity::Warning && !one.code.is_for_lint());
        let denied = self.input.reading.definitions.deny_warnings && all.any(|one| builder.concerns(one, sources));
        if denied {
            report.denied();
        }
        if errors > 0 || denied { ExitCode::from(1) } else { ExitCode::SUCCESS }
    }
}
