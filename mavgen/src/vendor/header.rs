//! The comment at the head of a vendored file: where its text comes from, and a digest of the copy. By it a file is known as
//! one of ours, and an edit of it is noticed.

use std::fmt;

use sha2::{Digest, Sha256};

use super::digest;
use crate::provenance::{self, MARK};

pub(super) use crate::provenance::split_declaration;

/// What of its source a file is: all of it.
pub(super) const UNCHANGED: &str = "unchanged below";
/// All of it, but its includes had to be spelled anew.
pub(super) const OTHER_INCLUDES: &str = "unchanged below but for its includes";
/// The facts, with descriptions that are not the source's.
pub(super) const DESCRIBED_HERE: &str = "its facts, with descriptions written here";
/// The facts alone, unless somebody wrote descriptions later.
pub(super) const NOT_DESCRIBED: &str = "its facts, without its descriptions";
/// What stands before the digest.
const DIGEST: &str = "; to notice edits: ";

/// How many there are, and of how many in the source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Share {
    pub(super) messages: (usize, usize),
    pub(super) enums: (usize, usize),
}

/// The header of a file that was made of the text of the file `name`: its kind is [`UNCHANGED`] and so on, its digest by
/// [`digest::of_text`] or [`digest::of_facts`].
pub(super) fn header(name: &str, text: &str, kind: &str, share: Option<Share>, digest: &str) -> String {
    let share = share.map(|share| format!("a part, {share}: ")).unwrap_or_default();
    let (version, source) = (env!("CARGO_PKG_VERSION"), digest::hexadecimal(&Sha256::digest(text)));
    format!("{MARK}{version} from {}, SHA-256 {source}: {share}{kind}{DIGEST}{digest}. -->", in_comment(name))
}

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [(self.messages, "messages"), (self.enums, "enums")];
        for (index, ((kept, all), what)) in counts.into_iter().filter(|((_, all), _)| *all > 0).enumerate() {
            let gap = if index == 0 { "" } else { " and " };
            write!(f, "{gap}{kept} of its {all} {what}")?;
        }
        Ok(())
    }
}

/// Whether a comment is a header of ours.
pub(super) fn is_mark(comment: &str) -> bool {
    comment.starts_with(MARK)
}

/// A file of ours.
pub(super) struct Ours<'t> {
    /// Whether it has the facts alone of its source, and maybe descriptions that people wrote for it.
    pub(super) facts: bool,
    digest: Option<&'t str>,
    text: &'t str,
    declaration: &'t str,
    below: &'t str,
}

/// The file with this text, if it is one of ours; its start is enough to know.
pub(super) fn read(text: &str) -> Option<Ours<'_>> {
    let text = text.trim_start_matches('\u{feff}');
    let (declaration, comment) = provenance::split(text)?;
    let (comment, below) = comment.split_once("-->").unwrap_or((comment, ""));
    let facts = comment.contains(DESCRIBED_HERE) || comment.contains(NOT_DESCRIBED);
    let digest = comment.rsplit_once(DIGEST).map(|(_, digest)| digest.trim_end().trim_end_matches('.'));
    Some(Ours { facts, digest, text, declaration, below })
}

impl Ours<'_> {
    /// Whether it is as it was written; of facts, but for what people may write there: descriptions and comments.
    pub(super) fn is_as_written(&self) -> bool {
        let digest = match self.facts {
            true => digest::of_facts(self.text),
            false => Some(digest::of_text(self.declaration, self.below)),
        };
        self.digest.is_some() && self.digest == digest.as_deref()
    }
}

/// A name as a comment can hold it: no `--`, and nothing that XML does not allow.
fn in_comment(name: &str) -> String {
    let name = name.replace(|character: char| character.is_control(), "?");
    name.replace("--", "- -").replace("--", "- -")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(name: &str, text: &str, kind: &'static str) -> String {
        header(name, text, kind, None, "0123")
    }

    #[test]
    fn ours_are_known() {
        let facts = |text: &str| read(text).map(|ours| ours.facts);
        let ours = plain("a.xml", "text", DESCRIBED_HERE);
        assert_eq!(facts(&format!("<?xml version='1.0'?>\r\n{ours}<mavlink/>")), Some(true));
        assert_eq!(facts(&plain("a.xml", "text", OTHER_INCLUDES)), Some(false));
        for foreign in
            ["", "<mavlink/>", "<?xml version='1.0'?><!-- mine -->", "<mavlink><!-- Vendored by mavgen 1 --></mavlink>"]
        {
            assert_eq!(facts(foreign), None, "{foreign}");
        }
    }

    #[test]
    fn a_name_cannot_end_the_comment() {
        for name in ["a--b.xml", "a---->.xml", "-->", "a\u{1}\n.xml"] {
            let header = plain(name, "", NOT_DESCRIBED);
            let inner = header.strip_prefix("<!--").and_then(|rest| rest.strip_suffix("-->")).unwrap();
            assert!(!inner.contains("--") && !inner.ends_with('-') && !inner.contains(char::is_control), "{header}");
        }
    }

    /// The digest of the source is that of `sha256sum`, so that it can be compared with upstream's file.
    #[test]
    fn the_digest_is_sha_256() {
        let abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert!(plain("a.xml", "abc", NOT_DESCRIBED).contains(abc));
    }

    #[test]
    fn a_part_says_so() {
        let share = Share { messages: (3, 238), enums: (0, 7) };
        let header = header("a.xml", "", UNCHANGED, Some(share), "");
        assert!(header.contains(": a part, 3 of its 238 messages and 0 of its 7 enums: unchanged below; "), "{header}");
        let none = Share { messages: (0, 0), enums: (1, 2) };
        assert_eq!(none.to_string(), "1 of its 2 enums");
    }

    #[test]
    fn an_edited_file_and_an_edited_header_are_noticed() {
        let digest = digest::of_text("", "<mavlink/>\n");
        let header = header("a.xml", "", UNCHANGED, None, &digest);
        let as_written = |text: &str| read(text).unwrap().is_as_written();
        let text = format!("{header}\n<mavlink/>\n");
        assert!(as_written(&text) && as_written(&format!("\u{feff}{}", text.replace('\n', "\r\n"))));
        assert!(!as_written(&text.replace("<mavlink/>", "<mavlink />")));
        assert!(!as_written(&text.replace(DIGEST, ": ")));
    }
}
