//! Builders of uORB messages: from a folder of `.msg` files, at one or several times, to files.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use super::{Builder, Failure};
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::emit::{GeneratedFile, emit};
use crate::lower::spelling;
use crate::lower::topic::{CONSTANTS, UnionNames, tree};
use crate::output::{Report, write};
use crate::problems::Problems;
use crate::source::Sources;
use crate::uorb::union::{Definition, Union};
use crate::uorb::{load, overlays, selected};

/// What the newest definition is called if its folder's name says nothing.
const NEWEST: &str = "newest";

/// A folder's name that says nothing.
const ANY: &str = "msg";

/// uORB messages that were read and resolved without errors.
#[derive(Clone, Debug)]
pub struct Topics {
    /// The messages, of all definitions.
    pub union: Union,
    /// What everything in it is called in Rust.
    names: UnionNames,
    /// What is worth a look: warnings and notes.
    pub diagnostics: Diagnostics,
    /// The texts that the spans point into.
    pub sources: Sources,
    /// Every file that was read.
    pub watched: Vec<PathBuf>,
}

impl Builder {
    /// Adds an older definition of the messages, from the folder of its `.msg` files; the newest of the older ones first.
    ///
    /// A message is then the union of its definitions: the newest one's fields, then what only older ones have; of one
    /// field, the longest array and the widest number. Each definition is a constant of the message, called as here:
    /// `v1_14` is `EscStatus::V1_14`.
    ///
    /// ```no_run
    /// // build.rs
    /// mavgen::Builder::new("msg/main").older("v1_14", "msg/v1_14").name("px4").build_script();
    /// ```
    #[must_use]
    pub fn older(mut self, name: impl Into<String>, folder: impl Into<PathBuf>) -> Self {
        self.older.push((name.into(), folder.into()));
        self
    }

    /// What the newest definition of uORB messages is called: `main` makes it `EscStatus::MAIN`. Without this it is the name
    /// of the folder, or `newest` if that is `msg`.
    #[must_use]
    pub fn definition(mut self, name: impl Into<String>) -> Self {
        self.definition = Some(name.into());
        self
    }

    /// Reads, resolves and selects uORB messages; writes nothing. [`Builder::resolve`] does so for a dialect.
    ///
    /// # Errors
    /// As [`Builder::resolve`]; [`Failure::Usage`] also if this is no builder of uORB messages, or if a definition has no name
    /// that can be a constant's, or that of another.
    pub fn topics(&self) -> Result<Topics, Failure> {
        let definitions = self.definitions()?;
        let (mut sources, mut diagnostics) = (Sources::default(), self.diagnostics()?);
        let folders = definitions.iter().map(|(_, folder)| folder.as_path()).collect_vec();
        let said = overlays(&self.overlays, &folders, &mut sources, &mut diagnostics);
        let mut wanted: Option<HashSet<String>> = None;
        let mut read = Vec::new();
        for (name, folder) in &definitions {
            // Of older definitions, what is wanted of the newest; a file alone is a selection as well.
            let names = self.messages.as_deref().unwrap_or_default();
            if wanted.is_none() && (self.messages.is_some() || !folder.is_dir()) {
                wanted = Some(selected(folder, names).map_err(Failure::Usage)?.into_iter().collect());
            }
            let is_wanted = |name: &str| wanted.as_ref().is_none_or(|wanted| wanted.contains(name));
            let package = load(folder, &said, is_wanted, &mut sources, &mut diagnostics);
            if let Some(wanted) = &mut wanted {
                wanted.extend(package.messages.iter().map(|message| message.name.clone()));
            }
            read.push(Definition { name: name.clone(), package });
        }
        let union = Union::of(&self.package_name(), read, &mut diagnostics);
        let names = UnionNames::check(&union, &mut diagnostics);
        diagnostics.arrange();
        let watched = self.watched_files(&sources, &folders, diagnostics.has_errors());
        let Problems { diagnostics, sources, watched } = self.judged(Problems { diagnostics, sources, watched })?;
        Ok(Topics { union, names, diagnostics, sources, watched })
    }

    /// Generates into memory what was resolved by [`Builder::topics`].
    ///
    /// # Errors
    /// [`Failure::Usage`] as [`Builder::files`].
    pub fn emit_topics(&self, topics: &Topics) -> Result<Vec<GeneratedFile>, Failure> {
        let options = self.options(&topics.sources)?;
        Ok(emit(&tree(&topics.union, &topics.names, &options)?, self.layout)?)
    }

    /// Writes what was resolved by [`Builder::topics`] into the output folder.
    ///
    /// # Errors
    /// As [`Builder::generate`].
    pub fn write_topics(&self, topics: &Topics) -> Result<Report, Failure> {
        write(self.folder()?, &self.emit_topics(topics)?).map_err(Failure::Output)
    }

    /// The definitions, newest first: what each is called, and its folder.
    fn definitions(&self) -> Result<Vec<(String, PathBuf)>, Failure> {
        let [newest] = self.roots.as_slice() else {
            return Err(Failure::Usage("uORB messages are of one folder: older definitions are Builder::older".into()));
        };
        if !self.is_uorb() {
            return Err(Failure::Usage(format!("`{}` is a dialect, not uORB messages", newest.display())));
        }
        let folder = if newest.is_dir() { Some(newest.as_path()) } else { newest.parent() };
        let of_folder = folder.and_then(Path::file_name).and_then(|name| name.to_str()).filter(|name| *name != ANY);
        let name = self.definition.as_deref().or(of_folder).unwrap_or(NEWEST);
        let newest = std::iter::once((name.to_owned(), newest.clone()));
        let definitions = newest.chain(self.older.iter().cloned()).collect_vec();
        let mut known = HashSet::new();
        for (name, _) in &definitions {
            if let Some(why) = no_definition(name) {
                let help =
                    "--definition and --older give names, Builder::definition and Builder::older in a build script";
                return Err(Failure::Usage(format!("a definition cannot be called `{name}`: {why} ({help})")));
            }
            if !known.insert(spelling::constant(name)) {
                return Err(Failure::Usage(format!("two definitions are called `{name}`: give each its own name")));
            }
        }
        Ok(definitions)
    }

    /// What the package is called: as said, or as its folder, or as what is around that.
    fn package_name(&self) -> String {
        let root = self.roots.first().map(PathBuf::as_path).unwrap_or(Path::new(""));
        let stem = |path: &Path| path.file_stem().and_then(|name| name.to_str()).map(str::to_owned);
        let own = stem(root).filter(|name| name != ANY).or_else(|| root.parent().and_then(stem));
        self.name.clone().or(own).unwrap_or_else(|| "uorb".to_owned())
    }

    /// What has to be looked at again: what was read, and the folders where a file may be added that changes something.
    fn watched_files(&self, sources: &Sources, folders: &[&Path], has_errors: bool) -> Vec<PathBuf> {
        let read = sources.iter().map(|(_, file)| file.path().to_owned());
        let all = self.messages.is_none() || has_errors;
        let folders = folders.iter().filter(|_| all).map(|folder| (*folder).to_owned());
        read.chain(folders).collect_vec()
    }
}

/// Why a definition cannot be called so, if it cannot: each is a constant of every message.
fn no_definition(name: &str) -> Option<&'static str> {
    let letters = |c: char| c.is_ascii_alphanumeric() || c == '_';
    if !name.starts_with(|c: char| c.is_ascii_alphabetic()) || !name.chars().all(letters) {
        return Some("use letters, digits and underscores, and begin with a letter");
    }
    CONSTANTS.contains(&&*spelling::constant(name)).then_some("every message has another constant of that name")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_definition_has_a_name_that_messages_have_left() {
        for good in ["main", "v1_14", "V2026", "DEFAULT", "type", "unknown_2"] {
            assert_eq!(no_definition(good), None, "{good}");
        }
        for bad in ["", "1.14", "v1.14", "_v1", "ü", "unknown", "UNKNOWN", "Topics", "definitions"] {
            assert!(no_definition(bad).is_some(), "{bad}");
        }
    }
}
