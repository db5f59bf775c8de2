//! A file to copy, and its copies.

use std::collections::{BTreeSet, HashMap};
use std::ops::Range;
use std::path::Path;

use super::header::{DESCRIBED_HERE, NOT_DESCRIBED, OTHER_INCLUDES, Share, UNCHANGED, header, split_declaration};
use super::part::Part;
use super::prose::{Key, Library};
use super::tree::{Element, place};
use super::{Copy, Item, cut, digest, facts};
use crate::builder::Failure;
use crate::read::Loaded;
use crate::source::Sources;
use crate::syntax;

/// A file to copy.
pub(super) struct Original<'t> {
    pub(super) name: String,
    path: &'t Path,
    text: &'t str,
    /// Its includes, in order.
    includes: Vec<Include>,
    root: Element<'t>,
    /// Where the messages and enums start that are not part of its copy.
    left_out: BTreeSet<usize>,
    /// How much is in the copy, if something is left out.
    share: Option<Share>,
}

/// An include of a file.
struct Include {
    /// Where its path stands in the text.
    place: Range<usize>,
    /// The path, as the file spells it.
    path: String,
    /// What the file that it leads to is called in the folder.
    name: String,
}

/// The files of a dialect.
pub(super) fn originals<'t>(loaded: &Loaded, sources: &'t Sources) -> Result<Vec<Original<'t>>, Failure> {
    let names = names(loaded, sources)?;
    let mut originals = Vec::new();
    for ((file, name), targets) in loaded.files.iter().zip(&names).zip(&loaded.includes) {
        let Some(source) = sources.get(file.id) else { continue };
        let unread = || Failure::Usage(format!("{}: no XML to copy", source.path().display()));
        let root = Element::root(source.text()).ok_or_else(unread)?;
        let includes = file.includes.iter().zip(targets).filter_map(|(path, target)| {
            let (place, name) = (path.span.range(), names.get(target.0)?.clone());
            Some(Include { place, path: path.value.clone(), name })
        });
        let includes = includes.collect();
        let (name, path, text) = (name.clone(), source.path(), source.text());
        originals.push(Original { name, path, text, includes, root, left_out: BTreeSet::new(), share: None });
    }
    Ok(originals)
}

/// The names of a dialect's files in one folder, in its order.
///
/// Two files of one name cannot both be in the folder, and no name is made up: whoever includes them wants to know. Case does
/// not tell two names apart, because on some systems it does not.
fn names(loaded: &Loaded, sources: &Sources) -> Result<Vec<String>, Failure> {
    let mut seen = HashMap::new();
    let mut names = Vec::new();
    for source in loaded.files.iter().filter_map(|file| sources.get(file.id)) {
        let name = source.name();
        if let Some(first) = seen.insert(name.to_lowercase(), source.path()) {
            let (first, second) = (first.display(), source.path().display());
            let problem = format!("`{first}` and `{second}` would be one file in one folder: rename one of them");
            return Err(Failure::Usage(problem));
        }
        names.push(name);
    }
    Ok(names)
}

impl<'t> Original<'t> {
    /// Leaves out what is not in the part.
    pub(super) fn leave_out(&mut self, syntax::File { messages, enums, .. }: &syntax::File, part: &Part) {
        let gone = messages.iter().filter(|message| !part.has_message(message)).map(|message| message.span);
        let messages_gone: BTreeSet<usize> = gone.map(|span| span.range().start).collect();
        let gone = enums.iter().filter(|enum_| !part.has_enum(enum_)).map(|enum_| enum_.span);
        let enums_gone: BTreeSet<usize> = gone.map(|span| span.range().start).collect();
        let share = Share {
            messages: (messages.len() - messages_gone.len(), messages.len()),
            enums: (enums.len() - enums_gone.len(), enums.len()),
        };
        self.left_out = &messages_gone | &enums_gone;
        self.share = (!self.left_out.is_empty()).then_some(share);
    }

    /// The text below a header, without what is left out.
    pub(super) fn whole(&self) -> Copy {
        let respelled = self.includes.iter().filter(|include| include.path != include.name);
        let mut edits: Vec<_> =
            respelled.map(|include| (include.place.clone(), facts::escaped(&include.name))).collect();
        let kind = if edits.is_empty() { UNCHANGED } else { OTHER_INCLUDES };
        let places = self.lists().flat_map(|list| cut::places(self.text, list, &self.left_out));
        edits.extend(places.map(|place| (place, String::new())));
        let text = edited(self.text, edits);
        let (declaration, rest) = split_declaration(&text);
        let header = self.header(kind, &digest::of_text(declaration, rest));
        let line_end = if self.text.contains("\r\n") { "\r\n" } else { "\n" };
        let text = match declaration {
            "" => format!("{header}{line_end}{rest}"),
            _ => format!("{declaration}{line_end}{header}{rest}"),
        };
        self.copy(text, Vec::new())
    }

    /// The facts below a header, with the words of a library if there is one.
    pub(super) fn facts(&self, mut library: Option<&mut Library>) -> Copy {
        let facts = self.described(&mut |key| library.as_mut()?.take(&self.name, key));
        let kind = if library.is_some() { DESCRIBED_HERE } else { NOT_DESCRIBED };
        let item = |(name, described): (String, bool)| {
            let new = library.as_ref().is_some_and(|library| !library.knows(&name));
            Item { name, described, new }
        };
        let items = facts.described.into_iter().map(item).collect();
        let declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
        let digest = digest::of_facts(&format!("{declaration}{}", facts.text)).unwrap_or_default();
        let text = format!("{declaration}{}\n{}", self.header(kind, &digest), facts.text);
        self.copy(text, items)
    }

    /// The facts of what is in its copy, with the words that `describe` has.
    fn described(&self, describe: &mut facts::Describe<'_>) -> facts::Facts {
        let mut root = self.root.clone();
        for list in &mut root.children {
            list.children.retain(|child| !self.is_left_out(child));
        }
        let includes: Vec<String> = self.includes.iter().map(|include| include.name.clone()).collect();
        facts::write(&root, &includes, describe)
    }

    /// The names of everything in its copy that there can be words about.
    pub(super) fn keys(&self) -> BTreeSet<Key> {
        let mut keys = BTreeSet::new();
        self.described(&mut |key| {
            keys.insert(key.to_owned());
            None
        });
        keys
    }

    /// The names of the messages and enums that are left out.
    pub(super) fn left_out_keys(&self) -> impl Iterator<Item = Key> {
        let gone = self.lists().flat_map(|list| &list.children).filter(|child| self.is_left_out(child));
        gone.map(|child| format!("{} {}", child.name, child.attribute("name").unwrap_or_default()))
    }

    fn is_left_out(&self, element: &Element<'_>) -> bool {
        self.left_out.contains(&place(self.text, element.outer).start)
    }

    fn header(&self, kind: &str, digest: &str) -> String {
        header(&self.name, self.text, kind, self.share, digest)
    }

    fn copy(&self, text: String, items: Vec<Item>) -> Copy {
        Copy { name: self.name.clone(), text, source: self.path.to_owned(), items }
    }

    /// The elements that hold enums and messages.
    fn lists(&self) -> impl Iterator<Item = &Element<'t>> {
        self.root.children.iter().filter(|child| ["enums", "messages"].contains(&child.name))
    }
}

/// A text with other texts in some places.
fn edited(text: &str, mut edits: Vec<(Range<usize>, String)>) -> String {
    edits.sort_by_key(|(place, _)| place.start);
    let (mut edited, mut end) = (String::with_capacity(text.len()), 0);
    for (place, new) in edits {
        edited.push_str(text.get(end..place.start).unwrap_or_default());
        edited.push_str(&new);
        end = place.end;
    }
    edited.push_str(text.get(end..).unwrap_or_default());
    edited
}
