//! Files and options that cannot be what was meant: exit status 2, one clear line, nothing lost.

use std::fs;
use std::path::Path;
#[cfg(unix)]
use std::process::{Command, Output};

use crate::{ACME, folder, mavgen, stderr, tree};

/// What `generate` with these arguments says first, after it refused and left everything in the folder as it was.
fn refused(folder: &Path, arguments: &[&str]) -> String {
    let before = tree(folder);
    let output = mavgen(folder, arguments);
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(output.stdout.is_empty() && tree(folder) == before, "{said}");
    said.lines().next().unwrap_or_default().to_owned()
}

/// A folder with `acme.xml` and its sources in `out`.
fn generated() -> tempfile::TempDir {
    let folder = folder(ACME);
    assert_eq!(mavgen(folder.path(), &["generate", "acme.xml", "--out", "out"]).status.code(), Some(0));
    folder
}

#[test]
fn definitions_that_are_no_text() {
    let folder = generated();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("latin1.xml"), b"<mavlink>\xe9</mavlink>").unwrap();
    fs::create_dir(path("folder.xml")).unwrap();
    // A file with nothing in it but its length.
    fs::File::create(path("huge.xml")).unwrap().set_len((64 << 20) + 1).unwrap();
    for (xml, line) in [
        ("missing.xml", "error[M001]: `missing.xml` cannot be read: there is no such file"),
        ("acme.xml/x.xml", "error[M001]: `acme.xml/x.xml` cannot be read: there is no such file"),
        ("folder.xml", "error[M001]: `folder.xml` cannot be read: it is a folder"),
        ("latin1.xml", "error[M002]: the byte 0xE9 in line 1 is not UTF-8"),
        ("huge.xml", "error[M007]: `huge.xml` is larger than 64 MiB"),
    ] {
        let arguments = |command| [command, xml, "--out", "out"];
        assert_eq!(refused(folder.path(), &arguments("generate")), line);
        assert_eq!(refused(folder.path(), &arguments("check")), line);
        assert_eq!(refused(folder.path(), &["dump", xml]), line);
        assert_eq!(refused(folder.path(), &["lint", xml]), line);
        let as_overlay = ["generate", "acme.xml", "--overlay", xml, "--out", "out"];
        assert_eq!(refused(folder.path(), &as_overlay), line);
    }
}

/// What is not there has nothing wrong in it.
#[test]
fn a_file_that_cannot_be_read_is_all_that_is_said() {
    let folder = folder(ACME);
    for command in ["lint", "dump"] {
        assert_eq!(stderr(&mavgen(folder.path(), &[command, "."])), "error[M001]: no `.msg` file is in .\n\n");
    }
}

#[test]
fn a_definition_for_an_overlay() {
    let folder = generated();
    fs::write(folder.path().join("top.xml"), "<mavlink><include>acme.xml</include></mavlink>").unwrap();
    for dialect in ["acme.xml", "top.xml"] {
        let said = refused(folder.path(), &["generate", dialect, "--overlay", "acme.xml", "--out", "out"]);
        assert_eq!(said, "error[M100]: the root element is `<mavlink>`");
    }
}

#[test]
fn a_time_for_commands_that_is_none() {
    let folder = generated();
    let said = |command, when| refused(folder.path(), &[command, "acme.xml", "--commands", when, "--out", "out"]);
    for command in ["generate", "check"] {
        for (when, name) in
            [("feature=", ""), ("feature=two words", "two words"), ("feature=dep:x", "dep:x"), ("feature=\"]", "\\\"]")]
        {
            let rule = "a name begins with a letter, a digit or `_`, and goes on with these, `-`, `+` and `.`";
            assert_eq!(said(command, when), format!("error: `{name}` cannot be a cargo feature: {rule}"));
        }
        for when in ["sometimes", "", "commands", "Feature=x"] {
            let expected =
                format!("error: invalid value '{when}' for '--commands <WHEN>': it is always, never, or feature=NAME");
            assert_eq!(said(command, when), expected);
        }
    }
}

#[test]
fn what_is_in_the_way() {
    let folder = generated();
    let sprayer = folder.path().join("out/messages/sprayer.rs");
    fs::remove_file(&sprayer).unwrap();
    fs::create_dir(&sprayer).unwrap();
    for command in ["generate", "check"] {
        let said = refused(folder.path(), &[command, "acme.xml", "--out", "out"]);
        assert!(
            said.starts_with("error: out/messages/sprayer.rs: "),
            "{command} must not say that it is missing: {said}"
        );
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("nowhere", folder.path().join("link")).unwrap();
        let said = stderr(&mavgen(folder.path(), &["generate", "acme.xml", "--out", "link"]));
        assert_eq!(said, "error: link: there is something of that name that is no folder: move or delete it\n");
    }
}

/// What is wrong with an included file is said of it, and not that it is misspelled.
#[test]
fn an_include_that_is_there_and_cannot_be_read() {
    let folder = folder("<mavlink><include>base.xml</include></mavlink>");
    fs::create_dir(folder.path().join("base.xml")).unwrap();
    let said = stderr(&mavgen(folder.path(), &["lint", "acme.xml"]));
    assert!(said.contains("help: looked for `base.xml`: it is a folder\n"), "{said}");
}

#[cfg(unix)]
#[test]
fn a_file_for_a_folder() {
    let folder = generated();
    for (out, named) in [("acme.xml", "acme.xml"), ("acme.xml/out", "acme.xml/out")] {
        for command in ["generate", "check"] {
            let said = refused(folder.path(), &[command, "acme.xml", "--out", out]);
            let expected = format!("error: {named}: there is a file where a folder is needed: choose another folder");
            assert_eq!(said, expected, "{command}");
        }
    }
}

#[test]
fn folders_that_cannot_be_written() {
    let folder = generated();
    let generate = |out: &str| refused(folder.path(), &["generate", "acme.xml", "--out", out]);
    assert!(generate("acme.xml").starts_with("error: acme.xml: "), "{}", generate("acme.xml"));
    assert!(generate("acme.xml/out").starts_with("error: acme.xml"), "{}", generate("acme.xml/out"));
    let long = "x".repeat(300);
    assert!(generate(&long).starts_with(&format!("error: {long}: ")), "{}", generate(&long));
    assert!(generate("").starts_with("error: "), "{}", generate(""));
    let check = refused(folder.path(), &["check", "acme.xml", "--out", "acme.xml"]);
    assert!(check.starts_with("error: acme.xml: "), "{check}");
}

/// Not even the superuser makes folders there.
#[cfg(target_os = "linux")]
#[test]
fn a_file_system_that_is_not_for_writing() {
    let folder = generated();
    let said = refused(folder.path(), &["generate", "acme.xml", "--out", "/proc/acme"]);
    assert!(said.starts_with("error: /proc/acme: "), "{said}");
}

/// Runs the command as on a full disk: a limit on the length of files lets it write some of a long one, then no more.
#[cfg(unix)]
fn on_a_full_disk(folder: &Path, arguments: &str) -> Output {
    let script = format!("trap '' XFSZ; ulimit -f 64; exec \"$0\" {arguments}");
    let mavgen = env!("CARGO_BIN_EXE_mavgen");
    Command::new("sh").args(["-c", &script, mavgen]).current_dir(folder).output().unwrap()
}

#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_old_tree_whole() {
    let folder = generated();
    let before = tree(&folder.path().join("out"));
    let long = "Much to say. ".repeat(10_000);
    let xml = ACME.replace("What the sprayer does.", &long).replace("uint16_t", "uint32_t");
    fs::write(folder.path().join("acme.xml"), xml).unwrap();
    let output = on_a_full_disk(folder.path(), "generate acme.xml --out out");
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    assert!(stderr(&output).starts_with("error: out/messages/sprayer.rs: "), "{}", stderr(&output));
    assert_eq!(tree(&folder.path().join("out")), before);
}

#[cfg(unix)]
#[test]
fn a_full_disk_gets_no_half_of_a_vendored_dialect() {
    let folder = folder("<mavlink><include>long.xml</include></mavlink>");
    fs::write(folder.path().join("long.xml"), ACME.replace("What", &"Much to say. ".repeat(10_000))).unwrap();
    let output = on_a_full_disk(folder.path(), "vendor acme.xml --out copies");
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    assert!(stderr(&output).starts_with("error: copies/long.xml: "), "{}", stderr(&output));
    assert!(!folder.path().join("copies").exists());
}

/// `-` is one stream, which neither a folder nor a file that names others is.
#[test]
fn a_dash_is_no_folder_and_no_definition() {
    let folder = generated();
    for (arguments, named, why) in [
        (&["generate", "acme.xml", "--out", "-"][..], "--out <DIR>", "files are written into a folder"),
        (&["check", "acme.xml", "--out=-"], "--out <DIR>", "files are written into a folder"),
        (&["vendor", "acme.xml", "--out", "-"], "--out <DIR>", "files are written into a folder"),
        (&["decode", "acme.xml", "--format", "csv", "--out", "-"], "--out <DIR>", "files are written into a folder"),
        (&["lint", "-"], "<XML>...", "definitions are read from a file"),
        (&["dump", "acme.xml", "--overlay", "-"], "--overlay <FILE>", "definitions are read from a file"),
        (&["vendor", "-", "--out", "copies"], "<XML>", "definitions are read from a file"),
        (&["diff", "-", "acme.xml"], "<OLD>", "definitions are read from a file"),
        (&["diff", "acme.xml", "-"], "<NEW>", "definitions are read from a file"),
        (&["diff", "acme.xml", "acme.xml", "--old-overlay", "-"], "--old-overlay <FILE>", "definitions are read"),
    ] {
        let said = refused(folder.path(), arguments);
        assert!(said.starts_with(&format!("error: invalid value '-' for '{named}': {why}")), "{arguments:?}: {said}");
        assert!(said.ends_with("`./-` is one of that name"), "{said}");
    }
    assert_eq!(mavgen(folder.path(), &["generate", "acme.xml", "--out", "./-"]).status.code(), Some(0));
    assert!(folder.path().join("-/mod.rs").exists());
}

#[test]
fn messages_of_px4_where_a_dialect_is_needed() {
    let folder = generated();
    fs::create_dir(folder.path().join("msg")).unwrap();
    fs::write(folder.path().join("msg/Foo.msg"), "uint64 timestamp\n").unwrap();
    for arguments in [&["diff", "msg", "acme.xml"][..], &["diff", "acme.xml", "msg"], &["decode", "msg", "acme.xml"]] {
        let said = refused(folder.path(), arguments);
        assert_eq!(said, "error: `msg` has uORB messages: a dialect's XML file is needed");
    }
}

#[test]
fn wrong_options() {
    let folder = generated();
    for arguments in [
        &["generate", "acme.xml"][..],
        &["generate", "--out", "out"],
        &["generate", "acme.xml", "--out", "out", "--outt", "x"],
        &["generate", "acme.xml", "--out", "out", "--out", "x"],
        &["generate", "acme.xml", "--out", "out", "--color", "sometimes"],
        &["generate", "acme.xml", "--out", "out", "--message-format", "xml"],
        &["generat", "acme.xml", "--out", "out"],
        &[],
    ] {
        assert_ne!(refused(folder.path(), arguments), "", "{arguments:?}");
    }
}
