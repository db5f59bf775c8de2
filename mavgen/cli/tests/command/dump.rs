//! The model, as JSON and as text.

use std::fs;

use crate::{ACME, folder, mavgen, stderr, stdout};

#[test]
fn as_json() {
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
fn as_text() {
    let folder = folder(ACME);
    let dumped = mavgen(folder.path(), &["dump", "acme.xml"]);
    let lines = "4711 SPRAYER: 3 bytes (3 in MAVLink 1), crc_extra 38\n    0 level: uint16_t cm\n    2 state: uint8_t SPRAY_STATE\n\
                 enum SPRAY_STATE: u8\n           0 SPRAY_STATE_OFF\n           1 SPRAY_STATE_ON\n";
    assert_eq!(stdout(&dumped), lines);
}
