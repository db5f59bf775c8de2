//! Definitions that were made to do harm, or are only half there: they end soon and with an error.
//!
//! Nothing is timed. Without the bounds that are tested here, these tests would not end, or not before memory does.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use std::fs;
use std::path::{Path, PathBuf};

use mavgen::Resolved;
use mavgen::diag::{Code, Diagnostics};
use mavgen::read::{load, read};
use mavgen::source::Sources;

/// The problems of a file, and all paths that were looked at.
fn problems(top: &Path) -> (Diagnostics, Vec<PathBuf>) {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let loaded = load(top, &[], &[], &mut sources, &mut diagnostics);
    match Resolved::of(loaded, sources, diagnostics) {
        Ok(resolved) => (resolved.diagnostics, resolved.watched),
        Err(problems) => {
            assert!(problems.diagnostics.has_errors());
            (problems.diagnostics, problems.watched)
        }
    }
}

/// The problems of a text, as `M304`, each once in a row.
fn codes(text: &str) -> Vec<Code> {
    let folder = tempfile::tempdir().unwrap();
    let top = folder.path().join("a.xml");
    fs::write(&top, text).unwrap();
    let (diagnostics, watched) = problems(&top);
    assert_eq!(watched.first(), Some(&top));
    let mut codes: Vec<Code> = diagnostics.iter().map(|problem| problem.code).collect();
    codes.dedup();
    codes
}

/// A definition with these messages.
fn messages(content: &str) -> String {
    format!("<mavlink><messages>{content}</messages></mavlink>")
}

#[test]
fn a_hundred_megabytes_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let top = folder.path().join("a.xml");
    // A hole: the length counts, and it is not even read to the end.
    fs::File::create(&top).unwrap().set_len(100 << 20).unwrap();
    let (diagnostics, _) = problems(&top);
    assert_eq!(diagnostics.iter().map(|problem| problem.code).collect::<Vec<_>>(), [Code::TooLarge]);
}

#[test]
fn ten_thousand_levels_are_refused() {
    let deep = |name: &str| format!("<{name}>").repeat(10_000) + &format!("</{name}>").repeat(10_000);
    assert_eq!(codes(&messages(&deep("message"))), [Code::MissingAttribute, Code::UnknownElement, Code::TooLarge]);
    assert_eq!(codes(&messages(&deep("a"))), [Code::UnknownElement, Code::TooLarge]);
    assert_eq!(codes(&deep("mavlink")), [Code::UnknownElement, Code::TooLarge]);
    assert_eq!(codes(&messages(&"<message id='1' name='A'>".repeat(10_000))), [Code::UnknownElement, Code::TooLarge]);
}

#[test]
fn entities_are_not_expanded() {
    let bomb = "<!DOCTYPE mavlink [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;'>\
                <!ENTITY c '&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;'>]>";
    assert_eq!(codes(&format!("{bomb}<mavlink><description>&c;</description></mavlink>")), [Code::DocumentType]);
    assert_eq!(
        codes(&messages("<message id='1' name='A'><description>&c;</description></message>")),
        [Code::UnknownEntity]
    );
}

#[test]
fn external_entities_are_not_looked_for() {
    let folder = tempfile::tempdir().unwrap();
    let (top, secret) = (folder.path().join("a.xml"), folder.path().join("secret.xml"));
    fs::write(&secret, "<mavlink/>").unwrap();
    for declaration in ["SYSTEM 'secret.xml'", "PUBLIC 'x' 'secret.xml'", "[<!ENTITY s SYSTEM 'secret.xml'>]"] {
        fs::write(&top, format!("<!DOCTYPE mavlink {declaration}><mavlink>&s;</mavlink>")).unwrap();
        let (diagnostics, watched) = problems(&top);
        assert_eq!(diagnostics.iter().map(|problem| problem.code).collect::<Vec<_>>(), [Code::DocumentType]);
        assert_eq!(watched, [top.as_path()]);
    }
}

/// The list is bounded, and the note at its end counts the rest.
#[test]
fn a_hundred_thousand_mistakes_end() {
    for (text, code) in [
        (
            messages(&"<message id='-1' name='A'><field type='uint8_t' name='a'/></message>".repeat(10_000)),
            Code::MessageId,
        ),
        (messages(&"<message id='1' name='A' colour='red'/>".repeat(10_000)), Code::UnknownAttribute),
        (messages(&"<feild/>".repeat(20_000)), Code::UnknownElement),
        (
            messages(&format!(
                "<message id='1' name='A'>{}</message>",
                "<field type='uint9_t' name='a'/>".repeat(100_000)
            )),
            Code::UnknownType,
        ),
        (
            messages(&format!(
                "<message id='1' name='A'>{}</message>",
                "<field type='uint8_t' name='a' enum='B'/>".repeat(20_000)
            )),
            Code::UnknownEnum,
        ),
        (
            format!("<mavlink><enums><enum name='A'>{}</enum></enums></mavlink>", "<entry name='A'/>".repeat(20_000)),
            Code::DuplicateEntry,
        ),
        (format!("<mavlink>{}</mavlink>", "<include>b.xml</include>".repeat(20_000)), Code::MissingInclude),
        (format!("<mavlink>{}</mavlink>", "<include>a.xml</include>".repeat(20_000)), Code::IncludeCycle),
    ] {
        let codes = codes(&text);
        assert!(codes.contains(&code), "{code}: {codes:?}");
        assert_eq!(codes.last(), Some(&Code::NotListed), "{code}");
    }
}

/// Each file is cut at many places: before a tag, inside one, in a text, in a comment.
#[test]
fn a_truncated_file_is_an_error() {
    for name in ["autoquad.xml", "common.xml", "minimal.xml", "standard.xml"] {
        let text = fs::read_to_string(Path::new("../xml").join(name)).unwrap();
        let whole = text.trim_end();
        let step = (whole.len() / 80).max(1) | 1;
        for cut in (0..whole.len()).step_by(step).filter(|&cut| whole.is_char_boundary(cut)) {
            let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
            read(sources.add(name, whole.get(..cut).unwrap()), &sources, &mut diagnostics);
            assert!(diagnostics.has_errors(), "{name} cut at byte {cut}");
        }
    }
}
