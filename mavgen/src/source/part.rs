//! Parts of a text that know where they stand.

use std::ops::Range;

#[cfg(feature = "uorb")]
use super::Spanned;
use super::{FileId, Span};

/// A part of a source's text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part<'t> {
    pub(crate) file: FileId,
    pub(crate) text: &'t str,
    /// Where it starts in the file.
    pub(crate) start: usize,
}

impl<'t> Part<'t> {
    /// All of the text of a file.
    pub(crate) fn whole(file: FileId, text: &'t str) -> Self {
        Self { file, text, start: 0 }
    }

    pub(crate) fn span(self) -> Span {
        self.span_of(0..self.text.len())
    }

    /// The place of these bytes of it.
    pub(crate) fn span_of(self, range: Range<usize>) -> Span {
        Span::new(self.file, self.start + range.start..self.start + range.end)
    }

    /// These bytes of it; no text if they are not whole characters of it.
    pub(crate) fn get(self, range: Range<usize>) -> Self {
        Self { text: self.text.get(range.clone()).unwrap_or_default(), start: self.start + range.start, ..self }
    }

    /// What follows this many bytes.
    pub(crate) fn after(self, bytes: usize) -> Self {
        self.get(bytes..self.text.len())
    }

    /// The part with this text, which was cut from the text of this one: so their addresses tell where it stands.
    pub(crate) fn with(self, text: &'t str) -> Self {
        let distance = text.as_ptr().addr().wrapping_sub(self.text.as_ptr().addr());
        Self { text, start: self.start.wrapping_add(distance), ..self }
    }

    /// Without the blanks at both ends.
    pub(crate) fn trimmed(self) -> Self {
        self.with(self.text.trim_start().trim_end())
    }

    /// Up to the end of its first line: a caret under many lines says no more than one under the first.
    pub(crate) fn first_line(self) -> Self {
        self.with(self.text.lines().next().unwrap_or(self.text))
    }
}

#[cfg(feature = "uorb")]
impl<'t> Part<'t> {
    /// What stands before and behind the first of these characters.
    pub(crate) fn split_once(self, is_stop: impl Fn(char) -> bool) -> Option<(Self, Self)> {
        let (before, behind) = self.text.split_once(is_stop)?;
        Some((self.with(before), self.with(behind)))
    }

    pub(crate) fn words(self) -> impl Iterator<Item = Self> {
        self.text.split_whitespace().map(move |word| self.with(word))
    }

    pub(crate) fn to_spanned(self) -> Spanned<String> {
        Spanned::new(self.text.to_owned(), self.span())
    }
}

#[cfg(feature = "uorb")]
impl Spanned<String> {
    /// The text where it stands, if that is how it is written.
    pub(crate) fn part(&self) -> Part<'_> {
        Part { file: self.span.file, text: &self.value, start: self.span.range().start }
    }
}
