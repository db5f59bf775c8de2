//! Enums of several dialects: those of one name, width and kind are one type with the entries of all.
//!
//! An entry that was renamed and kept its value is one constant if its names are one in Rust, else two constants of one value.
//! Both names are read; it is shown by the name in the dialect that was named first. An enum in which an entry has another value is another
//! type: one constant cannot have two values.

use std::collections::HashMap;

use super::Class;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::internal::Internal;
use crate::ir::{Entry, Enum, EnumId, Lifecycle, Origin, Repr, enums_of_enum_mut};
use crate::lower::names::{EnumNames, drop_rivals};
use crate::order;

/// What has to be equal for two enums to be one type: the name, in the definitions and in Rust, the width, and whether the
/// values are combined bit by bit.
type Kind = (String, String, Repr, bool);

#[derive(Default)]
pub(super) struct Enums {
    pub(super) list: Vec<Class<Enum, EnumNames>>,
    by_kind: HashMap<Kind, Vec<EnumId>>,
}

impl Enums {
    /// Takes in the enums of a dialect, and returns for each what it is now.
    pub(super) fn take(
        &mut self,
        (root, dialect): (usize, &str),
        enums: Vec<(Enum, EnumNames)>,
        diagnostics: &mut Diagnostics,
    ) -> Result<Vec<EnumId>, Internal> {
        let ids = self.ids(dialect, &enums, diagnostics);
        for ((mut enum_, names), id) in enums.into_iter().zip(&ids) {
            follow(&ids, |each| enums_of_enum_mut(&mut enum_, each))?;
            match self.list.get_mut(id.0) {
                None => self.list.push(Class { item: enum_, names, roots: vec![root] }),
                Some(class) => class.add(root, enum_, names),
            }
        }
        Ok(ids)
    }

    /// For each enum of a dialect that of the same kind whose entries agree with its own, or a new one.
    fn ids(&mut self, dialect: &str, enums: &[(Enum, EnumNames)], diagnostics: &mut Diagnostics) -> Vec<EnumId> {
        let mut ids = Vec::with_capacity(enums.len());
        let mut next = self.list.len();
        for (enum_, names) in enums {
            let kind = (enum_.name.text.clone(), names.ty.clone(), enum_.repr, enum_.bitmask);
            let known = self.by_kind.entry(kind).or_default();
            let classes = known.iter().filter_map(|id| Some((*id, self.list.get(id.0)?)));
            let conflicts = classes.map(|(id, class)| (id, class.conflict(enum_, names))).collect_vec();
            let agrees = conflicts.iter().find(|(_, conflict)| conflict.is_none());
            ids.push(agrees.map_or(EnumId(next), |(id, _)| *id));
            if agrees.is_none() {
                let first = conflicts.into_iter().find_map(|(_, conflict)| conflict);
                diagnostics.extend(first.map(|(first, second)| second_value(first, second, dialect)));
                known.push(EnumId(next));
                next += 1;
            }
        }
        ids
    }

    /// The type of an enum.
    pub(super) fn ty(&self, id: EnumId) -> Option<&str> {
        self.list.get(id.0).map(|class| class.names.ty.as_str())
    }
}

/// Points every mention of an enum, which `each` finds, to what that enum is now.
pub(super) fn follow(ids: &[EnumId], each: impl FnOnce(&mut dyn FnMut(&mut EnumId))) -> Result<(), Internal> {
    let mut lost = None;
    each(&mut |id| match ids.get(id.0) {
        Some(now) => *id = *now,
        None => lost = Some(id.0),
    });
    lost.map_or(Ok(()), |lost| Err(Internal::new(format!("there is no enum {lost} in the dialect that names it"))))
}

impl Class<Enum, EnumNames> {
    /// An entry that would have two values, with that which it has here; `None` if all can be one type.
    fn conflict<'e>(&'e self, other: &'e Enum, names: &EnumNames) -> Option<(&'e Entry, &'e Entry)> {
        let places = self.places();
        let mut entries = other.entries.iter().zip(&names.constants);
        entries.find_map(|(entry, constant)| {
            let known = places.of(entry, constant).and_then(|at| self.item.entries.get(at))?;
            (known.value != entry.value).then_some((known, entry))
        })
    }

    /// Adds the entries of the same enum in another dialect. An entry that is there already stays as it is.
    fn add(&mut self, root: usize, other: Enum, names: EnumNames) {
        let (places, known) = (self.places(), self.item.entries.len());
        for ((entry, constant), command) in other.entries.into_iter().zip(names.constants).zip(names.commands) {
            match places.of(&entry, &constant).and_then(|at| self.item.entries.get_mut(at)) {
                Some(known) => {
                    if !places.by_text.contains_key(&entry.name.text) {
                        self.names.renamed.push((entry.name.text, constant));
                    }
                    join(&mut known.origin, entry.origin);
                }
                None => {
                    self.item.entries.push(entry);
                    self.names.constants.push(constant);
                    self.names.commands.push(command);
                }
            }
        }
        drop_rivals(&mut self.names.commands, known);
        self.sort();
        join(&mut self.item.origin, other.origin);
        self.roots.push(root);
    }

    /// The entries by value. Of two names for one value, that of the dialect that was named first stays first.
    fn sort(&mut self) {
        let (entries, EnumNames { constants, commands, .. }) = (&mut self.item.entries, &mut self.names);
        let named = std::mem::take(entries).into_iter().zip(std::mem::take(constants)).zip(std::mem::take(commands));
        let mut named = named.collect_vec();
        order::sort_by_key(&mut named, |((entry, _), _)| entry.value);
        let pairs: Vec<(Entry, String)>;
        (pairs, *commands) = named.into_iter().unzip();
        (*entries, *constants) = pairs.into_iter().unzip();
    }

    fn places(&self) -> Places {
        let EnumNames { constants, renamed, .. } = &self.names;
        let by_constant: HashMap<_, _> = constants.iter().cloned().zip(0..).collect();
        let texts = self.item.entries.iter().map(|entry| entry.name.text.clone()).zip(0..);
        let renamed = renamed.iter().filter_map(|(text, constant)| Some((text.clone(), *by_constant.get(constant)?)));
        Places { by_text: texts.chain(renamed).collect(), by_constant }
    }
}

struct Places {
    by_text: HashMap<String, usize>,
    by_constant: HashMap<String, usize>,
}

impl Places {
    /// That of the entry that is called so in the definitions, also of another dialect, or else in Rust.
    fn of(&self, entry: &Entry, constant: &str) -> Option<usize> {
        self.by_text.get(&entry.name.text).or_else(|| self.by_constant.get(constant)).copied()
    }
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

/// Says why an enum is a type in each dialect: who bridges the two passes on a number that means something else there.
fn second_value(first: &Entry, second: &Entry, dialect: &str) -> Diagnostic {
    let (name, known) = (&second.name.text, &first.name.text);
    let known = if name == known { first.value.to_string() } else { format!("`{known}` is {}", first.value) };
    let message = format!("`{name}` is {} in dialect `{dialect}`, and {known} in one before it", second.value);
    let label = |entry: &Entry| {
        let auto = if entry.auto { ", given automatically" } else { "" };
        format!("{}{auto}", entry.value)
    };
    let problem = Diagnostic::new(Code::SecondValue, second.origin.span, message).label(label(second));
    let problem = problem.related(first.origin.span, label(first));
    problem.help("with one value it is one type for both dialects; else each has its own, and its own messages with it")
}
