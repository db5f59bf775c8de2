//! One edit of a dialect is the change that it is, and no other.

use super::*;

const BASE: &str = r#"<mavlink>
  <version>3</version>
  <enums>
    <enum name="SPRAY_STATE">
      <entry value="0" name="SPRAY_STATE_OFF"/>
      <entry value="1" name="SPRAY_STATE_ON"/>
      <entry value="9" name="SPRAY_STATE_DRY"/>
    </enum>
    <enum name="SPRAY_CMD">
      <entry value="1" name="SPRAY_CMD_GO"><param index="1" label="Rate" units="s" minValue="1"/></entry>
    </enum>
    <enum name="NOZZLE"><entry value="1" name="NOZZLE_A"/><entry value="2" name="NOZZLE_B"/></enum>
  </enums>
  <messages>
    <message id="200" name="SPRAYER">
      <description>What the sprayer does.</description>
      <field type="uint8_t" name="state" enum="SPRAY_STATE">Whether it sprays.</field>
      <field type="uint16_t" name="level" units="cm" invalid="UINT16_MAX">What is left.</field>
      <field type="uint16_t" name="rate">How much.</field>
      <field type="uint32_t" name="time">When.</field>
      <field type="uint8_t" name="target_system">.</field>
      <field type="uint8_t" name="target_component">.</field>
      <extensions/>
      <field type="int16_t" name="heat">.</field>
      <field type="uint8_t" name="nozzle">.</field>
    </message>
    <message id="201" name="BEAT"><description>.</description><field type="uint8_t_mavlink_version" name="version"/></message>
  </messages>
</mavlink>"#;

/// The changes that an edit makes; the edited text must be there.
fn edit(from: &str, to: &str) -> Vec<String> {
    assert!(BASE.contains(from), "{from}");
    changes(BASE, &BASE.replacen(from, to, 1))
}

#[test]
fn a_dialect_is_the_same_as_itself() {
    assert_eq!(changes(BASE, BASE), [""; 0]);
    assert_eq!(changes(BASE, &BASE.replace("Whether it sprays.", "Otherwise said.")), [""; 0]);
    let (one, other) = (dialect(&[("acme_1.xml", BASE)], None), dialect(&[("acme_2.xml", BASE)], None));
    assert_eq!(compare(&one, &other, None).unwrap(), []);
}

#[test]
fn fields_on_the_wire() {
    assert_eq!(
        edit(r#"name="rate""#, r#"name="flow""#),
        [
            "wire! field SPRAYER.rate is called flow now (crc_extra 202, was 143)",
            "api! Sprayer.rate is called Sprayer.flow now"
        ]
    );
    assert_eq!(
        edit(r#"type="uint32_t" name="time""#, r#"type="uint64_t" name="time""#),
        [
            "wire! field SPRAYER.time is uint64_t, was uint32_t (crc_extra 127, was 143; 18 bytes, was 14; in MAVLink 1 15 bytes, was 11)",
            "api! Sprayer.time is u64, was u32"
        ]
    );
    assert_eq!(
        edit(r#"type="uint16_t" name="rate""#, r#"type="uint16_t[1]" name="rate""#),
        [
            "wire! field SPRAYER.rate is uint16_t[1], was uint16_t (crc_extra 120, was 143)",
            "api! Sprayer.rate is [u16; 1], was u16"
        ]
    );
    assert_eq!(
        edit("      <field type=\"uint32_t\" name=\"time\">When.</field>\n", ""),
        [
            "wire! field SPRAYER.time is gone: uint32_t (crc_extra 22, was 143; 10 bytes, was 14; in MAVLink 1 7 bytes, was 11)",
            "api! Sprayer.time is gone"
        ]
    );
    assert_eq!(
        edit("      <extensions/>", "      <field type=\"uint8_t\" name=\"new\"/><extensions/>"),
        [
            "wire! field SPRAYER.new is new: uint8_t (crc_extra 87, was 143; 15 bytes, was 14; in MAVLink 1 12 bytes, was 11)",
            "api! Sprayer.new is new"
        ]
    );
}

#[test]
fn extensions() {
    assert_eq!(
        edit("    </message>", "<field type=\"uint8_t[2]\" name=\"new\" invalid=\"[0]\"/></message>"),
        ["wire field SPRAYER.new is new: uint8_t[2], an extension (16 bytes, was 14)", "api! Sprayer.new is new"]
    );
    assert_eq!(
        edit("<extensions/>", "<extensions/><field type=\"uint8_t\" name=\"new\"/>"),
        ["wire! field SPRAYER.new is new: uint8_t, an extension (15 bytes, was 14)", "api! Sprayer.new is new"]
    );
    let (heat, nozzle) =
        (r#"<field type="int16_t" name="heat">.</field>"#, r#"<field type="uint8_t" name="nozzle">.</field>"#);
    assert_eq!(
        edit(&format!("{heat}\n      {nozzle}"), &format!("{nozzle}\n      {heat}")),
        ["wire! field SPRAYER.heat begins at byte 12, was 11"]
    );
    assert_eq!(
        edit(r#"name="nozzle""#, r#"name="spout""#),
        ["wire field SPRAYER.nozzle is called spout now", "api! Sprayer.nozzle is called Sprayer.spout now"]
    );
    assert_eq!(
        edit(r#"int16_t" name="heat""#, r#"uint16_t" name="heat""#),
        ["wire! field SPRAYER.heat is uint16_t, was int16_t", "api! Sprayer.heat is u16, was i16"]
    );
    let moved = edit(&format!("<extensions/>\n      {heat}"), &format!("{heat}<extensions/>"));
    assert_eq!(moved.len(), 1);
    assert!(
        moved[0].starts_with("wire! field SPRAYER.heat is a plain field, was an extension (crc_extra"),
        "{moved:?}"
    );
}

#[test]
fn order() {
    let field = |ty: &str, name: &str, rest: &str| format!("<field type=\"{ty}\" name=\"{name}\"{rest}</field>");
    let level = field("uint16_t", "level", " units=\"cm\" invalid=\"UINT16_MAX\">What is left.");
    let (rate, time) = (field("uint16_t", "rate", ">How much."), field("uint32_t", "time", ">When."));
    assert_eq!(
        edit(&format!("{level}\n      {rate}"), &format!("{rate}\n      {level}")),
        ["wire! field SPRAYER.level begins at byte 6, was 4 (crc_extra 205, was 143)"]
    );
    assert_eq!(
        edit(&format!("{rate}\n      {time}"), &format!("{time}\n      {rate}")),
        ["metadata field SPRAYER.rate: place in the XML 4, was 3"],
        "fields of different sizes are sorted on the wire anyway"
    );
}

#[test]
fn messages() {
    assert_eq!(
        edit(r#"name="BEAT""#, r#"name="PULSE""#),
        ["wire! message BEAT is called PULSE now (crc_extra 61, was 193)", "api! Beat is called Pulse now"]
    );
    assert_eq!(edit(r#"id="201""#, r#"id="202""#), ["wire! message BEAT has the id 202, was 201"]);
    let beat = r#"<message id="201" name="BEAT"><description>.</description><field type="uint8_t_mavlink_version" name="version"/></message>"#;
    assert_eq!(edit(beat, ""), ["wire! message BEAT is gone: id 201", "api! Beat is gone"]);
    let new = r#"<message id="202" name="NEW"><description>.</description><field type="uint8_t" name="x"/></message></messages>"#;
    assert_eq!(edit("</messages>", new), ["wire message NEW is new: id 202", "api New is new"]);
    let other =
        r#"<message id="201" name="OTHER"><description>.</description><field type="uint16_t" name="x"/></message>"#;
    assert_eq!(
        edit(beat, other),
        [
            "wire! message BEAT is OTHER now, with other fields (crc_extra 246, was 193; 2 bytes, was 1)",
            "api! Beat is gone",
            "api Other is new"
        ],
        "another layout is another message, on which the wire has one opinion"
    );
    let wider = r#"<message id="201" name="WIDER"><description>.</description><field type="uint16_t" name="version"/></message>"#;
    assert_eq!(
        edit(beat, wider),
        [
            "wire! message BEAT is WIDER now, with other fields (crc_extra 218, was 193; 2 bytes, was 1)",
            "api! Beat is called Wider now",
            "api! Beat.version is u16, was u8",
            "metadata field BEAT.version: no constant, was uint8_t_mavlink_version"
        ],
        "renamed and widened"
    );
    let elsewhere = beat.replace("201", "202").replace("BEAT", "PULSE");
    assert_eq!(
        edit(beat, &elsewhere),
        [
            "wire! message BEAT is gone: id 201",
            "wire message PULSE is new: id 202",
            "api! Beat is gone",
            "api Pulse is new"
        ],
        "another id and another name are another message"
    );
}

#[test]
fn entries() {
    assert_eq!(
        edit(r#"value="9" name="SPRAY_STATE_DRY""#, r#"value="8" name="SPRAY_STATE_DRY""#),
        ["enums! entry SPRAY_STATE.SPRAY_STATE_DRY is 8, was 9"]
    );
    assert_eq!(
        edit("SPRAY_STATE_DRY", "SPRAY_STATE_EMPTY"),
        [
            "enums entry SPRAY_STATE.SPRAY_STATE_DRY is called SPRAY_STATE_EMPTY now",
            "api! SprayState::DRY is called SprayState::EMPTY now"
        ]
    );
    assert_eq!(
        edit(r#"<entry value="9" name="SPRAY_STATE_DRY"/>"#, ""),
        ["enums! entry SPRAY_STATE.SPRAY_STATE_DRY is gone: 9", "api! SprayState::DRY is gone"]
    );
    assert_eq!(
        edit("<entry value=\"9\"", "<entry value=\"2\" name=\"SPRAY_STATE_WET\"/><entry value=\"9\""),
        ["enums entry SPRAY_STATE.SPRAY_STATE_WET is new: 2", "api SprayState::WET is new"]
    );
}

#[test]
fn enums() {
    assert_eq!(
        edit("<enum name=\"NOZZLE\"", "<enum name=\"SPOUT\""),
        ["enums enum NOZZLE is called SPOUT now", "api! Nozzle is called Spout now"]
    );
    let gone = r#"<enum name="NOZZLE"><entry value="1" name="NOZZLE_A"/><entry value="2" name="NOZZLE_B"/></enum>"#;
    assert_eq!(edit(gone, ""), ["enums! enum NOZZLE is gone", "api! Nozzle is gone"]);
    assert_eq!(
        edit("</enums>", "<enum name=\"NEW\"><entry value=\"0\" name=\"NEW_A\"/></enum></enums>"),
        ["enums enum NEW is new", "api New is new"]
    );
    assert_eq!(
        edit("<enum name=\"NOZZLE\"", "<enum bitmask=\"true\" name=\"NOZZLE\""),
        ["api! Nozzle is flags of u8, was an enum of u8"]
    );
    assert_eq!(
        edit(r#"value="2" name="NOZZLE_B""#, r#"value="300" name="NOZZLE_B""#),
        ["enums! entry NOZZLE.NOZZLE_B is 300, was 2", "api! Nozzle is an enum of u16, was an enum of u8"]
    );
}

#[test]
fn rust_alone() {
    assert_eq!(edit(r#"name="nozzle""#, r#"name="nozzle" enum="NOZZLE""#), ["api! Sprayer.nozzle is Nozzle, was u8"]);
    assert_eq!(edit(r#" enum="SPRAY_STATE""#, ""), ["api! Sprayer.state is u8, was SprayState"]);
    assert_eq!(
        edit(r#"name="rate""#, r#"name="rate" invalid="0""#),
        ["api Sprayer::rate() is new", "metadata field SPRAYER.rate: invalid 0, was not there"]
    );
    assert_eq!(
        edit(r#" invalid="UINT16_MAX""#, ""),
        ["api! Sprayer::level() is gone", "metadata field SPRAYER.level: no invalid, was 65535"]
    );
    assert_eq!(
        edit("<description>What the sprayer does.", "<deprecated since='2024-01' replaced_by='X'/><description>"),
        ["api Sprayer is deprecated"]
    );
    assert_eq!(
        edit(
            r#"<entry value="9" name="SPRAY_STATE_DRY"/>"#,
            "<entry value='9' name='SPRAY_STATE_DRY'><deprecated since='2024-01' replaced_by='X'/></entry>"
        ),
        ["api SprayState::DRY is deprecated"]
    );
    assert_eq!(
        edit("<version>3", "<version>4"),
        ["api Beat.version is 4 by default, was 3", "metadata acme: version 4, was 3"]
    );
}

#[test]
fn what_neither_shows() {
    for (from, to, change) in [
        (r#" units="cm""#, r#" units="mm""#, "field SPRAYER.level: units mm, was cm"),
        ("\"UINT16_MAX\"", "\"0\"", "field SPRAYER.level: invalid 0, was 65535"),
        (r#"name="rate""#, r#"name="rate" minValue="2""#, "field SPRAYER.rate: minValue 2, was not there"),
        (r#"name="rate""#, r#"name="rate" multiplier="1E-2""#, "field SPRAYER.rate: multiplier 1E-2, was not there"),
        (r#"name="rate""#, r#"name="rate" instance="true""#, "field SPRAYER.rate: instance true, was false"),
        (r#" label="Rate""#, r#" label="Flow""#, "entry SPRAY_CMD.SPRAY_CMD_GO param 1: label Flow, was Rate"),
        (r#" minValue="1""#, "", "entry SPRAY_CMD.SPRAY_CMD_GO param 1: no minValue, was 1"),
        (
            r#"units="s""#,
            r#"units="s" enum="NOZZLE""#,
            "entry SPRAY_CMD.SPRAY_CMD_GO param 1: enum NOZZLE, was not there",
        ),
        (
            "SPRAY_CMD_GO\"",
            "SPRAY_CMD_GO\" hasLocation=\"true\"",
            "entry SPRAY_CMD.SPRAY_CMD_GO: hasLocation true, was false",
        ),
        ("<description>What", "<wip/><description>What", "message SPRAYER: lifecycle wip, was not there"),
    ] {
        assert_eq!(edit(from, to), [format!("metadata {change}")]);
    }
}
