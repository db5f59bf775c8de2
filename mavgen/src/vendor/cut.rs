//! Leaving elements out of a text as if they had never stood there.
//!
//! With an element go the comments right above it, up to a blank line or another element, and the one behind it on its line:
//! they would say of the next element what is true of this one. Other comments stay. Of the blanks before and behind what
//! goes, one side stays, so that lines, indentation and the blank lines between groups are those of the neighbours.

use std::collections::BTreeSet;
use std::ops::Range;

use super::tree::{Element, place};

/// The places of a text to leave out, in their order, so that the children of `parent` that start at `starts` are gone.
pub(super) fn places(text: &str, parent: &Element<'_>, starts: &BTreeSet<usize>) -> Vec<Range<usize>> {
    let content = place(text, parent.inner);
    let mut pieces = pieces(text, parent, &content, starts);
    follow_before(&mut pieces);
    follow_after(&mut pieces);
    let runs = pieces.chunk_by(|one, next| one.goes == next.goes && is_blank(one.after));
    runs.filter_map(|run| run.first().zip(run.last()))
        .filter(|(first, _)| first.goes)
        .map(|(first, last)| with_blanks(first, last, &content))
        .collect()
}

/// A child or a comment.
struct Piece<'t> {
    place: Range<usize>,
    is_element: bool,
    goes: bool,
    /// Whether it is a comment behind something, on the same line.
    trails: bool,
    /// The text back to the piece before, or to the tag of the parent.
    before: &'t str,
    /// The text up to the next piece, or to the tag of the parent.
    after: &'t str,
}

fn pieces<'t>(text: &'t str, parent: &Element<'t>, content: &Range<usize>, starts: &BTreeSet<usize>) -> Vec<Piece<'t>> {
    let piece = |part: &'t str, is_element: bool| {
        let place = place(text, part);
        let goes = is_element && starts.contains(&place.start);
        Piece { place, is_element, goes, trails: false, before: "", after: "" }
    };
    let mut pieces = Vec::new();
    for child in &parent.children {
        pieces.extend(child.above.iter().map(|comment| piece(comment, false)));
        pieces.push(piece(child.outer, true));
    }
    pieces.extend(parent.below.iter().map(|comment| piece(comment, false)));
    let mut end = content.start;
    for piece in &mut pieces {
        piece.before = text.get(end..piece.place.start).unwrap_or_default();
        end = piece.place.end;
    }
    let mut start = content.end;
    for piece in pieces.iter_mut().rev() {
        piece.after = text.get(piece.place.end..start).unwrap_or_default();
        start = piece.place.start;
    }
    pieces
}

/// Comments behind an element on its line go with it; those behind the tag of the parent stay.
fn follow_before(pieces: &mut [Piece<'_>]) {
    let mut element = Some(false);
    for piece in pieces {
        if piece.is_element {
            element = Some(piece.goes);
            continue;
        }
        let ends_line = lines(piece.before) == 0 && is_blank(piece.before) && lines(piece.after) > 0;
        if let (Some(goes), true) = (element.take(), ends_line) {
            (piece.goes, piece.trails) = (goes, true);
        }
    }
}

/// Other comments go with the next element, unless a blank line or text is between them.
fn follow_after(pieces: &mut [Piece<'_>]) {
    let mut element = None;
    for piece in pieces.iter_mut().rev() {
        if piece.is_element {
            element = Some(piece.goes);
            continue;
        }
        element = element.filter(|_| !piece.trails && lines(piece.after) < 2 && is_blank(piece.after));
        piece.goes |= element.unwrap_or_default();
    }
}

/// The place from one piece to another, with the blanks on one side: of those between neighbours, the more lines stay.
fn with_blanks(first: &Piece<'_>, last: &Piece<'_>, content: &Range<usize>) -> Range<usize> {
    let (start, end) = (first.place.start, last.place.end);
    if !is_blank(first.before) || !is_blank(last.after) {
        return start..end;
    }
    let (outer_start, outer_end) = (start - first.before.len(), end + last.after.len());
    let (before, after) = (lines(first.before), lines(last.after));
    let keeps_after =
        outer_end == content.end || if outer_start == content.start { after < before } else { after >= before };
    if keeps_after { outer_start..end } else { start..outer_end }
}

fn is_blank(text: &str) -> bool {
    text.trim().is_empty()
}

fn lines(blanks: &str) -> usize {
    blanks.matches('\n').count()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The text without the elements `<x…/>` of its root.
    fn without_x(text: &str) -> String {
        let root = Element::root(text).unwrap();
        let gone = root.children.iter().filter(|child| child.name == "x");
        let starts = gone.map(|child| place(text, child.outer).start).collect();
        let mut left = text.to_owned();
        places(text, &root, &starts).into_iter().rev().for_each(|place| left.replace_range(place, ""));
        left
    }

    #[test]
    fn lines_and_groups_are_those_of_the_neighbours() {
        for (text, left) in [
            ("<m>\n  <x/>\n  <a/>\n</m>", "<m>\n  <a/>\n</m>"),
            ("<m>\n  <a/>\n  <x>\n    <b/>\n  </x>\n</m>", "<m>\n  <a/>\n</m>"),
            ("<m>\n  <x/>\n  <x/>\n</m>", "<m>\n</m>"),
            ("<m>\r\n  <a/>\r\n  <x/>\r\n  <b/>\r\n</m>", "<m>\r\n  <a/>\r\n  <b/>\r\n</m>"),
            ("<m>\n  <a/>\n\n  <x/>\n\n  <b/>\n</m>", "<m>\n  <a/>\n\n  <b/>\n</m>"),
            ("<m>\n  <a/>\n\n  <x/>\n  <b/>\n</m>", "<m>\n  <a/>\n\n  <b/>\n</m>"),
            ("<m>\n  <a/>\n  <x/>\n\n  <b/>\n</m>", "<m>\n  <a/>\n\n  <b/>\n</m>"),
            ("<m>\n\n  <x/>\n  <a/>\n\n  <x/>\n</m>", "<m>\n  <a/>\n</m>"),
            ("<m><x/><a/><x/></m>", "<m><a/></m>"),
            ("<m><x/></m>", "<m></m>"),
            ("<m>\n  <a/>\n      <x/>\n\t<b/>\n</m>", "<m>\n  <a/>\n\t<b/>\n</m>"),
            ("<m>\n  stray <x/> text\n</m>", "<m>\n  stray  text\n</m>"),
        ] {
            assert_eq!(without_x(text), left, "{text}");
        }
    }

    #[test]
    fn comments_go_with_what_they_are_about() {
        for (text, left) in [
            ("<m>\n  <!-- 1 -->\n  <!-- 2 -->\n  <x/>\n  <a/>\n</m>", "<m>\n  <a/>\n</m>"),
            ("<m>\n  <x/> <!-- of it -->\n  <a/> <!-- of a -->\n  <x/>\n</m>", "<m>\n  <a/> <!-- of a -->\n</m>"),
            ("<m>\n  <x/>\n  <!-- of a -->\n  <a/>\n</m>", "<m>\n  <!-- of a -->\n  <a/>\n</m>"),
            ("<m>\n  <!-- group -->\n\n  <x/>\n  <a/>\n</m>", "<m>\n  <!-- group -->\n\n  <a/>\n</m>"),
            ("<m> <!-- of m -->\n  <x/>\n  <a/>\n</m>", "<m> <!-- of m -->\n  <a/>\n</m>"),
            ("<m>\n  <x/>\n  <!-- the end -->\n</m>", "<m>\n  <!-- the end -->\n</m>"),
            ("<m><!-- 1 --><x/><!-- 2 --><a/></m>", "<m><!-- 2 --><a/></m>"),
            ("<m>\n  <a/> <!-- of a -->\n  <!-- of x -->\n  <x/>\n</m>", "<m>\n  <a/> <!-- of a -->\n</m>"),
        ] {
            assert_eq!(without_x(text), left, "{text}");
        }
    }
}
