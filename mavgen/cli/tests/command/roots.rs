//! Several dialects: one tree with a module for each.

use std::fs;

use crate::{ACME, folder, mavgen, stderr, stdout, tree};

/// A folder with `acme.xml` and `other.xml`, which includes it.
fn two() -> tempfile::TempDir {
    let folder = folder(ACME);
    fs::write(folder.path().join("other.xml"), "<mavlink><include>acme.xml</include><messages/></mavlink>").unwrap();
    folder
}

#[test]
fn two_dialects_are_one_tree() {
    let folder = two();
    let said = |command: &str| mavgen(folder.path(), &[command, "acme.xml", "other.xml", "--out", "src/dialects"]);
    let generated = said("generate");
    assert_eq!(generated.status.code(), Some(0), "{}", stderr(&generated));
    assert_eq!(said("check").status.code(), Some(0));
    let out = folder.path().join("src/dialects");
    let paths: Vec<_> = tree(&out).into_iter().map(|(path, _)| path.display().to_string()).collect();
    let of = |dialect: &str| ["dialect", "enums", "messages"].map(|module| format!("{dialect}/{module}.rs"));
    let shared = ["enums/spray_state", "enums", "messages/sprayer", "messages", "mod"].map(|file| format!("{file}.rs"));
    let mut expected = [&of("acme")[..], &of("other"), &["acme.rs".into(), "other.rs".into()], &shared].concat();
    let mut found = paths.clone();
    expected.sort();
    found.sort();
    assert_eq!(found, expected);

    fs::write(out.join("other.rs"), fs::read_to_string(out.join("acme.rs")).unwrap()).unwrap();
    let stale = said("check");
    assert_eq!(stale.status.code(), Some(1));
    assert!(stderr(&stale).ends_with("mavgen generate acme.xml other.xml --out src/dialects\n"), "{}", stderr(&stale));
}

#[test]
fn a_dialect_that_is_gone_takes_its_files_along() {
    let folder = two();
    mavgen(folder.path(), &["generate", "acme.xml", "other.xml", "--out", "out"]);
    mavgen(folder.path(), &["generate", "acme.xml", "--out", "out"]);
    mavgen(folder.path(), &["generate", "acme.xml", "--out", "alone"]);
    assert_eq!(tree(&folder.path().join("out")), tree(&folder.path().join("alone")));
}

#[test]
fn two_dialects_of_one_name_are_refused() {
    let folder = two();
    fs::create_dir(folder.path().join("fork")).unwrap();
    for name in ["acme.xml", "ACME.xml"] {
        fs::write(folder.path().join("fork").join(name), ACME).unwrap();
    }
    mavgen(folder.path(), &["generate", "acme.xml", "--out", "out"]);
    let before = tree(folder.path());
    for (second, line) in [
        (
            "fork/acme.xml",
            "error[M802]: `acme.xml` and `fork/acme.xml` would both be the module `acme`\n --> fork/acme.xml:1:1\n",
        ),
        (
            "fork/ACME.xml",
            "error[M802]: `acme.xml` and `fork/ACME.xml` would both be the module `acme`\n --> fork/ACME.xml:1:1\n",
        ),
        ("acme.xml", "error: `acme.xml` is given twice: name each dialect once\n"),
        ("fork/../acme.xml", "error: `fork/../acme.xml` is given twice: name each dialect once\n"),
    ] {
        for command in [&["generate", "acme.xml", second, "--out", "out"][..], &["lint", "acme.xml", second]] {
            let refused = mavgen(folder.path(), command);
            let status = if line.contains('[') && command.contains(&"lint") { 1 } else { 2 };
            assert_eq!(refused.status.code(), Some(status), "{command:?}");
            assert!(stderr(&refused).starts_with(line), "{command:?}: {}", stderr(&refused));
        }
    }
    assert_eq!(tree(folder.path()), before);
}

#[test]
fn lint_and_dump_take_several_as_well() {
    let folder = two();
    let linted = mavgen(folder.path(), &["lint", "acme.xml", "other.xml"]);
    assert_eq!(stderr(&linted), "acme.xml, other.xml: 0 errors, 0 warnings, 0 notes\n");
    let dumped = mavgen(folder.path(), &["dump", "acme.xml", "other.xml", "--json"]);
    let models = serde_json::Deserializer::from_str(&stdout(&dumped)).into_iter::<serde_json::Value>().count();
    assert_eq!(models, 2, "one document after the other");
}

#[test]
fn what_is_denied_is_denied_in_each() {
    let folder = two();
    let warned = "<mavlink colour='red'><include>acme.xml</include></mavlink>";
    fs::write(folder.path().join("other.xml"), warned).unwrap();
    let said = |arguments: &[&str]| mavgen(folder.path(), &[arguments, &["--out", "out", "--deny-warnings"]].concat());
    assert_eq!(said(&["generate", "acme.xml"]).status.code(), Some(0));
    assert_eq!(said(&["generate", "acme.xml", "other.xml"]).status.code(), Some(2));
}
