//! What dialects and their parts are called, where that hangs on something else.

use super::*;
use crate::read::{Loaded, read, read_overlay};
use crate::roots::{Named, resolve};
use crate::source::Sources;

/// Names a dialect of these files, each a name and what stands in its `<mavlink>`; the first includes the others.
fn named(files: &[(&str, &str)], overlay: Option<&str>) -> Named {
    let (mut sources, mut diagnostics, mut loaded) = (Sources::default(), Diagnostics::default(), Loaded::default());
    loaded.name = files[0].0.trim_end_matches(".xml").to_owned();
    for (name, content) in files {
        let id = sources.add(*name, format!("<mavlink>{content}</mavlink>"));
        loaded.files.push(read(id, &sources, &mut diagnostics).into());
    }
    loaded.includes = vec![Vec::new(); files.len()];
    loaded.includes[0] = (1..files.len()).map(crate::ir::FileIndex).collect();
    if let Some(content) = overlay {
        let root = format!("<mavlink-overlay version='1' for='{}'>{content}</mavlink-overlay>", files[0].0);
        let id = sources.add("overlay.xml", root);
        loaded.overlays.push(read_overlay(id, &sources, &mut diagnostics).into());
    }
    let named = resolve(&loaded, &sources, &mut diagnostics);
    named.unwrap_or_else(|| panic!("{:#?}", diagnostics.iter().map(|one| &one.message).collect::<Vec<_>>()))
}

fn message(name: &str, fields: &str) -> String {
    format!("<message id='{}' name='{name}'>{fields}</message>", name.len())
}

fn enumeration(name: &str, entries: &[&str]) -> String {
    let entries = entries.iter().enumerate().map(|(value, name)| format!("<entry name='{name}' value='{value}'/>"));
    format!("<enums><enum name='{name}'>{}</enum></enums>", entries.collect::<String>())
}

#[test]
fn what_a_message_is_called_no_enum_and_no_dialect_is() {
    let messages = message("STATUS", "<field type='uint8_t' name='type'/><field type='uint8_t' name='Index'/>")
        + &message("A", "<field type='uint8_t' name='x'/>")
        + &message("ITERATOR", "<field type='uint8_t' name='self'/>");
    let content = format!(
        "{}{}<messages>{messages}</messages>",
        enumeration("STATUS", &["STATUS_OK", "STATUS_NOT"]),
        enumeration("OPTION", &["OPTION_A", "OPTION_B"])
    );
    let Named { names, .. } = named(&[("a.xml", &content)], None);
    let types: Vec<&str> = names.enums.iter().map(|one| one.ty.as_str()).collect();
    assert_eq!((names.dialect.as_str(), types), ("ADialect", vec!["StatusEnum", "Option_"]));
    let messages: Vec<_> = names.messages.iter().map(|one| (one.ty.as_str(), one.module.as_str())).collect();
    assert_eq!(messages, [("A", "a"), ("Status", "status"), ("Iterator_", "iterator")]);
    assert_eq!(names.messages[1].fields, ["type", "index"]);
    assert_eq!(names.messages[2].fields, ["self_"]);
}

/// A dialect that adds entries to an enum of a file that it includes renames none there.
#[test]
fn the_owner_decides_on_the_prefix() {
    let top = "<include>base.xml</include>".to_owned() + &enumeration("E", &["ACME_X"]).replace("'0'", "'9'");
    let base = enumeration("E", &["E_A", "E_B"]);
    let Named { names, .. } = named(&[("top.xml", &top), ("base.xml", &base)], None);
    assert_eq!(names.enums[0].constants, ["A", "B", "ACME_X"]);
}

const SLOTS: &str = "<message name='PUMPS'>\
    <bind name='typeOf' field='kind' enum='KIND'/>\
    <view name='PUMP_BITS' words='bits[i]' item='pumpState' items='pumpStates'>\
      <key name='age' field='age[i]' units='ms'/>\
      <bits name='volts' at='0' width='12' scale='1/100' units='V' exact='mV'/>\
      <switch field='kind'><case value='0'><bits name='low' at='12' width='4'/></case>\
        <default><reserved at='12' width='4'/></default></switch>\
    </view></message>";

#[test]
fn views_name_methods_and_types() {
    let fields = "<field type='uint16_t[4]' name='bits'/><field type='uint16_t[4]' name='age'/>\
        <field type='uint8_t' name='kind'/>";
    let content =
        format!("{}<messages>{}</messages>", enumeration("KIND", &["KIND_A", "KIND_B"]), message("PUMPS", fields));
    let Named { dialect, names } = named(&[("a.xml", &content)], Some(SLOTS));
    let own = &names.messages[0];
    assert_eq!(own.bindings, ["type_of"]);
    let view = &own.views[0];
    assert_eq!(
        (view.ty.as_str(), view.module.as_str(), view.switch.as_deref()),
        ("PumpBits", "pump_bits", Some("kind"))
    );
    assert_eq!(view.members, ["volts", "low"]);
    let ViewNames { getter, keys, slots: Some(SlotNames { ty: item, items }), .. } = view else { panic!("slots") };
    assert_eq!((item.as_str(), getter.as_str(), items.as_str()), ("PumpState", "pump_state", "pump_states"));
    assert_eq!(keys, &["age_ms"]);
    let member = &dialect.messages[0].views[0].members[0];
    assert_eq!((member.name.name.text.as_str(), member.name.shown()), ("volts", "volts".to_owned()));
}

/// What is selected keeps its name, also where what named it otherwise is left out.
#[test]
fn a_selection_renames_nothing() {
    let content = format!(
        "{}<messages>{}{}</messages>",
        enumeration("STATUS", &["STATUS_OK", "STATUS_NOT"]),
        message("STATUS", "<field type='uint8_t' name='x'/>"),
        message("OF", "<field type='uint8_t' name='x' enum='STATUS'/>")
    );
    let mut named = named(&[("a.xml", &content)], None);
    let kept = Kept::of(&named.dialect, |message| message.name.text == "OF", |_| false);
    named.cut(&kept);
    let Named { dialect, names } = named;
    assert_eq!((dialect.messages.len(), names.messages.len(), names.messages[0].ty.as_str()), (1, 1, "Of"));
    assert_eq!(names.enums[0].ty, "StatusEnum");
}

/// Of two fields whose accessors share a name the first has them; a field has none that every message has.
#[test]
fn accessors_are_decided_here() {
    let fields = ["x", "set_x", "info", "y"].map(|name| format!("<field type='uint8_t' name='{name}' invalid='0'/>"));
    let plain = "<field type='uint8_t' name='plain'/><field type='char[4]' name='text' invalid='0'/>";
    let content = format!("<messages>{}</messages>", message("M", &(fields.concat() + plain)));
    let Named { names, .. } = named(&[("a.xml", &content)], None);
    assert_eq!(names.messages[0].accessors, [FieldIndex(0), FieldIndex(3)]);
}
