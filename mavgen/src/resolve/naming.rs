//! Names: which Rust name everything gets, and that no two become one.
//!
//! The spelling is [`crate::names`]'s; here is what depends on other names.

use std::collections::{HashMap, HashSet, hash_map};

use super::enums::Entry;
use super::merge::{Enums, Merged};
use super::width::Width;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{FileIndex, Label, Name};
use crate::names;
use crate::read::Loaded;
use crate::syntax::{Message, Text};

/// The name of a message.
pub(super) fn message(text: &Text) -> Name {
    Name { text: text.value.clone(), rust: names::type_name(&text.value), span: text.span }
}

/// The name of a field.
pub(super) fn field(text: &Text) -> Name {
    Name { text: text.value.clone(), rust: names::field_name(&text.value), span: text.span }
}

/// The name of what an overlay says.
pub(super) fn label(text: &Text) -> Label {
    Label::plain(field(text))
}

/// The names of an enum's constants, in the order of its entries.
pub(super) fn constants(merged: &Merged<'_>, owner: FileIndex) -> Vec<String> {
    let named = |owner: Option<FileIndex>| -> Vec<&str> {
        let entries = merged.entries.iter().filter(|entry| owner.is_none_or(|owner| entry.file == owner));
        entries.map(|entry| entry.syntax.name.value.as_str()).collect()
    };
    names::constant_names(&merged.name.value, &named(Some(owner)), &named(None))
}

/// The names of all types of a dialect.
pub(super) struct Types {
    /// Of the enums, in their order. One that a message has already takes the suffix `Enum`.
    pub(super) enums: Vec<String>,
    /// Of the dialect itself. One that a message or an enum has already takes the suffix `Dialect`.
    pub(super) dialect: String,
}

/// Names the types and reports those that share a name.
pub(super) fn types<'a>(loaded: &'a Loaded, enums: &Enums<'a>, diagnostics: &mut Diagnostics) -> Types {
    let mut claims: Vec<Claim<'_>> = Vec::new();
    for (index, file) in loaded.files.iter().enumerate() {
        let (age, what) = (loaded.age(FileIndex(index)), "messages");
        let claim = |name: &'a Text| Claim { age, rust: names::type_name(&name.value), name, what };
        claims.extend(file.messages.iter().map(|message| claim(&message.name)));
    }
    let messages: HashSet<String> = claims.iter().map(|claim| claim.rust.clone()).collect();
    let suffixed = |rust: String, taken: bool, suffix: &str| {
        // `Option_` is spelled so only to differ from `Option`, which `OptionEnum` does anyway.
        if taken { rust.trim_end_matches('_').to_owned() + suffix } else { rust }
    };
    let mut types = Types { enums: Vec::with_capacity(enums.list.len()), dialect: String::new() };
    for merged in &enums.list {
        let rust = names::type_name(&merged.name.value);
        let taken = messages.contains(&rust);
        let rust = suffixed(rust, taken, "Enum");
        let (file, name) = merged.oldest(loaded);
        claims.push(Claim { age: loaded.age(file), rust: rust.clone(), name, what: "types" });
        types.enums.push(rust);
    }
    let mut scope = Scope::default();
    scope.claim_all(claims, diagnostics);
    for name in view_types(loaded) {
        scope.claim_new(names::type_name(&name.value), name, diagnostics);
    }
    let rust = names::dialect_type_name(&loaded.name);
    let taken = scope.taken.contains_key(&rust);
    types.dialect = suffixed(rust, taken, "Dialect");
    check_dialect(&loaded.name, &types.dialect, &scope, diagnostics);
    types
}

/// The names that overlays give to types: those of views and, where there are slots, of their items.
fn view_types(loaded: &Loaded) -> impl Iterator<Item = &Text> {
    let messages = loaded.overlays.iter().flat_map(|overlay| &overlay.messages);
    messages.flat_map(|message| &message.views).flat_map(|view| {
        let item = view.item.as_ref().filter(|_| view.items.is_some());
        std::iter::once(&view.name).chain(item)
    })
}

/// The dialect's type is named after its file, which can be called anything.
fn check_dialect(name: &str, rust: &str, scope: &Scope<'_>, diagnostics: &mut Diagnostics) {
    if let Some((other, _)) = scope.taken.get(rust) {
        let message = format!("the dialect `{name}` and `{}` are both `{rust}` in Rust", other.value);
        diagnostics.push(
            Diagnostic::new(Code::NameCollision, other.span, message)
                .help("rename the file, or give the dialect another name"),
        );
    } else if !is_name(rust) {
        let message = format!("`{name}` makes no Rust name for a dialect");
        diagnostics.push(
            Diagnostic::without_place(Code::BadName, message)
                .help("name the file, or the dialect, with letters and digits"),
        );
    }
}

/// Reports names that are none, wherever they stand, and fields and constants that share a name.
pub(super) fn check<'a>(loaded: &'a Loaded, enums: &Enums<'a>, widths: &[Width], diagnostics: &mut Diagnostics) {
    let overlaid = loaded.overlays.iter().flat_map(|overlay| &overlay.enums);
    for element in loaded.files.iter().flat_map(|file| &file.enums).chain(overlaid) {
        check_spelling(&element.name, "an enum", diagnostics);
        element.entries.iter().for_each(|entry| check_spelling(&entry.name, "an entry", diagnostics));
    }
    for message in all_messages(loaded) {
        check_spelling(&message.name, "a message", diagnostics);
        let mut scope = Scope::default();
        for field in &message.fields {
            check_spelling(&field.name, "a field", diagnostics);
            let rust = names::field_name(&field.name.value);
            scope.claim(Claim { age: 0, rust, name: &field.name, what: "fields" }, diagnostics);
        }
    }
    for (merged, width) in enums.list.iter().zip(widths) {
        let entries = merged.entries.iter().zip(constants(merged, width.owner));
        let claim = |(entry, rust): (&Entry<'a>, String)| Claim {
            age: loaded.age(entry.file),
            rust,
            name: &entry.syntax.name,
            what: "entries",
        };
        Scope::default().claim_all(entries.map(claim).collect(), diagnostics);
    }
}

fn all_messages(loaded: &Loaded) -> impl Iterator<Item = &Message> {
    loaded.files.iter().flat_map(|file| &file.messages)
}

pub(super) fn check_spelling(name: &Text, what: &str, diagnostics: &mut Diagnostics) {
    if let Some(fault) = fault(&name.value) {
        let message = format!("`{}` cannot be the name of {what}", name.value);
        let problem = Diagnostic::new(Code::BadName, name.span, message).label(fault);
        diagnostics.push(problem.help(match name.value.contains('[') {
            true => "the length of an array belongs to its type, as in `uint8_t[4]`",
            false => "names are letters, digits and underscores, a letter first",
        }));
    }
}

/// What keeps a text from being a name in the XML, or from leaving something to be a name in Rust.
fn fault(text: &str) -> Option<&'static str> {
    if text.is_empty() {
        Some("empty")
    } else if !text.bytes().all(|byte| byte == b'_' || byte.is_ascii_alphanumeric()) {
        Some("has other characters")
    } else if text.starts_with(|first: char| first.is_ascii_digit()) {
        Some("begins with a digit")
    } else if text.bytes().all(|byte| byte == b'_') {
        Some("nothing but underscores")
    } else {
        None
    }
}

fn is_name(text: &str) -> bool {
    fault(text).is_none()
}

/// A name that something would like to have in Rust.
struct Claim<'a> {
    /// The age of its file: see [`Loaded::age`].
    age: usize,
    rust: String,
    name: &'a Text,
    /// What has such names.
    what: &'static str,
}

/// Names that have to differ from each other.
#[derive(Default)]
struct Scope<'a> {
    taken: HashMap<String, (&'a Text, &'static str)>,
}

impl<'a> Scope<'a> {
    /// Takes names, those of older files first.
    fn claim_all(&mut self, mut claims: Vec<Claim<'a>>, diagnostics: &mut Diagnostics) {
        claims.sort_by_key(|claim| claim.age);
        claims.into_iter().for_each(|claim| self.claim(claim, diagnostics));
    }

    /// Takes a name, or reports who has it. Equal spellings are duplicates, and what is no name is none: both are reported
    /// elsewhere.
    fn claim(&mut self, Claim { rust, name, what, .. }: Claim<'a>, diagnostics: &mut Diagnostics) {
        let ((first, other), rust) = match self.taken.entry(rust) {
            hash_map::Entry::Occupied(taken) => (*taken.get(), taken.key().clone()),
            hash_map::Entry::Vacant(free) => {
                free.insert((name, what));
                return;
            }
        };
        if first.value == name.value || !is_name(&name.value) || !is_name(&first.value) {
            return;
        }
        diagnostics.push(collision(first, name, &rust, if what == other { what } else { "types" }));
    }

    /// Takes a name that has to be new, even if it is spelled like another.
    fn claim_new(&mut self, rust: String, name: &'a Text, diagnostics: &mut Diagnostics) {
        match self.taken.get(&rust) {
            Some((first, _)) if is_name(&name.value) => diagnostics.push(collision(first, name, &rust, "types")),
            Some(_) => {}
            None => {
                self.taken.insert(rust, (name, "types"));
            }
        }
    }
}

fn collision(first: &Text, name: &Text, rust: &str, what: &str) -> Diagnostic {
    let message = if first.value == name.value {
        format!("there is a type `{rust}` already")
    } else {
        format!("{what} `{}` and `{}` are both `{rust}` in Rust", first.value, name.value)
    };
    let problem = Diagnostic::new(Code::NameCollision, name.span, message);
    problem.related(first.span, "the other one").help("rename one of them")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spellings() {
        for name in ["A", "_a", "a1", "GPS_RAW_INT", "_1"] {
            assert!(is_name(name), "{name}");
        }
        for name in ["", "_", "__", "1A", "a-b", "a b", "é", "a.b"] {
            assert!(!is_name(name), "{name}");
        }
    }
}
