//! `lint`, and warnings that are denied.

use std::fs;

use crate::{ACME, folder, mavgen, stderr};

/// Two fields of different types carry one enum, which deserves a warning.
const WIDE: &str = "<message id='1' name='WIDE'><description>Wide.</description>\
                    <field type='uint16_t' name='s' enum='SPRAY_STATE'>x</field></message>";

/// A dialect with a warning, and one without that includes it.
fn upstream_and_own() -> tempfile::TempDir {
    let upstream = ACME.replace("</messages>", &format!("{WIDE}</messages>"));
    let own = "<mavlink><include>acme.xml</include><messages><message id='2' name='OWN'>\
               <field type='uint8_t' name='a'>x</field></message></messages></mavlink>";
    let folder = folder(&upstream);
    fs::write(folder.path().join("own.xml"), own).unwrap();
    folder
}

#[test]
fn fine_is_0() {
    let folder = folder(ACME);
    let answer = mavgen(folder.path(), &["lint", "acme.xml"]);
    assert_eq!((answer.status.code(), &*stderr(&answer)), (Some(0), "acme.xml: 0 errors, 0 warnings, 0 notes\n"));
}

#[test]
fn wrong_is_1_and_says_everything() {
    let folder = folder(&ACME.replace("uint16_t", "uint24_t").replace("enum=\"SPRAY_STATE\"", "enum=\"SPRAY\""));
    let answer = mavgen(folder.path(), &["lint", "acme.xml"]);
    let said = stderr(&answer);
    assert_eq!(answer.status.code(), Some(1), "{said}");
    assert!(said.contains("error[M304]") && said.contains("error[M310]"), "{said}");
    assert!(said.ends_with("\nacme.xml: 2 errors, 0 warnings, 0 notes\n"), "{said}");
}

#[test]
fn warnings_are_no_reason_to_say_no_unless_denied() {
    let folder = upstream_and_own();
    let warned = mavgen(folder.path(), &["lint", "acme.xml"]);
    assert_eq!(warned.status.code(), Some(0));
    assert!(
        stderr(&warned).contains("warning[M313]") && stderr(&warned).contains(" 1 warning,"),
        "{}",
        stderr(&warned)
    );
    let denied = mavgen(folder.path(), &["lint", "acme.xml", "--deny-warnings"]);
    assert_eq!(denied.status.code(), Some(1));
    let last = "error: warnings about the dialect's own file and its overlays are denied\n";
    assert!(stderr(&denied).ends_with(last), "{}", stderr(&denied));
}

/// Whoever only generates Rust has no use for it, and no warning that is denied.
#[test]
fn what_pymavlink_refuses_is_told_by_lint_alone() {
    let folder = folder(&ACME.replace("<version>3</version>", "<dialect>300</dialect><version>3</version>"));
    let lint = mavgen(folder.path(), &["lint", "acme.xml", "--deny-warnings"]);
    assert_eq!(lint.status.code(), Some(0), "{}", stderr(&lint));
    assert_eq!(stderr(&lint).matches("warning[M111]: pymavlink refuses this: ").count(), 2, "{}", stderr(&lint));
    for command in [&["dump"][..], &["generate", "--out", "out"], &["check", "--out", "out"]] {
        let fine = mavgen(folder.path(), &[command, &["acme.xml", "--deny-warnings"]].concat());
        assert_eq!(fine.status.code(), Some(0), "{}", stderr(&fine));
        assert!(!stderr(&fine).contains("warning"), "{}", stderr(&fine));
    }
}

/// Nobody can mend what upstream wrote.
#[test]
fn warnings_about_included_files_are_shown_by_lint_alone_and_never_denied() {
    let folder = upstream_and_own();
    let lint = mavgen(folder.path(), &["lint", "own.xml", "--deny-warnings"]);
    assert_eq!(lint.status.code(), Some(0), "{}", stderr(&lint));
    assert!(stderr(&lint).contains("warning[M313]"), "{}", stderr(&lint));
    for command in [&["dump"][..], &["generate", "--out", "out"], &["check", "--out", "out"]] {
        let fine = mavgen(folder.path(), &[command, &["own.xml", "--deny-warnings"]].concat());
        assert_eq!(fine.status.code(), Some(0), "{}", stderr(&fine));
        assert!(!stderr(&fine).contains("warning"), "{}", stderr(&fine));
    }
}

/// A vendored copy is upstream's, also as the dialect that is named.
#[test]
fn warnings_about_a_vendored_copy_are_shown_by_lint_alone_and_never_denied() {
    let folder = upstream_and_own();
    assert!(mavgen(folder.path(), &["vendor", "acme.xml", "--out", "xml"]).status.success());
    let lint = mavgen(folder.path(), &["lint", "xml/acme.xml", "--deny-warnings"]);
    assert!(lint.status.success() && stderr(&lint).contains("warning[M313]"), "{}", stderr(&lint));
    for command in [&["dump"][..], &["generate", "--out", "out"], &["check", "--out", "out"]] {
        let fine = mavgen(folder.path(), &[command, &["xml/acme.xml", "--deny-warnings"]].concat());
        assert!(fine.status.success() && !stderr(&fine).contains("warning"), "{}", stderr(&fine));
    }
}

#[test]
fn what_is_allowed_is_not_told() {
    let folder = upstream_and_own();
    for codes in [&["--allow", "M313"][..], &["--allow=m101,313"], &["--allow", "M101", "--allow", "M313"]] {
        for command in [&["lint"][..], &["dump"], &["generate", "--out", "out"], &["vendor", "--out", "xml"]] {
            let fine = mavgen(folder.path(), &[command, &["acme.xml", "--deny-warnings"], codes].concat());
            assert!(fine.status.success() && !stderr(&fine).contains("M313"), "{command:?}: {}", stderr(&fine));
        }
    }
    let unknown = mavgen(folder.path(), &["lint", "acme.xml", "--allow", "M31X"]);
    let said = "error: there is no diagnostic `M31X`; did you mean `M310`?\n";
    assert_eq!((unknown.status.code(), &*stderr(&unknown)), (Some(2), said));
}

#[test]
fn denied_warnings_stop_every_command_before_it_writes() {
    let folder = upstream_and_own();
    for command in [&["dump"][..], &["generate", "--out", "out"], &["check", "--out", "out"]] {
        let refused = mavgen(folder.path(), &[command, &["acme.xml", "--deny-warnings"]].concat());
        assert_eq!(refused.status.code(), Some(2), "{}", stderr(&refused));
        assert!(
            stderr(&refused).contains("warning[M313]") && stderr(&refused).contains("are denied"),
            "{}",
            stderr(&refused)
        );
        assert!(refused.stdout.is_empty() && !folder.path().join("out").exists());
    }
    let warned = mavgen(folder.path(), &["generate", "acme.xml", "--out", "out"]);
    assert_eq!(warned.status.code(), Some(0));
    assert!(stderr(&warned).contains("warning[M313]"), "{}", stderr(&warned));
}

#[test]
fn warnings_about_overlays_are_denied() {
    let folder = folder(ACME);
    let overlay =
        "<mavlink-overlay version='1' for='acme.xml'><refine enum='SPRAY_STATE' bitmask='false'/></mavlink-overlay>";
    fs::write(folder.path().join("o.xml"), overlay).unwrap();
    let lint = mavgen(folder.path(), &["lint", "acme.xml", "--overlay", "o.xml", "--deny-warnings"]);
    assert_eq!(lint.status.code(), Some(1), "{}", stderr(&lint));
    assert!(stderr(&lint).contains("o.xml:1:"), "{}", stderr(&lint));
}

#[test]
fn a_file_that_cannot_be_read_leaves_nothing_to_judge() {
    let folder = folder(ACME);
    assert_eq!(mavgen(folder.path(), &["lint", "missing.xml"]).status.code(), Some(2));
}
