//! A dialect's XML as a tree that borrows its text: what has to be written down again, spelled as it is.
//!
//! The reader has read the sources before. Copies that are in the folder already can hold anything: what is not well-formed, or
//! nested deeper than the reader allows, is no tree.

use std::borrow::Cow;
use std::ops::Range;

use quick_xml::events::attributes::Attributes;
use quick_xml::events::{BytesStart, Event};
use quick_xml::reader::Reader;

use crate::read::MAX_DEPTH;
use crate::read::grammar::{self, Filling};

/// An element.
#[derive(Clone)]
pub(super) struct Element<'t> {
    pub(super) name: &'t str,
    /// All of it, with its tags.
    pub(super) outer: &'t str,
    /// Name and value of each attribute, references not expanded.
    pub(super) attributes: Vec<(&'t str, &'t str)>,
    /// All that stands between its tags.
    pub(super) inner: &'t str,
    pub(super) children: Vec<Element<'t>>,
    /// The comments before its start tag, back to the tag before.
    pub(super) above: Vec<&'t str>,
    /// The comments before its end tag, back to the tag before; of the root, those after it as well.
    pub(super) below: Vec<&'t str>,
}

impl<'t> Element<'t> {
    /// The root element of a text, if it has one.
    pub(super) fn root(text: &'t str) -> Option<Self> {
        Builder { text, reader: Reader::from_str(text), comments: Vec::new(), open: Vec::new() }.root()
    }

    /// What stands in it.
    pub(super) fn filling(&self) -> Filling {
        grammar::filling(self.name)
    }

    /// An attribute.
    pub(super) fn attribute(&self, name: &str) -> Option<&'t str> {
        self.attributes.iter().find(|(found, _)| *found == name).map(|(_, value)| *value)
    }
}

/// Where a part of a text stands in it. Parts borrow from the text, so this is the distance of two addresses.
pub(super) fn place(text: &str, part: &str) -> Range<usize> {
    let start = (part.as_ptr() as usize).wrapping_sub(text.as_ptr() as usize);
    start..start + part.len()
}

struct Builder<'t> {
    text: &'t str,
    reader: Reader<&'t [u8]>,
    /// The comments since the last tag.
    comments: Vec<&'t str>,
    /// The elements that are not closed yet, and where they and their content start.
    open: Vec<(Element<'t>, usize, usize)>,
}

impl<'t> Builder<'t> {
    fn root(mut self) -> Option<Element<'t>> {
        self.reader.config_mut().expand_empty_elements = true;
        let mut root: Option<Element<'t>> = None;
        loop {
            let start = self.position();
            match self.reader.read_event().ok()? {
                Event::Start(_) if self.open.len() >= MAX_DEPTH => return None,
                Event::Start(tag) => {
                    let element = self.element(&tag, start)?;
                    let content = self.position();
                    self.open.push((element, start, content));
                }
                Event::End(_) => {
                    let (mut element, outer, content) = self.open.pop()?;
                    element.outer = self.text.get(outer..self.position())?;
                    element.inner = self.text.get(content..start).unwrap_or_default();
                    element.below = std::mem::take(&mut self.comments);
                    match self.open.last_mut() {
                        Some((parent, ..)) => parent.children.push(element),
                        None => root = Some(element),
                    }
                }
                Event::Comment(_) => {
                    let comment = self.text.get(start..self.position())?;
                    self.comments.push(comment);
                }
                Event::Eof => {
                    let mut root = root.filter(|_| self.open.is_empty())?;
                    root.below.append(&mut self.comments);
                    return Some(root);
                }
                _ => {}
            }
        }
    }

    fn position(&self) -> usize {
        usize::try_from(self.reader.buffer_position()).unwrap_or(usize::MAX)
    }

    /// The element whose start tag begins at `start`.
    fn element(&mut self, tag: &BytesStart<'_>, start: usize) -> Option<Element<'t>> {
        let length = tag.name().as_ref().len();
        let inner = self.text.get(start + 1..self.position().checked_sub(1)?)?;
        let inner = inner.strip_suffix('/').unwrap_or(inner);
        let mut attributes = Vec::new();
        for attribute in Attributes::new(inner, length).with_checks(false) {
            let attribute = attribute.ok()?;
            let Cow::Borrowed(value) = attribute.value else { return None };
            attributes.push((attribute.key.0, value));
        }
        let above = std::mem::take(&mut self.comments);
        let (children, below) = (Vec::new(), Vec::new());
        Some(Element { name: inner.get(..length)?, outer: "", attributes, inner: "", children, above, below })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spelling_and_comments_are_kept() {
        let text = "<?xml version='1.0'?>\n<!-- head --><a x = 'a&amp;b'\n y=\"'\"><!-- b --><b/>t<![CDATA[<c/>]]><!-- end --></a><!-- foot -->";
        let root = Element::root(text).unwrap();
        assert_eq!((root.name, &root.attributes[..]), ("a", &[("x", "a&amp;b"), ("y", "'")][..]));
        assert_eq!(
            (&root.above[..], &root.below[..]),
            (&["<!-- head -->"][..], &["<!-- end -->", "<!-- foot -->"][..])
        );
        assert_eq!(root.inner, "<!-- b --><b/>t<![CDATA[<c/>]]><!-- end -->");
        assert_eq!((root.children[0].outer, &text[place(text, root.outer)]), ("<b/>", root.outer));
        assert!(root.outer.starts_with("<a x") && root.outer.ends_with("--></a>"), "{}", root.outer);
        assert_eq!((root.children[0].name, &root.children[0].above[..]), ("b", &["<!-- b -->"][..]));
    }

    #[test]
    fn what_is_no_xml_is_no_tree() {
        for text in ["", "<a>", "<a", "</a>", "<a b='>"] {
            assert!(Element::root(text).is_none(), "{text}");
        }
        let nested = |depth: usize| "<a>".repeat(depth) + &"</a>".repeat(depth);
        assert!(Element::root(&nested(MAX_DEPTH)).is_some() && Element::root(&nested(100_000)).is_none());
    }
}
