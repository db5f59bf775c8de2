//! What `mavgen dump` says of overlays: bound enums, and views of packed bits.

#![expect(clippy::unwrap_used, reason = "a failing test panics")]

use std::fs;
use std::process::Command;

use serde_json::{Value, json};

const ACME: &str = r#"<mavlink>
  <enums>
    <enum name="PUMP_STATE"><entry value="0" name="PUMP_STATE_OFF"/><entry value="1" name="PUMP_STATE_ON"/></enum>
    <enum name="PUMP_MODE"><entry value="7" name="PUMP_MODE_FAST"/></enum>
  </enums>
  <messages>
    <message id="200" name="PUMPS">
      <description/>
      <field type="uint8_t" name="count"/>
      <field type="uint8_t[3]" name="id"/>
      <field type="uint16_t[3]" name="word"/>
      <field type="uint8_t" name="kind" enum="PUMP_STATE"/>
      <field type="uint8_t" name="mode"/>
      <field type="uint64_t[2]" name="mask"/>
    </message>
  </messages>
</mavlink>
"#;

const OVERLAY: &str = r#"<mavlink-overlay version="1" for="acme.xml">
  <message name="PUMPS">
    <bind name="pump_mode" field="mode" enum="PUMP_MODE" if="kind" is="PUMP_STATE_ON"/>
    <view name="PUMP_STATUS" words="word[i]" item="pump" items="pumps" count="count">
      <key name="id" field="id[i]" invalid="255"/>
      <invalid field="id[i]" value="0"/> <invalid value="0"/>
      <bits name="state" at="0" width="1" enum="PUMP_STATE"/>
      <bits name="angle" at="1" width="7" signed="true" scale="1/4" bias="-2" units="deg" exact="cdeg"/>
      <switch field="mode">
        <case value="1 3..=5"><bits name="open" at="8" width="1" repeat="4" stride="2"/>
          <reserved at="9" width="1"/><reserved at="11" width="1"/><reserved at="13" width="1"/><reserved at="15" width="1"/></case>
        <default><bits name="speed" at="8" width="8" units="mm/s"/></default>
      </switch>
    </view>
    <view name="MASK" words="mask[*]" item="all" if="kind" is="PUMP_STATE_OFF">
      <invalid value="0xffffffffffffffff"/>
      <bits name="low" at="0" width="128"/>
    </view>
  </message>
</mavlink-overlay>
"#;

fn dump(arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("acme.xml"), ACME).unwrap();
    fs::write(folder.path().join("acme.overlay.xml"), OVERLAY).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_mavgen"));
    let output = command.current_dir(folder.path()).args(["dump", "acme.xml"]).args(arguments).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn views_in_words() {
    let text = dump(&["--overlay", "acme.overlay.xml"]);
    let (_, views) = text.split_once("   27 mode: uint8_t\n").unwrap();
    assert_eq!(
        views.split("enum ").next().unwrap(),
        "  binding pump_mode: mode as PUMP_MODE, if kind is PUMP_STATE_ON
  view PUMP_STATUS: 16 bits of word[i], as pumps[3], count of them
    key id: id[i], unknown if 255
    unknown if id[i] is 0
    unknown if the bits are 0x0
           0 state: PUMP_STATE
       1..=7 angle: (raw - 8) / 4 deg signed
           8 open[4] every 2: yes or no, if mode is 1 3..=5
      8..=15 speed: raw mm/s, if mode is 0 2 6..=255
  view MASK: 128 bits of mask[*], as all, if kind is PUMP_STATE_OFF
    unknown if the bits are 0xffffffffffffffff
     0..=127 low: raw
"
    );
    assert!(!dump(&[]).contains("view"));
}

#[test]
fn views_in_json() {
    let model: Value = serde_json::from_str(&dump(&["--overlay", "acme.overlay.xml", "--json"])).unwrap();
    let message = &model["messages"][0];
    let condition = json!({"field": "kind", "value": 1});
    let binding = json!({"name": "pump_mode", "field": "mode", "enum": "PUMP_MODE", "condition": condition});
    assert_eq!(message["bindings"], json!([binding]));
    let pump = &message["views"][0];
    assert_eq!(
        (&pump["name"], &pump["getter"], &pump["words"]),
        (&json!("PUMP_STATUS"), &json!(null), &json!(["word[i]"]))
    );
    let key = json!({"name": "id", "field": "id[i]", "units": null, "invalid": 255});
    assert_eq!(pump["slots"], json!({"item": "pump", "items": "pumps", "length": 3, "count": "count", "keys": [key]}));
    assert_eq!(pump["invalid"], json!([{"field": "id[i]", "value": 0}, {"field": null, "value": 0}]));
    assert_eq!(pump["switch"], json!({"name": "mode", "field": "mode", "at": null, "width": null}));
    assert_eq!(
        pump["members"][1],
        json!({
            "name": "angle", "at": 1, "width": 7, "signed": true, "flag": false, "enum": null, "units": "deg",
            "scale": {"factor": 1, "bias": -8, "divisor": 4},
            "exact": {"units": "cdeg", "factor": 25, "bias": -200},
            "repeat": null, "when": null,
        })
    );
    assert_eq!(pump["members"][2]["repeat"], json!({"count": 4, "stride": 2}));
    assert_eq!(pump["members"][2]["when"], json!([[1, 1], [3, 5]]));
    let mask = &message["views"][1];
    assert_eq!((&mask["getter"], &mask["slots"], &mask["width"]), (&json!("all"), &json!(null), &json!(128)));
    assert_eq!(mask["invalid"], json!([{"field": null, "value": u64::MAX}]));
    let plain: Value = serde_json::from_str(&dump(&["--json"])).unwrap();
    assert_eq!((&plain["messages"][0]["views"], &plain["messages"][0]["bindings"]), (&json!([]), &json!([])));
}
