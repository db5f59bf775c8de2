//! A file to copy, and its copies.

use std::collections::BTreeSet;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use super::header::{Kind, Share, What, header, split_declaration};
use super::part::Part;
use super::prose::{Key, Library};
use super::tree::{Element, place};
use super::{Copy, Item, cut, digest, facts, flat};
use crate::builder::Failure;
use crate::read::Loaded;
use crate::source::Sources;
use crate::syntax;

/// A file to copy.
pub(super) struct Original<'t> {
    pub(super) name: String,
    path: &'t Path,
    text: &'t str,
    syntax: Arc<syntax::File>,
    /// The places of its includes, and what they are called in the folder.
    includes: Vec<flat::Include>,
    root: Element<'t>,
}

/// The files of a dialect.
pub(super) fn originals<'t>(loaded: &Loaded, sources: &'t Sources) -> Result<Vec<Original<'t>>, Failure> {
    let names = flat::names(loaded, sources)?;
    let mut originals = Vec::new();
    for (at, file) in loaded.files.iter().enumerate() {
        let Some((source, name)) = sources.get(file.id).zip(names.get(at)) else { continue };
        let unread = || Failure::Usage(format!("{}: no XML to copy", source.path().display()));
        let root = Element::root(source.text()).ok_or_else(unread)?;
        let (name, includes) = (name.clone(), flat::includes(loaded, at, &names));
        let (path, text, syntax) = (source.path(), source.text(), Arc::clone(file));
        originals.push(Original { name, path, text, syntax, includes, root });
    }
    Ok(originals)
}

/// What of a file is not part of its copy.
struct LeftOut {
    /// Where its messages and enums start.
    starts: BTreeSet<usize>,
    /// How much is in the copy.
    share: Share,
}

impl<'t> Original<'t> {
    /// The text below a header; with a part, without the rest.
    pub(super) fn whole(&self, part: Option<&Part>) -> Copy {
        let left_out = self.left_out(part);
        let mut edits = flat::respelled(&self.includes);
        let includes = !edits.is_empty();
        if let Some(LeftOut { starts, .. }) = &left_out {
            let places = self.lists().flat_map(|list| cut::places(self.text, list, starts));
            edits.extend(places.map(|place| (place, String::new())));
        }
        let text = edited(self.text, edits);
        let (declaration, rest) = split_declaration(&text);
        let digest = digest::of_text(declaration, rest);
        let what = What { kind: Kind::Whole { includes }, share: left_out.map(|left_out| left_out.share), digest };
        let header = header(&self.name, self.text, &what);
        let line_end = if self.text.contains("\r\n") { "\r\n" } else { "\n" };
        let text = match declaration {
            "" => format!("{header}{line_end}{rest}"),
            _ => format!("{declaration}{line_end}{header}{rest}"),
        };
        self.copy(text, Vec::new())
    }

    /// The facts below a header, with the words of a library if there is one.
    pub(super) fn facts(&self, part: Option<&Part>, library: Option<&mut Library>) -> Copy {
        let left_out = self.left_out(part);
        let root = self.kept(left_out.as_ref());
        let includes: Vec<String> = self.includes.iter().map(|include| include.name.clone()).collect();
        let kind = if library.is_some() { Kind::Described } else { Kind::Facts };
        let (facts, known) = match library {
            Some(library) => {
                let facts = facts::write(&root, &includes, &mut |key| library.take(&self.name, key));
                (facts, Some(library))
            }
            None => (facts::write(&root, &includes, &mut |_| None), None),
        };
        let item = |(name, described): (String, bool)| {
            let new = known.as_ref().is_some_and(|library| !library.knows(&name));
            Item { name, described, new }
        };
        let items = facts.described.into_iter().map(item).collect();
        let declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
        let digest = digest::of_facts(&format!("{declaration}{}", facts.text)).unwrap_or_default();
        let what = What { kind, share: left_out.map(|left_out| left_out.share), digest };
        let text = format!("{declaration}{}\n{}", header(&self.name, self.text, &what), facts.text);
        self.copy(text, items)
    }

    /// The names of everything in its copy.
    pub(super) fn keys(&self, part: Option<&Part>) -> Vec<Key> {
        facts::keys(&self.kept(self.left_out(part).as_ref()))
    }

    /// The names of the messages and enums that are left out.
    pub(super) fn left_out_keys(&self, part: Option<&Part>) -> Vec<Key> {
        let Some(LeftOut { starts, .. }) = self.left_out(part) else { return Vec::new() };
        let all = self.lists().flat_map(|list| &list.children);
        let gone = all.filter(|child| starts.contains(&place(self.text, child.outer).start));
        gone.map(|child| format!("{} {}", child.name, child.attribute("name").unwrap_or_default())).collect()
    }

    fn copy(&self, text: String, items: Vec<Item>) -> Copy {
        Copy { name: self.name.clone(), text, source: self.path.to_owned(), items }
    }

    /// The elements that hold enums and messages.
    fn lists(&self) -> impl Iterator<Item = &Element<'t>> {
        self.root.children.iter().filter(|child| ["enums", "messages"].contains(&child.name))
    }

    /// What is not in the part; `None` if nothing is left out.
    fn left_out(&self, part: Option<&Part>) -> Option<LeftOut> {
        let (part, syntax::File { messages, enums, .. }) = (part?, &*self.syntax);
        let starts = messages.iter().filter(|message| !part.has_message(message)).map(|message| message.span);
        let messages_gone: Vec<usize> = starts.map(|span| span.range().start).collect();
        let starts = enums.iter().filter(|enum_| !part.has_enum(enum_)).map(|enum_| enum_.span);
        let enums_gone: Vec<usize> = starts.map(|span| span.range().start).collect();
        let share = Share {
            messages: (messages.len() - messages_gone.len(), messages.len()),
            enums: (enums.len() - enums_gone.len(), enums.len()),
        };
        let starts: BTreeSet<usize> = messages_gone.into_iter().chain(enums_gone).collect();
        (!starts.is_empty()).then_some(LeftOut { starts, share })
    }

    /// The tree without what is left out.
    fn kept(&self, left_out: Option<&LeftOut>) -> Element<'t> {
        let mut root = self.root.clone();
        if let Some(LeftOut { starts, .. }) = left_out {
            for list in &mut root.children {
                list.children.retain(|child| !starts.contains(&place(self.text, child.outer).start));
            }
        }
        root
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
