//! A dialect cut to some messages.

use std::fs;

use crate::{ACME, folder, mavgen, stderr};

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
    for command in [&["lint"][..], &["dump"], &["check", "--out", "out"], &["generate", "--out", "out"]] {
        let arguments = [command, &["acme.xml", "--messages", "SPRAYER,,BELL"]].concat();
        let refused = mavgen(folder.path(), &arguments);
        assert_eq!(refused.status.code(), Some(2), "{arguments:?}");
        assert!(stderr(&refused).starts_with("error: the list of messages"), "{}", stderr(&refused));
    }
}
