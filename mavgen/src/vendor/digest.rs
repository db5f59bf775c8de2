//! A number by which an edit of a copy is noticed.
//!
//! It stands in the header of a copy, and is not that of the source: a copy can have other includes, a part of the messages, or
//! no descriptions. Line ends do not count, so that a checkout may convert them, and neither does a byte order mark. Whoever
//! changes what is counted makes every copy that there is look as if it had been edited.

use std::ops::Range;

use sha2::{Digest, Sha256};

use super::tree::{Element, place};
use crate::read::grammar::Filling;

/// So many bytes are enough to tell an edit; nobody is meant to be deceived.
const LENGTH: usize = 8;

/// Of a text without the header, before and after which the two parts stand.
pub(super) fn of_text(before: &str, after: &str) -> String {
    let mut sum = Sum(Sha256::new());
    sum.add(before.trim_end());
    sum.add(after.trim_start());
    sum.hexadecimal()
}

/// Of all that is no description, comment or layout: whatever [`facts::write`](super::facts::write) would not find again in
/// descriptions, be it something that the grammar does not have. Nothing if the text is no XML.
pub(super) fn of_facts(text: &str) -> Option<String> {
    let root = Element::root(text)?;
    let mut sum = Sum(Sha256::new());
    let comments = root.above.iter().chain(&root.below).copied();
    sum.add(&rest(text, text, comments.chain([root.outer])));
    sum.element(text, &root);
    Some(sum.hexadecimal())
}

struct Sum(Sha256);

impl Sum {
    /// Adds a piece, told apart from the next.
    fn add(&mut self, piece: &str) {
        self.0.update(piece.replace("\r\n", "\n"));
        self.0.update([0]);
    }

    fn element(&mut self, text: &str, element: &Element<'_>) {
        self.add(element.name);
        for (name, value) in &element.attributes {
            self.add(name);
            self.add(value);
        }
        match element.filling() {
            Filling::Prose => {}
            Filling::Fact | Filling::Nothing => self.add(element.inner.trim()),
            Filling::Elements => {
                let comments = element.children.iter().flat_map(|child| &child.above).chain(&element.below).copied();
                let children = element.children.iter().map(|child| child.outer);
                self.add(&rest(text, element.inner, comments.chain(children)));
                let facts = element.children.iter().filter(|child| child.name != "description");
                facts.for_each(|child| self.element(text, child));
            }
        }
        self.add("");
    }

    fn hexadecimal(self) -> String {
        hexadecimal(self.0.finalize().get(..LENGTH).unwrap_or_default())
    }
}

pub(super) fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// What of a part of a text stands outside of some pieces of it, without blanks.
fn rest<'t>(text: &'t str, part: &'t str, pieces: impl Iterator<Item = &'t str>) -> String {
    let Range { start: mut at, end } = place(text, part);
    // The comments of the root stand in it and behind it.
    let places = pieces.map(|piece| place(text, piece)).filter(|place| place.start < end);
    let mut places: Vec<Range<usize>> = places.chain(std::iter::once(end..end)).collect();
    places.sort_by_key(|place| place.start);
    let mut rest = String::new();
    for place in places {
        rest.extend(text.get(at..place.start).unwrap_or_default().split_whitespace());
        at = at.max(place.end);
    }
    rest
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "<?xml version='1.0'?>\n<!-- head -->\n<mavlink><version>3</version><messages>\n\
        <message id='1' name='A'><description>x</description><field type='uint8_t' name='a'/></message></messages></mavlink>";

    fn edited(old: &str, new: &str) -> Option<String> {
        assert!(TEXT.contains(old), "{old}");
        of_facts(&TEXT.replace(old, new))
    }

    #[test]
    fn descriptions_comments_and_layout_are_no_facts() {
        for (old, new) in [
            ("x</description>", "what <b>somebody</b> wrote<!-- here --></description>"),
            ("<description>x</description>", ""),
            ("name='a'/>", "name='a'>Said.</field>"),
            ("<field ", "<!-- of a -->\n    <field "),
            ("</mavlink>", "<!-- end --></mavlink>\n<!-- foot -->\n"),
            ("<!-- head -->", ""),
            ("name='a'", " name = \"a\" "),
            ("\n", "\r\n"),
        ] {
            assert_eq!(edited(old, new), of_facts(TEXT), "{new}");
        }
    }

    #[test]
    fn whatever_else_is_edited_counts() {
        for (old, new) in [
            ("id='1'", "id='2'"),
            ("id='1'", "id='1' note='mine'"),
            ("<field ", "<extensions/><field "),
            ("<field ", "mine <field "),
            ("<field ", "<mine/><field "),
            (">3<", "><!-- mine -->3<"),
            ("<mavlink>", "<?mine?><mavlink>"),
            ("<messages>", "<enums/><messages>"),
            ("</mavlink>", "</mavlink"),
        ] {
            assert_ne!(edited(old, new), of_facts(TEXT), "{new}");
        }
    }

    #[test]
    fn of_a_text_everything_counts_but_line_ends() {
        let (before, after) = ("<?xml version='1.0'?>", "<a>\n  <!-- b -->\n</a>\n");
        let digest = of_text(before, after);
        assert_eq!(of_text(&format!("{before}\r\n"), &format!("\r\n{}", after.replace('\n', "\r\n"))), digest);
        assert_ne!(of_text(before, &after.replace("  <", "   <")), digest);
        assert_ne!(of_text(before, after.trim_end()), digest);
        assert_ne!(of_text("", after), digest);
    }

    /// Copies carry these numbers: another way of counting would make all of them look edited.
    #[test]
    fn the_digests_are_those_of_earlier_versions() {
        assert_eq!(of_text("<?xml version='1.0'?>", "<a/>\n"), "8a3447a7d20d9d69");
        assert_eq!(of_facts(TEXT).unwrap(), "636c185971d9ef03");
    }
}
