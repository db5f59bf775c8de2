//! Descriptions by the names of what they describe, so that they find their place in another state of the definitions.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use super::tree::Element;
use super::{Unplaced, header};
use crate::read::grammar::Filling;

/// What people wrote about one element.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Words {
    /// The description, spelled as in the file.
    pub(super) text: String,
    /// The comments before the element.
    pub(super) above: Vec<String>,
    /// The comments at its end.
    pub(super) below: Vec<String>,
}

impl Words {
    fn is_empty(&self) -> bool {
        self.text.trim().is_empty() && self.above.is_empty() && self.below.is_empty()
    }

    /// In one line, for a report.
    fn shown(&self) -> String {
        let words = self.above.iter().chain([&self.text]).chain(&self.below).flat_map(|text| text.split_whitespace());
        words.collect::<Vec<_>>().join(" ")
    }
}

/// The names of an element and of those that it stands in: `message HEARTBEAT field type`.
pub(super) type Key = String;

/// Gives the elements of one file their keys.
#[derive(Default)]
pub(super) struct Keys {
    seen: BTreeMap<Key, usize>,
}

impl Keys {
    /// The key of an element, and the one that its children's keys start with.
    ///
    /// Of several that are called the same each has its own key, but the children do not know that: an enum may stand in two
    /// pieces today and in one tomorrow.
    pub(super) fn key(&mut self, parent: &str, element: &Element<'_>) -> (Key, Key) {
        let name = ["name", "index"].into_iter().find_map(|attribute| element.attribute(attribute));
        let own = name.map_or_else(|| element.name.to_owned(), |name| format!("{} {name}", element.name));
        let base = if ["", "mavlink", "enums", "messages"].contains(&parent) { own } else { format!("{parent} {own}") };
        let count = self.seen.entry(base.clone()).or_default();
        *count += 1;
        (if *count == 1 { base.clone() } else { format!("{base} ({count})") }, base)
    }
}

/// The enum or message that a key is about, or is part of: `message HEARTBEAT`.
pub(super) fn item(key: &str) -> &str {
    let second = key.match_indices(' ').nth(1);
    second.and_then(|(end, _)| key.get(..end)).unwrap_or(key)
}

/// Whether somebody wrote something into a text that is in none of these.
pub(super) fn is_lost<'t>(text: &str, others: impl IntoIterator<Item = &'t str>) -> bool {
    let Some(mut prose) = Element::root(text).map(|root| Prose::of(&root)) else { return false };
    for other in others {
        if prose.words.is_empty() {
            break;
        }
        if let Some(other) = Element::root(other).map(|root| Prose::of(&root)) {
            prose.words.retain(|key, words| other.words.get(key) != Some(words));
        }
    }
    !prose.words.is_empty()
}

/// What people wrote in one file.
#[derive(Clone, Debug, Default)]
struct Prose {
    words: BTreeMap<Key, Words>,
    /// All elements of the file, described or not.
    known: BTreeSet<Key>,
}

impl Prose {
    /// The prose of the file with this root element.
    fn of(root: &Element<'_>) -> Self {
        let mut prose = Self::default();
        prose.read("", root, &mut Keys::default());
        prose
    }

    fn read(&mut self, parent: &str, element: &Element<'_>, keys: &mut Keys) {
        let (key, base) = keys.key(parent, element);
        let own = element.above.iter().filter(|comment| !header::is_mark(comment));
        let mut words =
            Words { text: String::new(), above: own.map(|comment| text(comment)).collect(), below: Vec::new() };
        match element.filling() {
            Filling::Prose => words.text = text(element.inner),
            Filling::Elements => {
                words.below = element.below.iter().map(|comment| text(comment)).collect();
                element.children.iter().for_each(|child| self.read(&base, child, keys));
            }
            Filling::Fact | Filling::Nothing => {}
        }
        self.known.insert(key.clone());
        if !words.is_empty() {
            self.words.insert(key, words);
        }
    }
}

/// What people wrote in all files of a folder.
pub(super) struct Library {
    folder: PathBuf,
    /// The files, by name.
    files: Vec<(String, Prose)>,
    /// For each file, what it will have words about itself.
    claimed: Vec<(String, BTreeSet<Key>)>,
}

impl Library {
    /// Nothing yet of a folder.
    pub(super) fn of(folder: &Path) -> Self {
        Self { folder: folder.to_owned(), files: Vec::new(), claimed: Vec::new() }
    }

    /// Adds the file of this name and root element.
    pub(super) fn add(&mut self, file: &str, root: &Element<'_>) {
        self.files.push((file.to_owned(), Prose::of(root)));
    }

    /// Says what the elements of the new state of a file are, so that no other file takes its words.
    pub(super) fn claim(&mut self, file: &str, keys: BTreeSet<Key>) {
        self.claimed.push((file.to_owned(), keys));
    }

    /// Whether there was such an element.
    pub(super) fn knows(&self, key: &str) -> bool {
        self.files.iter().any(|(_, prose)| prose.known.contains(key))
    }

    /// Takes what was written about an element of a file: there or, if it has moved, in the file that it comes from.
    pub(super) fn take(&mut self, file: &str, key: &str) -> Option<Words> {
        let own = self.files.iter_mut().find(|(name, _)| name == file).and_then(|(_, prose)| prose.words.remove(key));
        if own.is_some() || !key.starts_with("enum ") && !key.starts_with("message ") {
            return own;
        }
        let claimed = &self.claimed;
        let moved = |name: &str| !claimed.iter().any(|(file, keys)| file == name && keys.contains(key));
        let mut others = self.files.iter_mut().filter(|(name, _)| moved(name));
        others.find_map(|(_, prose)| prose.words.remove(key))
    }

    /// What nobody took.
    pub(super) fn rest(&self) -> impl Iterator<Item = Unplaced> {
        let rest = self.files.iter().flat_map(|(file, prose)| prose.words.iter().map(move |words| (file, words)));
        rest.map(|(file, (key, words))| Unplaced {
            file: self.folder.join(file),
            name: key.clone(),
            words: words.shown(),
        })
    }
}

/// Line ends as XML reads them.
fn text(raw: &str) -> String {
    raw.replace("\r\n", "\n").replace('\r', "\n")
}
