//! Names: as the model has them, those that are none, those that stand twice, and those that other generators do not take.

use std::collections::HashMap;

use super::number;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Label, Name};
use crate::read::Loaded;
use crate::syntax::{Message, Text};

/// The words that pymavlink's validation means to refuse as the name of anything, in any letter case.
///
/// Five of them (`abstract`, `enum`, `export`, `return` and `short`) pass it by a slip in its pattern.
const REFUSED: [&str; 4] = [
    "abstract await boolean break byte case catch char class const continue debugger default delete do double",
    "else enum export extends final finally float for function goto if implements import in instanceof int interface",
    "let long native new package private protected public return short static super switch synchronized",
    "this throw transient try typeof var void volatile while with yield",
];

/// Keywords of C and Python beyond those, as they are spelled: fields and constants have their names as written.
const KEYWORDS: [&str; 2] = [
    "auto extern inline register restrict signed sizeof struct typedef union unsigned",
    "False None True and as assert async def del elif except from global is lambda nonlocal not or pass raise",
];

/// Attributes of pymavlink's message classes, which a field of the same name hides.
const HIDDEN: [&str; 1] = ["self crc_extra unpacker"];

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

/// Reports every message whose id or name an earlier one has, even if the rest of it is broken.
///
/// Included files come first: they were there before what includes them, and its author is who can mend it.
pub(super) fn check_duplicates(loaded: &Loaded, diagnostics: &mut Diagnostics) {
    let mut ids: HashMap<u64, &Message> = HashMap::new();
    let mut names: HashMap<&str, &Message> = HashMap::new();
    for message in loaded.files.iter().rev().flat_map(|file| &file.messages) {
        let same_id = number::count(&message.id.value).and_then(|id| ids.insert(id, message));
        let same_name = names.insert(&message.name.value, message);
        match (same_id, same_name) {
            (Some(first), _) => diagnostics.push(duplicate_id(message, first)),
            (None, Some(first)) => diagnostics.push(duplicate_name(message, first)),
            (None, None) => {}
        }
    }
}

fn duplicate_id(message: &Message, first: &Message) -> Diagnostic {
    let (name, id) = (&message.name.value, message.id.value.trim());
    let text = if *name == first.name.value {
        format!("message `{name}` stands twice, with the id {id}")
    } else {
        format!("message `{name}` has the id {id}, which `{}` has already", first.name.value)
    };
    let problem = Diagnostic::new(Code::DuplicateMessageId, message.id.span, text);
    problem.related(first.id.span, format!("{id} is first used here"))
}

fn duplicate_name(message: &Message, first: &Message) -> Diagnostic {
    let text = format!(
        "message `{}` stands twice, with the ids {} and {}",
        message.name.value, first.id.value, message.id.value
    );
    let problem = Diagnostic::new(Code::DuplicateMessageName, message.name.span, text);
    problem.label("second message of this name").related(first.name.span, "first message of this name")
}

/// Reports names that other generators cannot take, although Rust can.
pub(super) fn check_reserved(loaded: &Loaded, diagnostics: &mut Diagnostics) {
    for element in loaded.files.iter().flat_map(|file| &file.enums) {
        report_reserved(&element.name, reason(&element.name.value), diagnostics);
        let end = format!("{}_ENUM_END", element.name.value);
        for entry in &element.entries {
            let name = &entry.name.value;
            let is_end = (*name == end).then_some("pymavlink adds an entry of this name to the enum");
            report_reserved(&entry.name, is_end.or_else(|| member_reason(name)), diagnostics);
        }
    }
    for message in loaded.messages() {
        report_reserved(&message.name, reason(&message.name.value), diagnostics);
        for field in &message.fields {
            let hides = has(&HIDDEN, &field.name.value).then_some("hides an attribute of pymavlink's message class");
            report_reserved(&field.name, hides.or_else(|| member_reason(&field.name.value)), diagnostics);
        }
    }
}

/// Why a name of anything is reserved.
fn reason(name: &str) -> Option<&'static str> {
    has(&REFUSED, &name.to_ascii_lowercase()).then_some("a word that pymavlink's validation forbids")
}

/// Why a name of a field or an entry is reserved.
fn member_reason(name: &str) -> Option<&'static str> {
    reason(name).or_else(|| has(&KEYWORDS, name).then_some("a keyword of C or Python"))
}

fn has(words: &[&str], name: &str) -> bool {
    words.iter().flat_map(|words| words.split(' ')).any(|word| word == name)
}

fn report_reserved(name: &Text, reason: Option<&str>, diagnostics: &mut Diagnostics) {
    let Some(reason) = reason else { return };
    let message = format!("other generators do not take the name `{}`", name.value);
    let problem = Diagnostic::new(Code::ReservedName, name.span, message).label(reason);
    diagnostics.push(problem.help("Rust takes it; for C and Python, give it another name"));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reserved() {
        for name in ["break", "CLASS", "Return", "enum", "abstract", "short", "yield"] {
            assert!(reason(name).is_some(), "{name}");
        }
        for name in ["type", "BREAKER", "from", "id", "name", "DEBUG"] {
            assert!(reason(name).is_none(), "{name}");
        }
        for name in ["from", "None", "struct", "in", "auto"] {
            assert!(member_reason(name).is_some(), "{name}");
        }
        for name in ["type", "NONE", "AUTO", "data"] {
            assert!(member_reason(name).is_none(), "{name}");
        }
    }
}
