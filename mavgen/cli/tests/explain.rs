//! `mavgen explain`: what it prints, and how it ends.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use std::process::Command;

use mavgen::diag::Code;

/// Exit status, standard output and standard error.
fn explain(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_mavgen")).arg("explain").args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

#[test]
fn every_code_is_explained() {
    let (status, list, _) = explain(&[]);
    assert_eq!((status, list.lines().count()), (Some(0), Code::ALL.len()));
    for line in list.lines() {
        assert!(line.starts_with('M') && line.ends_with('.'), "{line}");
    }
    let (status, page, _) = explain(&["M306"]);
    assert_eq!(status, Some(0));
    assert!(page.starts_with("M306 (error): A payload is longer than 255 bytes.\n\n"), "{page}");
    assert!(page.contains("\nWrong:\n\n    <message id=\"1\"") && page.contains("\nRight:\n\n    <message"), "{page}");
}

#[test]
fn an_unknown_code_is_a_wrong_input() {
    let (status, stdout, stderr) = explain(&["M36"]);
    assert_eq!((status, stdout.as_str()), (Some(2), ""));
    assert!(stderr.contains("`M36`") && stderr.contains("did you mean"), "{stderr}");
}
