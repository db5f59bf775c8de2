//! The command: exit status, what it writes, and what it leaves alone.
//!
//! Needs the feature `cli`, without which there is no command to test.
#![cfg(feature = "cli")]
#![expect(clippy::unwrap_used, reason = "in what the tests share, too, a failure is a failed test")]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const ACME: &str = r#"<mavlink>
  <version>3</version>
  <enums>
    <enum name="SPRAY_STATE">
      <entry value="0" name="SPRAY_STATE_OFF"/>
      <entry value="1" name="SPRAY_STATE_ON"/>
    </enum>
  </enums>
  <messages>
    <message id="4711" name="SPRAYER">
      <description>What the sprayer does.</description>
      <field type="uint8_t" name="state" enum="SPRAY_STATE">Whether it sprays.</field>
      <field type="uint16_t" name="level" units="cm" invalid="UINT16_MAX">What is left in the tank.</field>
    </message>
  </messages>
</mavlink>
"#;

/// A folder with `acme.xml` in it.
fn folder(xml: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("acme.xml"), xml).unwrap();
    folder
}

fn mavgen(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_mavgen")).current_dir(folder).args(arguments).output().unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

#[test]
fn generate_then_check() {
    let folder = folder(ACME);
    let generate = ["generate", "acme.xml", "--out", "src/acme"];
    let first = mavgen(folder.path(), &generate);
    assert_eq!(first.status.code(), Some(0), "{}", stderr(&first));
    assert!(stderr(&first).starts_with("src/acme: 6 files written, 0 kept, 0 removed"), "{}", stderr(&first));
    let again = mavgen(folder.path(), &generate);
    assert!(stderr(&again).starts_with("src/acme: 0 files written, 6 kept, 0 removed"), "{}", stderr(&again));

    let check = ["check", "acme.xml", "--out", "src/acme"];
    assert_eq!(mavgen(folder.path(), &check).status.code(), Some(0));
    let sprayer = folder.path().join("src/acme/messages/sprayer.rs");
    fs::write(&sprayer, fs::read_to_string(&sprayer).unwrap() + "// touched\n").unwrap();
    let stale = mavgen(folder.path(), &check);
    assert_eq!(stale.status.code(), Some(1));
    assert_eq!(stderr(&stale), "src/acme/messages/sprayer.rs differs\nrun `mavgen generate acme.xml --out src/acme`\n");
}

#[test]
fn a_mistake_costs_nothing_that_was_there() {
    let folder = folder(ACME);
    let generate = ["generate", "acme.xml", "--out", "out"];
    mavgen(folder.path(), &generate);
    let before = fs::read(folder.path().join("out/messages/sprayer.rs")).unwrap();
    fs::write(folder.path().join("acme.xml"), ACME.replace("uint16_t", "uint24_t")).unwrap();
    let refused = mavgen(folder.path(), &generate);
    assert_eq!(refused.status.code(), Some(2));
    assert!(
        stderr(&refused).contains("error[M304]") && stderr(&refused).contains("acme.xml:13:20"),
        "{}",
        stderr(&refused)
    );
    assert_eq!(fs::read(folder.path().join("out/messages/sprayer.rs")).unwrap(), before);
}

#[test]
fn somebodys_folder_is_refused() {
    let folder = folder(ACME);
    fs::create_dir(folder.path().join("thesis")).unwrap();
    fs::write(folder.path().join("thesis/chapter1.tex"), "x").unwrap();
    let refused = mavgen(folder.path(), &["generate", "acme.xml", "--out", "thesis"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(stderr(&refused).contains("not empty"), "{}", stderr(&refused));
    assert_eq!(fs::read_dir(folder.path().join("thesis")).unwrap().count(), 1);
}

#[test]
fn dump_as_json() {
    let folder = folder(ACME);
    let dumped = mavgen(folder.path(), &["dump", "acme.xml", "--json"]);
    assert_eq!(dumped.status.code(), Some(0));
    let model: serde_json::Value = serde_json::from_slice(&dumped.stdout).unwrap();
    assert_eq!(model["dialect"], "acme");
    assert_eq!(model["messages"][0]["len_v1"], 3);
    let level = serde_json::json!({
        "name": "level", "type": "uint16_t", "array": null, "offset": 0, "extension": false, "enum": null, "units": "cm",
        "version": null,
    });
    assert_eq!(model["messages"][0]["fields"][1], level);
    assert_eq!(model["enums"][0]["entries"][1]["value"], 1);
}

#[test]
fn an_overlay_is_part_of_the_model() {
    let folder = folder(ACME);
    let overlay = "<mavlink-overlay version='1' for='acme.xml'><enums><enum name='LEVEL'><entry value='0' name='LEVEL_LOW'/>\
                   </enum></enums></mavlink-overlay>";
    fs::write(folder.path().join("acme.overlay.xml"), overlay).unwrap();
    let dumped = mavgen(folder.path(), &["dump", "acme.xml", "--overlay", "acme.overlay.xml", "--json"]);
    assert_eq!(dumped.status.code(), Some(0), "{}", stderr(&dumped));
    let model: serde_json::Value = serde_json::from_slice(&dumped.stdout).unwrap();
    assert_eq!(model["files"], serde_json::json!(["acme.xml", "acme.overlay.xml"]));
    assert_eq!(
        (&model["enums"][1]["name"], &model["enums"][1]["defined_in"]),
        (&"LEVEL".into(), &"acme.overlay.xml".into())
    );
    assert_eq!(mavgen(folder.path(), &["dump", "acme.xml", "--overlay", "none.xml"]).status.code(), Some(2));
}

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
fn wrong_usage_is_2() {
    let folder = folder(ACME);
    assert_eq!(mavgen(folder.path(), &["generate", "acme.xml"]).status.code(), Some(2));
    assert_eq!(mavgen(folder.path(), &["dump", "missing.xml"]).status.code(), Some(2));
}
