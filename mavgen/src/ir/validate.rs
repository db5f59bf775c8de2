//! Whether a model is legal. What `resolve` yields without errors always is; one that somebody built or changed by hand may not be.

mod enums;
mod members;
mod messages;
#[cfg(test)]
mod tests;
mod views;

use std::collections::HashSet;
use std::fmt;
use std::ops::Deref;

use super::{Dialect, EnumId, FileIndex, Limits, Name, Origin};
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
        let mut faults = Faults { dialect: self, list: Vec::new() };
        check_files(&mut faults);
        enums::check(&mut faults);
        messages::check(&mut faults);
        if faults.list.is_empty() { Ok(Valid(self)) } else { Err(faults.list) }
    }
}

/// The faults found so far, and the model that they are looked for in.
struct Faults<'d> {
    dialect: &'d Dialect,
    list: Vec<Fault>,
}

/// An item that is looked at.
struct Item {
    path: String,
    span: Option<Span>,
}

impl Item {
    fn named(kind: &str, name: &Name) -> Self {
        Self { path: format!("{kind} `{}`", name.text), span: Some(name.span) }
    }

    /// A part of it.
    fn part(&self, kind: &str, name: &Name) -> Self {
        Self { path: format!("{}, {kind} `{}`", self.path, name.text), span: Some(name.span) }
    }
}

impl Faults<'_> {
    fn push(&mut self, item: &Item, problem: impl Into<String>) {
        self.list.push(Fault { item: item.path.clone(), problem: problem.into(), span: item.span });
    }

    /// Reports a problem unless it is none.
    fn unless(&mut self, legal: bool, item: &Item, problem: &str) {
        if !legal {
            self.push(item, problem);
        }
    }

    fn check_name(&mut self, item: &Item, name: &Name) {
        if let Some(fault) = Name::fault(&name.text) {
            self.push(item, format!("its name is none: {fault}"));
        }
    }

    /// Reports names that stand there twice.
    fn check_once<'n>(&mut self, item: &Item, kind: &str, names: impl IntoIterator<Item = &'n str>) {
        let mut seen = HashSet::new();
        for name in names.into_iter().filter(|name| !seen.insert(*name)) {
            self.push(item, format!("{kind} `{name}` stands twice"));
        }
    }

    fn check_file(&mut self, item: &Item, file: FileIndex) {
        self.unless(self.dialect.files.get(file.0).is_some(), item, "it is of a file that does not exist");
    }

    fn check_origin(&mut self, item: &Item, origin: &Origin) {
        self.check_file(item, origin.file);
        let is_overlay = |file: &FileIndex| self.dialect.files.get(file.0).is_some_and(|file| file.overlay);
        self.unless(origin.overlays.iter().all(is_overlay), item, "an overlay of it is none");
    }

    fn check_enum(&mut self, item: &Item, id: Option<EnumId>) {
        let exists = id.is_none_or(|id| self.dialect.enums.get(id.0).is_some());
        self.unless(exists, item, "it names an enum that does not exist");
    }

    fn check_limits(&mut self, item: &Item, limits: Limits) {
        let Limits { min, max, increment } = limits;
        let finite = [min, max, increment].into_iter().flatten().all(f64::is_finite);
        self.unless(finite, item, "a limit is not finite");
    }
}

/// The files: definitions before overlays, and none that includes what there is not.
fn check_files(faults: &mut Faults<'_>) {
    let files = &faults.dialect.files;
    let item = Item { path: format!("dialect `{}`", faults.dialect.name), span: None };
    faults.unless(files.first().is_some_and(|file| !file.overlay), &item, "its first file is no definition");
    faults.unless(files.is_sorted_by_key(|file| file.overlay), &item, "a definition stands behind an overlay");
    for file in files {
        let item = Item { path: format!("file `{}`", file.name), span: None };
        let exist = file.includes.iter().all(|include| files.get(include.0).is_some());
        faults.unless(exist, &item, "it includes a file that does not exist");
    }
}
