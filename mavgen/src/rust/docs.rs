//! Documentation as data; the words of the XML are made safe and wrapped where it is printed, by many threads.

use std::borrow::Cow;

/// The documentation of an item: paragraphs in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Docs<'d>(pub(crate) Vec<Paragraph<'d>>);

/// A part of a documentation. One that says nothing is left out.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Paragraph<'d> {
    /// What the XML says, and sentences of ours at the end of its first paragraph.
    Prose(Cow<'d, str>, Vec<String>),
    /// Lines of ours, as they are.
    Lines(Vec<String>),
    /// A list, of which items that say nothing are left out.
    List(Vec<ListItem<'d>>),
    /// A table with aligned columns.
    Table(Vec<&'d str>, Vec<Vec<Cell<'d>>>),
}

/// `- 1, Hold: time to stay. In s; at least 0.`
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ListItem<'d> {
    /// `1`
    pub(crate) head: String,
    /// `, Hold`; nothing if it has none.
    pub(crate) label: String,
    /// What the XML says.
    pub(crate) text: &'d str,
    /// What we say.
    pub(crate) sentences: Vec<String>,
    /// A sentence that stays on one line.
    pub(crate) link: Option<String>,
}

/// A cell of a table.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cell<'d> {
    /// Words of ours.
    Plain(String),
    /// The first sentence of what the XML says.
    FirstSentence(&'d str),
}

impl<'d> Docs<'d> {
    /// One line of ours.
    pub(crate) fn line(line: impl Into<String>) -> Self {
        Self(vec![Paragraph::line(line)])
    }

    /// With another paragraph at the end.
    pub(crate) fn then(mut self, paragraph: Paragraph<'d>) -> Self {
        self.0.push(paragraph);
        self
    }
}

impl<'d> Paragraph<'d> {
    /// One line of ours.
    pub(crate) fn line(line: impl Into<String>) -> Self {
        Self::Lines(vec![line.into()])
    }

    /// What the XML says, and sentences of ours.
    pub(crate) fn said(text: impl Into<Cow<'d, str>>, sentences: Vec<String>) -> Self {
        Self::Prose(text.into(), sentences)
    }

    /// What the XML says.
    pub(crate) fn prose(text: impl Into<Cow<'d, str>>) -> Self {
        Self::said(text, Vec::new())
    }
}
