//! Which enums stay, and under which number.

use std::path::Path;

use super::*;
use crate::Builder;
use crate::ir::{Enum, Meaning, enums_of_message_mut};

const XML: &str = r#"<mavlink>
  <enums>
    <enum name="UNUSED"><entry value="0" name="UNUSED_A"/></enum>
    <enum name="STATE"><entry value="0" name="STATE_A"/></enum>
    <enum name="PARAM_OF_COMMAND"><entry value="0" name="PARAM_OF_COMMAND_A"/></enum>
    <enum name="PARAM_OF_PARAM"><entry value="0" name="PARAM_OF_PARAM_A"/></enum>
    <enum name="MAV_CMD">
      <entry value="1" name="MAV_CMD_A"><param index="1" enum="OTHER_COMMANDS"/><param index="2" enum="MAV_CMD"/></entry>
    </enum>
    <enum name="OTHER_COMMANDS">
      <entry value="1" name="OTHER_COMMANDS_A"><param index="7" enum="PARAM_OF_COMMAND"/></entry>
    </enum>
  </enums>
  <messages>
    <message id="1" name="PLAIN"><field type="uint8_t" name="a">x</field></message>
    <message id="2" name="STATEFUL"><field type="uint8_t" name="a" enum="STATE">x</field></message>
    <message id="3" name="STATEFUL_WIDE"><field type="uint16_t" name="a" enum="STATE">x</field></message>
    <message id="4" name="COMMAND"><field type="uint16_t" name="command" enum="MAV_CMD">x</field></message>
  </messages>
</mavlink>
"#;

const OVERLAY: &str = r#"<mavlink-overlay version="1" for="a.xml">
  <enums>
    <enum name="BOUND"><entry value="0" name="BOUND_A"/></enum>
    <enum name="PACKED"><entry value="0" name="PACKED_A"/></enum>
  </enums>
  <message name="PLAIN"><bind name="b" field="a" enum="BOUND"/></message>
  <message name="STATEFUL_WIDE">
    <view name="BITS" words="a" item="bits"><bits name="p" at="0" width="8" enum="PACKED"/><reserved at="8" width="8"/></view>
  </message>
</mavlink-overlay>
"#;

/// What is left of the dialect.
fn only(messages: &[&str]) -> Dialect {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.xml"), XML).unwrap();
    std::fs::write(folder.path().join("a.overlay.xml"), OVERLAY).unwrap();
    let builder = Builder::new(folder.path().join("a.xml")).overlay(folder.path().join("a.overlay.xml"));
    builder.messages(messages.iter().copied()).resolve().unwrap().dialect
}

fn enums(dialect: &Dialect) -> Vec<&str> {
    dialect.enums.iter().map(|values| values.name.text.as_str()).collect()
}

fn named<'d>(dialect: &'d Dialect, name: &str) -> &'d Enum {
    dialect.enums.iter().find(|values| values.name.text == name).unwrap()
}

#[test]
fn a_message_keeps_the_enums_of_its_fields() {
    let dialect = only(&["STATEFUL"]);
    assert_eq!(dialect.messages.len(), 1);
    assert_eq!(enums(&dialect), ["STATE"]);
    let id = dialect.messages[0].fields[0].values.unwrap().id();
    assert_eq!(dialect.enum_by_id(id).unwrap().name.text, "STATE");
}

#[test]
fn commands_keep_the_enums_of_their_params_and_so_on() {
    let dialect = only(&["COMMAND"]);
    assert_eq!(enums(&dialect), ["PARAM_OF_COMMAND", "MAV_CMD", "OTHER_COMMANDS"]);
    let params = |name| &named(&dialect, name).entries[0].command.as_ref().unwrap().params;
    let carried = |name, at: usize| dialect.enum_by_id(params(name)[at].enum_.unwrap()).unwrap().name.text.as_str();
    assert_eq!(
        (carried("MAV_CMD", 0), carried("MAV_CMD", 1), carried("OTHER_COMMANDS", 0)),
        ("OTHER_COMMANDS", "MAV_CMD", "PARAM_OF_COMMAND")
    );
}

#[test]
fn overlays_keep_what_they_say_of_kept_messages() {
    let dialect = only(&["PLAIN"]);
    assert_eq!(enums(&dialect), ["BOUND"]);
    assert_eq!(dialect.enum_by_id(dialect.messages[0].bindings[0].enum_).unwrap().name.text, "BOUND");
    let dialect = only(&["STATEFUL_WIDE"]);
    assert_eq!(enums(&dialect), ["STATE", "PACKED"]);
    let Meaning::Values(id) = dialect.messages[0].views[0].members[0].meaning else { panic!("no enum") };
    assert_eq!(dialect.enum_by_id(id).unwrap().name.text, "PACKED");
}

#[test]
fn what_is_kept_is_what_it_was() {
    let (all, one) = (only(&["*"]), only(&["STATEFUL"]));
    assert_eq!(named(&all, "STATE").repr, named(&one, "STATE").repr);
    assert_eq!(all.messages[1].crc_extra, one.messages[0].crc_extra);
    assert_eq!(all.files.len(), one.files.len());
    assert!(named(&one, "STATE").repr.size() == 2, "the field of a dropped message makes it so wide");
}

#[test]
fn patterns_and_names_add_up() {
    let names = |messages: &[&str]| -> Vec<String> {
        only(messages).messages.iter().map(|message| message.name.text.clone()).collect()
    };
    assert_eq!(names(&["STATEFUL*", "PLAIN", "PLAIN"]), ["PLAIN", "STATEFUL", "STATEFUL_WIDE"]);
    assert_eq!(names(&[" STATEFUL "]), ["STATEFUL"]);
}

#[test]
fn what_means_nothing_is_said_all_at_once() {
    let failure =
        Selection::new(["STATFUL", "PLAIN", "stateful", "NONE_*"]).unwrap().check(&[&only(&["*"])]).unwrap_err();
    let sentence = "no message of a.xml is called `NONE_*`, `STATFUL` (did you mean `STATEFUL`?), \
                    `stateful` (did you mean `STATEFUL`?)";
    assert_eq!(failure, sentence);
    for none in [&[][..], &[""], &["PLAIN", " "]] {
        assert!(Selection::new(none.iter().copied()).is_err(), "{none:?}");
    }
    assert!(Builder::new(Path::new("never-read.xml")).messages([""; 0]).resolve().is_err());
}

#[test]
fn one_selection_has_one_spelling() {
    let spelled = |names: &[&str]| Selection::new(names.iter().copied()).unwrap().to_string();
    assert_eq!(spelled(&["B", "A_*", "B"]), "A_*,B");
    assert_eq!(spelled(&["A_*", "B"]), "A_*,B");
}

/// The names of all enums that a message names, in order, after it was selected alone or with all others.
fn names_of(dialect: &Dialect, id: u32) -> Vec<String> {
    let mut message = dialect.messages.iter().find(|message| message.id == id).unwrap().clone();
    let named = format!("{message:?}").matches("EnumId(").count();
    let mut names = Vec::new();
    enums_of_message_mut(&mut message, &mut |id| names.push(dialect.enum_by_id(*id).unwrap().name.text.clone()));
    assert_eq!(names.len(), named, "the visit forgets none");
    names
}

#[test]
fn every_message_of_a_real_dialect_finds_its_enums_alone() {
    let xml = Path::new(env!("CARGO_MANIFEST_DIR")).join("../xml");
    let builder = Builder::new(xml.join("autoquad.xml")).overlay(xml.join("overlay/autoquad.xml"));
    let whole = builder.resolve().unwrap().dialect;
    let mut carrying = 0;
    for message in &whole.messages {
        let mut one = whole.clone();
        one.cut(&Selection::new([&*message.name.text]).unwrap().kept(&whole));
        assert_eq!(names_of(&one, message.id), names_of(&whole, message.id), "{}", message.name.text);
        carrying += usize::from(!one.enums.is_empty());
        for values in &one.enums {
            assert_eq!(format!("{:?}", values.origin), format!("{:?}", named(&whole, &values.name.text).origin));
        }
    }
    assert!(carrying > 50, "{carrying}");
}

#[test]
fn stars_stand_for_any_characters() {
    for (pattern, name, expected) in [
        ("PARAM_SET", "PARAM_SET", true),
        ("PARAM_SET", "PARAM_SET_2", false),
        ("param_set", "PARAM_SET", false),
        ("PARAM_*", "PARAM_SET", true),
        ("PARAM_*", "PARAM_", true),
        ("PARAM_*", "XPARAM_SET", false),
        ("*", "ANY", true),
        ("*_INT", "GPS_RAW_INT", true),
        ("*_INT", "GPS_INTEGER", false),
        ("GPS*INT", "GPS_RAW_INT", true),
        ("GPS*SINT", "GPSINT", false),
        ("*GPS*", "RAW_GPS_INT", true),
        ("A*B*C*D", "A_B_C_D", true),
        ("A*B*C*D", "A_C_B_D", false),
        ("A**A", "AA", true),
        ("A**A", "A", false),
        ("*A*A*", "A", false),
    ] {
        assert_eq!(Pattern::new(pattern).matches(name), expected, "{pattern} and {name}");
    }
}
