//! `diff`: exit status, what it says, and to whom.

use std::fs;
use std::path::Path;
use std::process::Output;

use crate::{ACME, folder, mavgen, stderr, stdout};

/// A folder with `acme.xml` and a `new.xml`, which is made of it by these replacements.
fn states(edits: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = folder(ACME);
    let new = edits.iter().fold(ACME.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    fs::write(folder.path().join("new.xml"), new).unwrap();
    folder
}

fn diff(folder: &Path, arguments: &[&str]) -> Output {
    mavgen(folder, &[&["diff", "acme.xml", "new.xml"], arguments].concat())
}

const WIDER: (&str, &str) = ("uint16_t", "uint32_t");
const EXTENDED: (&str, &str) = ("    </message>", "    <extensions/><field type=\"uint8_t\" name=\"new\"/></message>");
const OTHER_UNITS: (&str, &str) = ("units=\"cm\"", "units=\"mm\"");

#[test]
fn the_same_is_0() {
    let folder = states(&[("What the sprayer does.", "Said otherwise.")]);
    for (option, said) in
        [("--all", "no difference\n"), ("--wire", "no difference on the wire\n"), ("--api", "no difference in Rust\n")]
    {
        let answer = diff(folder.path(), &[option]);
        assert_eq!((answer.status.code(), &*stdout(&answer), &*stderr(&answer)), (Some(0), said, ""));
    }
}

#[test]
fn broken_is_1_and_says_what_where() {
    let folder = states(&[("invalid=\"UINT16_MAX\"", "invalid=\"UINT32_MAX\""), WIDER, OTHER_UNITS]);
    let answer = diff(folder.path(), &[]);
    let said = "breaks the wire, 1 change:
  field SPRAYER.level is uint32_t, was uint16_t (crc_extra 188, was 38; 5 bytes, was 3)
    acme.xml:13:7 -> new.xml:13:7
breaks Rust code, 1 change:
  Sprayer.level is u32, was u16
    acme.xml:13:7 -> new.xml:13:7
neither on the wire nor in Rust, 2 changes (--all lists them)
";
    assert_eq!((answer.status.code(), &*stdout(&answer)), (Some(1), said));
    let all = diff(folder.path(), &["--all"]);
    let listed = "  field SPRAYER.level: units mm, was cm\n    acme.xml:13:7 -> new.xml:13:7\n";
    assert!(stdout(&all).contains(listed), "{}", stdout(&all));
}

/// An extension is compatible on the wire, and a new field of an exhaustive struct.
#[test]
fn what_is_asked_for_decides() {
    let folder = states(&[EXTENDED]);
    let status = |options: &[&str]| diff(folder.path(), options).status.code();
    assert_eq!((status(&["--wire"]), status(&["--api"]), status(&[])), (Some(0), Some(1), Some(1)));
    let wire = stdout(&diff(folder.path(), &["--wire"]));
    assert!(wire.starts_with("new on the wire, and compatible, 1 change:\n") && !wire.contains("Rust"), "{wire}");
    let units = states(&[OTHER_UNITS]);
    assert_eq!(diff(units.path(), &[]).status.code(), Some(0));
}

#[test]
fn as_json() {
    let folder = states(&[EXTENDED]);
    let answer = diff(folder.path(), &["--json"]);
    let value: serde_json::Value = serde_json::from_slice(&answer.stdout).unwrap();
    assert_eq!((&value["old"], &value["breaking"]), (&"acme.xml".into(), &true.into()));
    let expected = serde_json::json!({
        "group": "wire", "kind": "field-added", "breaking": false, "item": "SPRAYER.new",
        "text": "field SPRAYER.new is new: uint8_t, an extension (4 bytes, was 3)",
        "from": null, "to": "uint8_t, an extension",
        "frame": {
            "crc_extra": { "from": 38, "to": 38 }, "len_v1": { "from": 3, "to": 3 }, "len_v2": { "from": 3, "to": 4 },
        },
        "old": null, "new": { "file": "new.xml", "line": 14, "column": 18 },
    });
    assert_eq!(value["changes"][0], expected);
    assert_eq!((&value["changes"][1]["group"], &value["changes"][1]["breaking"]), (&"api".into(), &true.into()));
}

#[test]
fn overlays_of_both_or_of_each() {
    let folder = states(&[]);
    let overlay = |name: &str, width: u8| {
        let text = format!(
            "<mavlink-overlay version='1' for='acme.xml'><message name='SPRAYER'><view name='TANK' words='level' item='tank' \
             partial='true'><bits name='height' at='0' width='{width}'/></view></message></mavlink-overlay>"
        );
        fs::write(folder.path().join(name), text).unwrap();
    };
    overlay("8.xml", 8);
    overlay("12.xml", 12);
    fs::copy(folder.path().join("acme.xml"), folder.path().join("v2.xml")).unwrap();
    fs::create_dir(folder.path().join("v2")).unwrap();
    fs::copy(folder.path().join("acme.xml"), folder.path().join("v2/acme.xml")).unwrap();
    let both = mavgen(folder.path(), &["diff", "acme.xml", "v2/acme.xml", "--overlay", "8.xml"]);
    assert_eq!((both.status.code(), &*stdout(&both)), (Some(0), "no difference\n"), "{}", stderr(&both));
    let each = ["diff", "acme.xml", "v2/acme.xml", "--overlay", "12.xml", "--old-overlay", "8.xml"];
    let each = mavgen(folder.path(), &each);
    assert_eq!(each.status.code(), Some(1), "{}", stderr(&each));
    assert!(
        stdout(&each).contains("Tank::height() is const fn(self) -> u16, was const fn(self) -> u8"),
        "{}",
        stdout(&each)
    );
}

#[test]
fn wrong_input_is_2() {
    let folder = states(&[("uint16_t", "uint24_t")]);
    for (old, new) in [("acme.xml", "new.xml"), ("new.xml", "acme.xml"), ("acme.xml", "none.xml")] {
        let answer = mavgen(folder.path(), &["diff", old, new]);
        assert_eq!((answer.status.code(), &*stdout(&answer)), (Some(2), ""), "{old} {new}");
        assert!(stderr(&answer).contains("error"), "{}", stderr(&answer));
    }
    assert_eq!(mavgen(folder.path(), &["diff", "acme.xml"]).status.code(), Some(2));
    assert_eq!(diff(folder.path(), &["--wire", "--api"]).status.code(), Some(2));
}

#[test]
fn a_message_of_one_state_can_be_asked_for() {
    let bell = "<message id=\"4712\" name=\"BELL\"><field type=\"uint8_t\" name=\"tone\"/></message></messages>";
    let folder = states(&[("</messages>", bell), WIDER, ("UINT16_MAX", "UINT32_MAX")]);
    let added = diff(folder.path(), &["--wire", "--messages", "BELL"]);
    let said = stdout(&added);
    assert_eq!(added.status.code(), Some(0), "{}", stderr(&added));
    assert!(said.contains("message BELL is new") && !said.contains("SPRAYER"), "{said}");
    let removed = mavgen(folder.path(), &["diff", "new.xml", "acme.xml", "--wire", "--messages", "BE*"]);
    assert_eq!(removed.status.code(), Some(1), "{}", stderr(&removed));
    let neither = diff(folder.path(), &["--messages", "BELLS"]);
    let said = "error: no message of acme.xml, new.xml is called `BELLS` (did you mean `BELL`?)\n";
    assert_eq!((neither.status.code(), &*stderr(&neither)), (Some(2), said));
}

/// Nobody will mend the old state.
#[test]
fn only_the_new_state_is_warned_about() {
    let folder = states(&[]);
    let path = |name: &str| folder.path().join(name);
    fs::write(path("acme.xml"), ACME.replace("units=\"cm\"", "units=\"furlong\"")).unwrap();
    let mended = diff(folder.path(), &["--deny-warnings"]);
    assert_eq!((mended.status.code(), &*stderr(&mended)), (Some(0), ""));
    fs::copy(path("acme.xml"), path("new.xml")).unwrap();
    let warned = stderr(&diff(folder.path(), &[]));
    assert!(warned.matches("warning[M321]").count() == 1 && warned.contains("--> new.xml:"), "{warned}");
    assert_eq!(diff(folder.path(), &["--deny-warnings"]).status.code(), Some(2));
}
