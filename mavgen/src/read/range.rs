//! Ranges of bytes in a text, made smaller.

use std::ops::Range;

/// The part of `range` up to the end of its first line: a caret under many lines says no more than one under the first.
pub(super) fn first_line(text: &str, range: Range<usize>) -> Range<usize> {
    let line = text.get(range.clone()).and_then(|part| part.lines().next());
    range.start..line.map_or(range.end, |line| range.start + line.len())
}

/// `range` without the blanks at both ends.
pub(super) fn trimmed(text: &str, range: Range<usize>) -> Range<usize> {
    let part = text.get(range.clone()).unwrap_or_default();
    let start = range.start + (part.len() - part.trim_start().len());
    start..(start + part.trim().len())
}
