//! Spellings: what keeps a text from being a name, and names as the model has them.

use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Label, Name};
use crate::read::Loaded;
use crate::syntax::Text;

/// A name as the model has it.
pub(super) fn name(text: &Text) -> Name {
    Name { text: text.value.clone(), span: text.span }
}

/// The name of what an overlay says.
pub(super) fn label(text: &Text) -> Label {
    Label::plain(name(text))
}

/// Reports the names of definitions that are none, wherever they stand.
pub(super) fn check_all(loaded: &Loaded, diagnostics: &mut Diagnostics) {
    let overlaid = loaded.overlays.iter().flat_map(|overlay| &overlay.enums);
    for element in loaded.files.iter().flat_map(|file| &file.enums).chain(overlaid) {
        check(&element.name, "an enum", diagnostics);
        element.entries.iter().for_each(|entry| check(&entry.name, "an entry", diagnostics));
    }
    for message in loaded.messages() {
        check(&message.name, "a message", diagnostics);
        message.fields.iter().for_each(|field| check(&field.name, "a field", diagnostics));
    }
}

/// Reports a name that is none.
pub(super) fn check(name: &Text, what: &str, diagnostics: &mut Diagnostics) {
    if let Some(fault) = Name::fault(&name.value) {
        let message = format!("`{}` cannot be the name of {what}", name.value);
        let problem = Diagnostic::new(Code::BadName, name.span, message).label(fault);
        diagnostics.push(problem.help(match name.value.contains('[') {
            true => "the length of an array belongs to its type, as in `uint8_t[4]`",
            false => "names are letters, digits and underscores, a letter first",
        }));
    }
}
