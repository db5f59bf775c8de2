//! `<version>`, and which messages of its file see it.

use super::{field_type, number};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::syntax;

/// pymavlink's version of a file that states none.
const DEFAULT: u8 = 2;

/// The version of a file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Version {
    pub(super) number: u8,
    messages_before: usize,
}

impl Version {
    /// Reads the version of a file.
    pub(super) fn of(file: &syntax::File, diagnostics: &mut Diagnostics) -> Self {
        let Some(version) = &file.version else {
            return Self { number: DEFAULT, messages_before: 0 };
        };
        check_place(version, file, diagnostics);
        let number = number::count(&version.text.value).and_then(|number| u8::try_from(number).ok());
        if number.is_none() {
            let message = format!("version `{}` is not a number from 0 to 255", version.text.value);
            diagnostics.push(Diagnostic::new(Code::BadNumber, version.text.span, message));
        }
        Self { number: number.unwrap_or(DEFAULT), messages_before: version.messages_before }
    }

    /// The version that a message of the file sees, which is not the file's where `<version>` comes after it.
    pub(super) fn seen_by(self, message_index: usize) -> u8 {
        if message_index < self.messages_before { DEFAULT } else { self.number }
    }
}

/// A message that has the version as a field should come after it.
fn check_place(version: &syntax::Version, file: &syntax::File, diagnostics: &mut Diagnostics) {
    let mut before = file.messages.iter().take(version.messages_before);
    let is_version = |field: &&syntax::Field| field.ty.value == field_type::VERSION;
    let found = before.find_map(|message| Some((message, message.fields.iter().find(is_version)?)));
    let Some((message, field)) = found else { return };
    let name = &message.name.value;
    let text = format!("`<version>` comes too late for message `{name}`, whose version is {DEFAULT}");
    let problem = Diagnostic::new(Code::LateVersion, version.text.span, text);
    let problem = problem.related(field.ty.span, format!("stands for {DEFAULT} here"));
    diagnostics.push(problem.help("move `<version>` before `<messages>`"));
}
