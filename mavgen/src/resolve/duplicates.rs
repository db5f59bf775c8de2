//! Messages that cannot be told apart: by id, by name.

use std::collections::HashMap;

use super::number;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::read::Loaded;
use crate::syntax::Message;

/// Reports every message whose id or name an earlier one has, even if the rest of it is broken.
///
/// Included files come first: they were there before what includes them, and its author is who can mend it.
pub(super) fn check(loaded: &Loaded, diagnostics: &mut Diagnostics) {
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
