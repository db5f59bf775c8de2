//! The comment at the head of a vendored file: where its text comes from. By it a file is known as one of ours.

use sha2::{Digest, Sha256};

/// How every header starts.
const MARK: &str = "<!-- Vendored by mavgen ";
/// What the header says where the descriptions are not the source's.
const DESCRIBED_HERE: &str = "its facts, with descriptions written here";
/// What the header says where there are no descriptions, unless somebody wrote some later.
const NOT_DESCRIBED: &str = "its facts, without its descriptions";

/// What of its source a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// All of it.
    Whole {
        /// Whether its includes had to be spelled anew.
        includes: bool,
    },
    /// The facts alone.
    Facts,
    /// The facts, with descriptions from elsewhere.
    Described,
}

/// The header of a file that was made of the text of the file `name`.
pub(super) fn header(name: &str, text: &str, kind: Kind) -> String {
    let what = match kind {
        Kind::Whole { includes: false } => "unchanged below",
        Kind::Whole { includes: true } => "unchanged below but for its includes",
        Kind::Facts => NOT_DESCRIBED,
        Kind::Described => DESCRIBED_HERE,
    };
    let (version, digest) = (env!("CARGO_PKG_VERSION"), hexadecimal(&Sha256::digest(text)));
    format!("{MARK}{version} from {}, SHA-256 {digest}: {what}. -->", in_comment(name))
}

/// Whether a comment is a header of ours.
pub(super) fn is_mark(comment: &str) -> bool {
    comment.starts_with(MARK)
}

/// Whether a file that starts so is one of ours; if so, whether what is said in it is not its source's.
pub(super) fn read(start: &str) -> Option<bool> {
    let start = start.trim_start_matches('\u{feff}');
    let rest = start.strip_prefix("<?xml").and_then(|rest| rest.split_once("?>")).map_or(start, |(_, rest)| rest);
    let comment = rest.trim_start().strip_prefix(MARK)?;
    let comment = comment.split_once("-->").map_or(comment, |(comment, _)| comment);
    Some(comment.contains(DESCRIBED_HERE) || comment.contains(NOT_DESCRIBED))
}

/// The declaration and what follows it, if a text begins with one.
pub(super) fn split_declaration(text: &str) -> (&str, &str) {
    let end = if text.starts_with("<?xml") { text.find("?>").map_or(0, |at| at + 2) } else { 0 };
    text.split_at_checked(end).unwrap_or(("", text))
}

/// A name as a comment can hold it: no `--`, and nothing that XML does not allow.
fn in_comment(name: &str) -> String {
    let name = name.replace(|character: char| character.is_control(), "?");
    name.replace("--", "- -").replace("--", "- -")
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ours_are_known() {
        let ours = header("a.xml", "text", Kind::Described);
        assert_eq!(read(&format!("<?xml version='1.0'?>\r\n{ours}<mavlink/>")), Some(true));
        assert_eq!(read(&header("a.xml", "text", Kind::Whole { includes: true })), Some(false));
        for foreign in
            ["", "<mavlink/>", "<?xml version='1.0'?><!-- mine -->", "<mavlink><!-- Vendored by mavgen 1 --></mavlink>"]
        {
            assert_eq!(read(foreign), None, "{foreign}");
        }
    }

    #[test]
    fn a_name_cannot_end_the_comment() {
        for name in ["a--b.xml", "a---->.xml", "-->", "a\u{1}\n.xml"] {
            let header = header(name, "", Kind::Facts);
            let inner = header.strip_prefix("<!--").and_then(|rest| rest.strip_suffix("-->")).unwrap();
            assert!(!inner.contains("--") && !inner.ends_with('-') && !inner.contains(char::is_control), "{header}");
        }
    }

    /// The digest is that of `sha256sum`, so that it can be compared with upstream's file.
    #[test]
    fn the_digest_is_sha_256() {
        let abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert!(header("a.xml", "abc", Kind::Facts).contains(abc));
    }
}
