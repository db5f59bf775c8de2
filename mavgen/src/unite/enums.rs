//! Enums of several dialects: those of one name, width and kind are one type with the entries of all.

use std::collections::HashMap;

use super::Class;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Entry, Enum, EnumId, Lifecycle, Name, Origin, Repr};

/// What has to be equal for two enums to be one type: name, width, and whether its values are combined bit by bit.
type Kind = (Name, Repr, bool);

/// The enums so far.
#[derive(Default)]
pub(super) struct Enums {
    pub(super) list: Vec<Class<Enum>>,
    by_kind: HashMap<Kind, EnumId>,
}

impl Enums {
    /// Takes in the enums of a dialect, and returns for each what it is now.
    pub(super) fn take(
        &mut self,
        root: usize,
        dialect: &str,
        enums: Vec<Enum>,
        diagnostics: &mut Diagnostics,
    ) -> Vec<EnumId> {
        let mut ids = Vec::with_capacity(enums.len());
        for values in &enums {
            let next = EnumId(self.by_kind.len());
            let kind = (values.name.clone(), values.repr, values.bitmask);
            ids.push(*self.by_kind.entry(kind).or_insert(next));
        }
        for (mut values, id) in enums.into_iter().zip(&ids) {
            relink(&mut values, &ids);
            match self.list.get_mut(id.0) {
                None => self.list.push(Class { item: values, roots: vec![root] }),
                Some(class) => {
                    add(&mut class.item, values, dialect, diagnostics);
                    class.roots.push(root);
                }
            }
        }
        ids
    }

    /// The Rust name of an enum.
    pub(super) fn rust_name(&self, id: EnumId) -> &str {
        self.list.get(id.0).map_or("", |class| class.item.name.rust.as_str())
    }
}

/// Points the params of an enum's commands to what their enums are now.
fn relink(values: &mut Enum, ids: &[EnumId]) {
    let commands = values.entries.iter_mut().filter_map(|entry| entry.command.as_mut());
    for param in commands.flat_map(|command| &mut command.params) {
        param.values = param.values.and_then(|id| ids.get(id.0)).copied();
    }
}

/// Adds the entries of the same enum in `dialect`. An entry that is there already stays as it is.
fn add(values: &mut Enum, other: Enum, dialect: &str, diagnostics: &mut Diagnostics) {
    let by_xml: HashMap<String, usize> = index(&values.entries, |name| &name.text);
    let by_rust: HashMap<String, usize> = index(&values.entries, |name| &name.rust);
    for entry in other.entries {
        let place = by_xml.get(&entry.name.text).or(by_rust.get(&entry.name.rust));
        let Some(known) = place.and_then(|&at| values.entries.get_mut(at)) else {
            values.entries.push(entry);
            continue;
        };
        if known.name.text != entry.name.text {
            diagnostics.push(collision(known, &entry));
        } else if known.value != entry.value {
            diagnostics.push(second_value(known, &entry, (&values.name, dialect)));
        } else {
            join(&mut known.origin, entry.origin);
        }
    }
    // Stable: of two names for one value, that of the dialect that was named first stays first.
    values.entries.sort_by_key(|entry| entry.value);
    join(&mut values.origin, other.origin);
}

fn index(entries: &[Entry], spelling: impl Fn(&Name) -> &String) -> HashMap<String, usize> {
    entries.iter().enumerate().map(|(at, entry)| (spelling(&entry.name).clone(), at)).collect()
}

/// Adds what is said of the same item in another dialect: paragraphs that are new, and that it is in use there.
pub(super) fn join(origin: &mut Origin, other: Origin) {
    if origin.span == other.span && origin.description == other.description && origin.lifecycle == other.lifecycle {
        return;
    }
    for paragraph in other.description.split("\n\n").filter(|paragraph| !paragraph.trim().is_empty()) {
        if !origin.description.split("\n\n").any(|known| known.trim() == paragraph.trim()) {
            origin.append(paragraph);
        }
    }
    if matches!(origin.lifecycle, Some(Lifecycle::Deprecated(_))) {
        origin.lifecycle = other.lifecycle;
    }
}

fn second_value(first: &Entry, second: &Entry, (values, dialect): (&Name, &str)) -> Diagnostic {
    let (name, value, known) = (&second.name.text, second.value, first.value);
    let message = format!("`{name}` is {value} in dialect `{dialect}`, and {known} in one before it");
    let label = |entry: &Entry| {
        let auto = if entry.auto { ", given automatically" } else { "" };
        format!("{}{auto}", entry.value)
    };
    let problem = Diagnostic::new(Code::SecondValue, second.origin.span, message).label(label(second));
    let problem = problem.related(first.origin.span, label(first));
    problem.help(format!("give it one value: `{}` is one type for all dialects", values.text))
}

fn collision(first: &Entry, second: &Entry) -> Diagnostic {
    let (a, b, rust) = (&first.name.text, &second.name.text, &second.name.rust);
    let message = format!("entries `{a}` and `{b}` of two dialects are both `{rust}` in Rust");
    let problem = Diagnostic::new(Code::NameCollision, second.origin.span, message);
    problem.related(first.origin.span, "the other one").help("rename one of them")
}
