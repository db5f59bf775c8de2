//! A dialect file without its prose, laid out for people: two spaces a level, one element a line.

use super::prose::{Key, Keys, Words};
use super::tree::Element;
use crate::read::grammar::{self, Filling, Times};

/// Gives the words about an element.
pub(super) type Describe<'a> = dyn FnMut(&str) -> Option<Words> + 'a;

/// The text of one file.
pub(super) struct Facts {
    /// The root element, with the comments before it.
    pub(super) text: String,
    /// Every element that should have a description, and whether it has one.
    pub(super) described: Vec<(Key, bool)>,
}

/// Writes down the facts of the file with this root element, with the words that `describe` has for them.
///
/// `includes` are the paths of its includes, in their order.
pub(super) fn write(root: &Element<'_>, includes: &[String], describe: &mut Describe<'_>) -> Facts {
    let facts = Facts { text: String::new(), described: Vec::new() };
    let mut writer = Writer { facts, keys: Keys::default(), includes: includes.iter(), describe };
    writer.element("", root, 0);
    writer.facts
}

/// The children that the grammar has; of messages, enums and entries the stage of life first. Descriptions are no facts.
fn children<'e, 't>(element: &'e Element<'t>) -> impl Iterator<Item = &'e Element<'t>> {
    let known = grammar::Element::named(element.name).filter(|_| element.filling() == Filling::Elements);
    let is_known = |child: &&Element<'_>| known.is_some_and(|known| known.child(child.name).is_some());
    let mut children: Vec<_> =
        element.children.iter().filter(|child| is_known(child) && child.name != DESCRIPTION).collect();
    children.sort_by_key(|child| !is_stage(child));
    children.into_iter()
}

const DESCRIPTION: &str = "description";

fn is_stage(element: &Element<'_>) -> bool {
    matches!(element.name, "wip" | "superseded" | "deprecated")
}

/// Whether the grammar has a description in an element, and whether it demands one, be it empty.
fn description(element: &Element<'_>) -> Option<Times> {
    let known = grammar::Element::named(element.name).filter(|_| element.filling() == Filling::Elements)?;
    known.child(DESCRIPTION).map(|child| child.times)
}

struct Writer<'a, 'd> {
    facts: Facts,
    keys: Keys,
    includes: std::slice::Iter<'a, String>,
    describe: &'a mut Describe<'d>,
}

impl Writer<'_, '_> {
    fn element(&mut self, parent: &str, element: &Element<'_>, depth: usize) {
        let (key, base) = self.keys.key(parent, element);
        let words = (self.describe)(&key).unwrap_or_default();
        words.above.iter().for_each(|comment| self.line(depth, comment));
        let tag = format!("{}{}", element.name, attributes(element));
        match element.filling() {
            Filling::Elements => self.container(element, depth, &tag, (key, &base, &words.below)),
            Filling::Fact if element.name == "include" => {
                let path = self.includes.next().cloned().unwrap_or_default();
                self.leaf(depth, element.name, &tag, &escaped(&path));
            }
            Filling::Fact => self.leaf(depth, element.name, &tag, &fact(element)),
            Filling::Prose => {
                self.leaf(depth, element.name, &tag, &words.text);
                self.note(element, key, &words.text);
            }
            Filling::Nothing => self.leaf(depth, element.name, &tag, ""),
        }
    }

    fn container(
        &mut self,
        element: &Element<'_>,
        depth: usize,
        tag: &str,
        (key, base, below): (Key, &str, &[String]),
    ) {
        let start = self.facts.text.len();
        self.line(depth, &format!("<{tag}>"));
        let empty = self.facts.text.len();
        let mut words = description(element).map(|_| {
            let words = (self.describe)(&format!("{key} description")).unwrap_or_default();
            self.note(element, key, &words.text);
            words
        });
        for child in children(element) {
            if !is_stage(child) {
                self.description(element, depth + 1, words.take());
            }
            self.element(base, child, depth + 1);
        }
        self.description(element, depth + 1, words);
        below.iter().for_each(|comment| self.line(depth + 1, comment));
        if self.facts.text.len() == empty {
            self.facts.text.truncate(start);
            self.line(depth, &format!("<{tag}/>"));
        } else {
            self.line(depth, &format!("</{}>", element.name));
        }
    }

    fn description(&mut self, parent: &Element<'_>, depth: usize, words: Option<Words>) {
        let Some(words) = words else { return };
        words.above.iter().for_each(|comment| self.line(depth, comment));
        if !words.text.trim().is_empty() || description(parent) == Some(Times::Once) {
            self.leaf(depth, DESCRIPTION, DESCRIPTION, &words.text);
        }
    }

    /// Notes whether an element that should have a description has one.
    fn note(&mut self, element: &Element<'_>, key: Key, text: &str) {
        // Those that people look up.
        if matches!(element.name, "enum" | "entry" | "param" | "message" | "field") {
            self.facts.described.push((key, !text.trim().is_empty()));
        }
    }

    fn leaf(&mut self, depth: usize, name: &str, tag: &str, content: &str) {
        if content.trim().is_empty() {
            self.line(depth, &format!("<{tag}/>"));
        } else {
            self.line(depth, &format!("<{tag}>{content}</{name}>"));
        }
    }

    fn line(&mut self, depth: usize, line: &str) {
        let text = &mut self.facts.text;
        text.extend(std::iter::repeat_n("  ", depth));
        text.push_str(line);
        text.push('\n');
    }
}

/// The attributes that the grammar has; at the root also those that tell an editor where the grammar is.
fn attributes(element: &Element<'_>) -> String {
    let known = grammar::Element::named(element.name);
    let is_known = |name: &str| known.is_some_and(|known| known.attribute(name).is_some());
    let of_xml = |name: &str| element.name == "mavlink" && (name == "xmlns" || name.contains(':'));
    let kept = element.attributes.iter().filter(|(name, _)| is_known(name) || of_xml(name));
    kept.map(|(name, value)| {
        let value = value.replace("\r\n", " ").replace(['\r', '\n', '\t'], " ");
        let quote = if value.contains('"') { '\'' } else { '"' };
        format!(" {name}={quote}{value}{quote}")
    })
    .collect()
}

/// A number or a name as it stands in its element, without comments.
fn fact(element: &Element<'_>) -> String {
    let fact = element.below.iter().fold(element.inner.to_owned(), |fact, comment| fact.replace(comment, ""));
    fact.trim().to_owned()
}

/// A text with the characters that XML needs for itself written as references.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
