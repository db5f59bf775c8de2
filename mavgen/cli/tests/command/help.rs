//! Help, manual pages and completions.

use crate::{ACME, folder, mavgen, stderr, stdout};

const COMMANDS: [&str; 8] = ["generate", "check", "lint", "dump", "diff", "vendor", "completions", "man"];

#[test]
fn help_teaches_by_example() {
    let folder = folder(ACME);
    let help = |arguments: &[&str]| stdout(&mavgen(folder.path(), arguments));
    assert!(help(&["--help"]).contains("mavgen check xml/acme.xml --out src/acme"));
    for command in COMMANDS {
        let text = help(&[command, "--help"]);
        assert!(text.contains("\nExample") && text.contains(&format!("\n  mavgen {command} ")), "{text}");
    }
    assert!(help(&["--version"]).starts_with("mavgen 0."));
}

#[test]
fn manual_pages() {
    let folder = folder(ACME);
    let page = stdout(&mavgen(folder.path(), &["man"]));
    assert!(page.contains(".TH mavgen 1"), "{page}");
    for command in COMMANDS {
        assert!(page.contains(&format!("mavgen\\-{command}(1)")), "{page}");
        let page = stdout(&mavgen(folder.path(), &["man", command]));
        assert!(page.contains(&format!(".TH mavgen-{command} 1  \"mavgen 0.")), "{page}");
        let examples = page.split_once(".SH EXAMPLES\n.nf\nExample").unwrap().1;
        assert!(examples.contains(&format!("\n  mavgen {command} ")) && examples.contains("\n.fi\n"), "{page}");
    }
    let unknown = mavgen(folder.path(), &["man", "generat"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert_eq!(stderr(&unknown), "error: there is no command `generat`; did you mean `generate`?\n");
}

#[test]
fn completions_know_every_command() {
    let folder = folder(ACME);
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = stdout(&mavgen(folder.path(), &["completions", shell]));
        for word in COMMANDS.into_iter().chain(["deny-warnings", "message-format"]) {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
}
