//! Whether a model is legal. What `resolve` yields without errors always is; one that somebody built or changed by hand may not be.

mod messages;
#[cfg(test)]
mod tests;
mod views;

use std::collections::HashSet;
use std::fmt;
use std::ops::Deref;

use super::{Command, Dialect, Entry, Enum, EnumId, FileIndex, Limits, Name, Origin, PARAMS, Param};
use crate::source::Span;

/// A legal model: the only door to generated code.
#[derive(Clone, Copy, Debug)]
pub struct Valid<'d>(&'d Dialect);

impl<'d> Valid<'d> {
    /// The model.
    pub fn dialect(self) -> &'d Dialect {
        self.0
    }
}

impl Deref for Valid<'_> {
    type Target = Dialect;

    fn deref(&self) -> &Dialect {
        self.0
    }
}

/// What is illegal in a model. `Display` says where and why.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Fault {
    /// The item: `message `HEARTBEAT`, field `type``.
    pub item: String,
    /// What is wrong with it.
    pub problem: String,
    /// Where the item was written, if it has a name.
    pub span: Option<Span>,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.item, self.problem)
    }
}

impl std::error::Error for Fault {}

impl Dialect {
    /// Whether the model is legal: every index leads somewhere, ids and names stand there once, layouts and checksums are those
    /// of the wire, and views lie inside of their words.
    ///
    /// # Errors
    /// With every fault.
    pub fn validate(&self) -> Result<Valid<'_>, Vec<Fault>> {
        let mut faults = Vec::new();
        let path = format!("dialect `{}`", self.name);
        let mut item = Item { dialect: self, faults: &mut faults, path, span: None };
        check_files(&mut item);
        check_enums(&mut item);
        messages::check(&mut item);
        if faults.is_empty() { Ok(Valid(self)) } else { Err(faults) }
    }
}

/// An item that is looked at, the model that it is in, and the faults found so far.
struct Item<'f> {
    dialect: &'f Dialect,
    faults: &'f mut Vec<Fault>,
    path: String,
    span: Option<Span>,
}

impl Item<'_> {
    /// Another item, whose faults are listed with those of this one.
    fn other(&mut self, path: String, span: Option<Span>) -> Item<'_> {
        Item { dialect: self.dialect, faults: self.faults, path, span }
    }

    /// An item of the dialect; its name is checked.
    fn named(&mut self, kind: &str, name: &Name) -> Item<'_> {
        let mut item = self.other(format!("{kind} `{}`", name.text), Some(name.span));
        item.check_name(name);
        item
    }

    /// A part of it; its name is checked.
    fn part(&mut self, kind: &str, name: &Name) -> Item<'_> {
        self.named(&format!("{}, {kind}", self.path), name)
    }

    fn push(&mut self, problem: impl Into<String>) {
        self.faults.push(Fault { item: self.path.clone(), problem: problem.into(), span: self.span });
    }

    /// Reports a problem unless it is none.
    fn unless(&mut self, legal: bool, problem: &str) {
        if !legal {
            self.push(problem);
        }
    }

    fn check_name(&mut self, name: &Name) {
        if let Some(fault) = Name::fault(&name.text) {
            self.push(format!("its name is none: {fault}"));
        }
    }

    /// Reports names that stand there twice.
    fn check_once(&mut self, kind: &str, names: &mut dyn Iterator<Item = &Name>) {
        let mut seen = HashSet::new();
        for name in names.filter(|name| !seen.insert(*name)) {
            self.push(format!("{kind} `{}` stands twice", name.text));
        }
    }

    fn check_file(&mut self, file: FileIndex) {
        self.unless(self.dialect.file(file).is_some(), "it is of a file that does not exist");
    }

    fn check_origin(&mut self, origin: &Origin) {
        self.check_file(origin.file);
        let is_overlay = |file: &FileIndex| self.dialect.file(*file).is_some_and(|file| file.overlay);
        self.unless(origin.overlays.iter().all(is_overlay), "an overlay of it is none");
    }

    fn check_enum(&mut self, id: Option<EnumId>) {
        let exists = id.is_none_or(|id| self.dialect.enum_by_id(id).is_some());
        self.unless(exists, "it names an enum that does not exist");
    }

    fn check_limits(&mut self, limits: Limits) {
        let Limits { min, max, increment } = limits;
        let finite = [min, max, increment].into_iter().flatten().all(f64::is_finite);
        self.unless(finite, "a limit is not finite");
    }
}

/// The files: definitions before overlays, and none that includes what there is not.
fn check_files(item: &mut Item<'_>) {
    let dialect = item.dialect;
    let files = &dialect.files;
    item.unless(files.first().is_some_and(|file| !file.overlay), "its first file is no definition");
    item.unless(files.is_sorted_by_key(|file| file.overlay), "a definition stands behind an overlay");
    for file in files {
        let exist = file.includes.iter().all(|include| dialect.file(*include).is_some());
        let mut item = item.other(format!("file `{}`", file.name), None);
        item.unless(exist, "it includes a file that does not exist");
    }
}

fn check_enums(item: &mut Item<'_>) {
    let enums = &item.dialect.enums;
    item.check_once("enum", &mut enums.iter().map(|one| &one.name));
    enums.iter().for_each(|one| check_enum(item, one));
}

fn check_enum(item: &mut Item<'_>, one: &Enum) {
    let Enum { name, bitmask: _, repr, entries, named_in, defined_in, origin } = one;
    let mut item = item.named("enum", name);
    item.check_origin(origin);
    item.check_file(*named_in);
    item.check_file(*defined_in);
    item.unless(!entries.is_empty(), "it has no entries");
    item.unless(entries.is_sorted_by(|a, b| a.value < b.value), "its values do not rise");
    item.check_once("entry", &mut entries.iter().map(|entry| &entry.name));
    for entry in entries {
        let Entry { name, value, auto: _, command, origin } = entry;
        let mut item = item.part("entry", name);
        item.check_origin(origin);
        item.unless(*value <= repr.highest(), "its value does not fit the enum");
        command.iter().for_each(|command| check_command(&mut item, command));
    }
}

fn check_command(item: &mut Item<'_>, command: &Command) {
    let Command { params, has_location: _, is_destination: _, mission_only: _ } = command;
    item.unless(params.is_sorted_by(|a, b| a.index < b.index), "the indices of its params do not rise");
    for param in params {
        let Param { index, label: _, units: _, enum_, limits, default, reserved: _, origin } = param;
        let mut item = item.other(format!("{}, param {index}", item.path), item.span);
        item.unless(PARAMS.contains(index), "its index is not one from 1 to 7");
        item.check_enum(*enum_);
        item.check_limits(*limits);
        item.unless(default.is_none_or(|value| !value.is_infinite()), "its default is infinite");
        item.check_origin(origin);
    }
}
