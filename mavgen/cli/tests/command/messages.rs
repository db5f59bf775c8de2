//! A dialect cut to some messages.

use std::fs;

use crate::{ACME, folder, mavgen, stderr, stdout};

#[test]
fn only_some_messages() {
    let bell = "<message id='4712' name='BELL'><field type='uint8_t' name='tone'>x</field></message></messages>";
    let folder = folder(&ACME.replace("</messages>", bell));
    let generate = ["generate", "acme.xml", "--out", "out", "--messages", "BE*"];
    assert_eq!(mavgen(folder.path(), &generate).status.code(), Some(0));
    let names = |sub: &str| fs::read_dir(folder.path().join("out").join(sub)).map_or(0, Iterator::count);
    assert_eq!((names("messages"), names("enums")), (1, 0));
    let check = |messages: &str| {
        mavgen(folder.path(), &["check", "acme.xml", "--out", "out", "--messages", messages]).status.code()
    };
    assert_eq!((check("BELL"), check("BE*"), check("BELL,SPRAYER")), (Some(1), Some(0), Some(1)));
    let dumped = mavgen(folder.path(), &["dump", "acme.xml", "--json", "--messages", "SPR*,SPRAYER"]);
    let model: serde_json::Value = serde_json::from_slice(&dumped.stdout).unwrap();
    assert_eq!((&model["messages"][0]["name"], &model["messages"][1]), (&"SPRAYER".into(), &serde_json::Value::Null));

    let refused = mavgen(folder.path(), &["generate", "acme.xml", "--out", "out", "--messages", "BELL,SPRAYE"]);
    assert_eq!(refused.status.code(), Some(2));
    assert_eq!(stderr(&refused), "error: no message of acme.xml is called `SPRAYE` (did you mean `SPRAYER`?)\n");
    assert_eq!(check("BE*"), Some(0), "nothing was touched");
}

#[test]
fn a_wrong_name_is_wrong_everywhere() {
    let folder = folder(ACME);
    let out = folder.path().join("out");
    for command in [
        &["lint"][..],
        &["dump"],
        &["decode"],
        &["diff", "acme.xml"],
        &["check", "--out", "out"],
        &["generate", "--out", "out"],
        &["vendor", "--out", "out"],
    ] {
        for (messages, said) in [
            ("SPRAYER,,BELL", "error: the list of messages is empty, or has an empty name: "),
            ("", "error: the list of messages is empty, or has an empty name: "),
            ("sprayer", "error: no message of acme.xml is called `sprayer` (did you mean `SPRAYER`?)\n"),
        ] {
            let arguments = [command, &["acme.xml", "--messages", messages]].concat();
            let refused = mavgen(folder.path(), &arguments);
            assert_eq!(refused.status.code(), Some(2), "{arguments:?}");
            assert!(stderr(&refused).starts_with(said), "{arguments:?}: {}", stderr(&refused));
            assert!(refused.stdout.is_empty() && !out.exists());
        }
    }
}

/// A dialect is right or wrong as a whole, whatever of it is wanted.
#[test]
fn lint_judges_all_messages() {
    let bell = "<message id='4712' name='BELL'><field type='uint24_t' name='tone'>x</field></message></messages>";
    let folder = folder(&ACME.replace("</messages>", bell));
    let answer = mavgen(folder.path(), &["lint", "acme.xml", "--messages", "SPRAYER"]);
    assert_eq!(answer.status.code(), Some(1));
    assert!(stderr(&answer).contains("error[M304]"), "{}", stderr(&answer));
    let help = stdout(&mavgen(folder.path(), &["lint", "-h"]));
    let help = help.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(help.contains("all of it is judged") && help.contains("means no message is an error"), "{help}");
}

/// What two dialects disagree about is in the way only of those who want it, in `lint` as in `generate`.
#[test]
fn lint_holds_only_the_messages_against_each_other_that_are_generated() {
    let bell = "<message id='4712' name='BELL'><field type='uint8_t' name='tone'>x</field></message></messages>";
    let (one, other) =
        (ACME.replace("</messages>", bell), ACME.replace("</messages>", bell).replace("value=\"1\"", "value=\"2\""));
    let folder = folder(&one);
    fs::write(folder.path().join("other.xml"), other).unwrap();
    let warned = |arguments: &[&str]| {
        let answer = mavgen(folder.path(), &[arguments, &["acme.xml", "other.xml"]].concat());
        assert_eq!(answer.status.code(), Some(0), "{arguments:?}");
        stderr(&answer).contains("warning[M800]")
    };
    assert!(warned(&["lint"]) && warned(&["generate", "--out", "out"]));
    assert!(!warned(&["lint", "--messages", "BELL"]));
    assert!(!warned(&["generate", "--out", "out", "--messages", "BELL"]));
}
