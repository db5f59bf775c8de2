//! A legal model, and every way in which somebody could make it illegal: each is a fault, and none a panic.

use std::num::NonZeroU8;

use super::*;
use crate::diag::Diagnostics;
use crate::ir::{
    Access, Condition, FieldIndex, Invalid, Meaning, Member, Message, Place, Presence, Record, Repeat, Repr, Scalar,
    Scope, Sentinel, Slots, SwitchOn, Values, View, ViewSentinel, Word,
};
use crate::read::{Loaded, read, read_overlay};
use crate::resolve::passes;
use crate::source::Sources;

const DEFINITION: &str = "<mavlink><enums>\
    <enum name='STATE'><entry name='STATE_OFF' value='0'/><entry name='STATE_ON' value='1'/></enum>\
    <enum name='MAV_CMD'><entry name='MAV_CMD_A' value='1'>\
      <param index='1' minValue='0' default='1' enum='STATE'>a</param><param index='2'>b</param></entry></enum>\
    </enums><messages>\
    <message id='1' name='PUMP'><description/>\
      <field type='uint8_t' name='state' enum='STATE'/><field type='int8_t' name='wide' enum='STATE'/>\
      <field type='uint16_t' name='flow' invalid='UINT16_MAX' maxValue='9'/><field type='float' name='heat' invalid='NaN'/>\
      <field type='uint8_t' name='raw'/><field type='uint8_t' name='count'/>\
      <field type='uint8_t[2]' name='low'/><field type='uint8_t[2]' name='high'/><field type='uint16_t[3]' name='other'/>\
      <field type='uint8_t' name='kind'/><extensions/><field type='int8_t' name='late'/></message>\
    <message id='2' name='VALVE'><description/><field type='uint8_t' name='a'/></message>\
    </messages></mavlink>";

const OVERLAY: &str = "<mavlink-overlay version='1' for='a.xml'><message name='PUMP'>\
    <bind name='bound' field='raw' enum='STATE' if='kind' is='3'/>\
    <view name='NOZZLE' words='low[i] high[i]' item='nozzle' items='nozzles' count='count' if='kind' is='3'>\
      <key name='age' field='low[i]' invalid='255'/><invalid field='kind' value='0'/><invalid value='0'/>\
      <bits name='open' at='0' width='1'/><bits name='state' at='1' width='1' enum='STATE'/>\
      <bits name='heat' at='2' width='3' scale='1/10' units='degC' exact='ddegC'/>\
      <bits name='steps' at='5' width='1' repeat='2'/><reserved at='7' width='1'/>\
      <switch field='kind'><case value='0..=3'><bits name='flow' at='8' width='8'/></case>\
        <default><bits name='error' at='8' width='8'/></default></switch></view>\
    <view name='FLOW' words='flow' item='flow_bits' partial='true'><bits name='mode' at='0' width='4'/>\
      <switch bits='mode'><case value='0'><bits name='x' at='4' width='4'/></case>\
        <default><reserved at='4' width='4'/></default></switch></view>\
    <view name='TANK' item='tank' if='kind' is='4'><value name='heat' field='late' invalid='3'/>\
      <value name='used' field='count'/></view>\
    </message></mavlink-overlay>";

fn legal() -> Dialect {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let file = read(sources.add("a.xml", DEFINITION), &sources, &mut diagnostics);
    let overlay = read_overlay(sources.add("o.xml", OVERLAY), &sources, &mut diagnostics);
    let loaded = Loaded {
        name: "a".to_owned(),
        files: vec![file.into()],
        includes: vec![Vec::new()],
        overlays: vec![overlay.into()],
        ..Loaded::default()
    };
    let partial = passes(&loaded, &sources, &mut diagnostics).unwrap();
    assert!(!diagnostics.has_errors(), "{diagnostics:#?}");
    partial.dialect
}

fn pump(dialect: &mut Dialect) -> &mut Message {
    &mut dialect.messages[0]
}

/// Changes a view in place.
fn in_view(dialect: &mut Dialect, name: &str, change: impl FnOnce(&mut View)) {
    change(pump(dialect).views.iter_mut().find(|view| view.name.text == name).unwrap());
}

fn in_member(dialect: &mut Dialect, name: &str, change: impl FnOnce(&mut Member)) {
    in_view(dialect, "NOZZLE", |view| {
        change(view.members.iter_mut().find(|member| member.name.name.text == name).unwrap());
    });
}

fn in_slots(dialect: &mut Dialect, change: impl FnOnce(&mut Slots)) {
    in_view(dialect, "NOZZLE", |view| match &mut view.access {
        Access::Slots(slots) => change(slots),
        Access::Once { .. } | Access::Record(_) => panic!("no slots"),
    });
}

fn in_record(dialect: &mut Dialect, change: impl FnOnce(&mut Record)) {
    in_view(dialect, "TANK", |view| match &mut view.access {
        Access::Record(record) => change(record),
        Access::Once { .. } | Access::Slots(_) => panic!("no record"),
    });
}

#[test]
fn what_resolve_yields_is_legal() {
    let dialect = legal();
    assert_eq!(dialect.validate().map(|valid| valid.messages.len()), Ok(2));
}

type Change = fn(&mut Dialect);

const NONE: FieldIndex = FieldIndex(99);
const NO_ENUM: EnumId = EnumId(99);
const NO_FILE: FileIndex = FileIndex(99);

/// What is changed, and what is said of it.
#[rustfmt::skip]
const ILLEGAL: &[(&str, Change)] = &[
    ("its first file is no definition", |d| d.files.clear()),
    ("its first file is no definition", |d| d.files[0].overlay = true),
    ("a definition stands behind an overlay", |d| { let file = d.files[0].clone(); d.files.push(file); }),
    ("it includes a file that does not exist", |d| d.files[0].includes.push(NO_FILE)),
    ("enum `STATE` stands twice", |d| d.enums[1].name = d.enums[0].name.clone()),
    ("its name is none: empty", |d| d.enums[0].name.text.clear()),
    ("it is of a file that does not exist", |d| d.enums[0].origin.file = NO_FILE),
    ("it is of a file that does not exist", |d| d.enums[0].named_in = NO_FILE),
    ("it is of a file that does not exist", |d| d.enums[0].defined_in = NO_FILE),
    ("an overlay of it is none", |d| d.enums[0].origin.overlays.push(FileIndex(0))),
    ("it has no entries", |d| d.enums[0].entries.clear()),
    ("its values do not rise", |d| d.enums[0].entries.reverse()),
    ("its values do not rise", |d| d.enums[0].entries[0].value = 1),
    ("entry `STATE_ON` stands twice", |d| d.enums[0].entries[0].name = d.enums[0].entries[1].name.clone()),
    ("its name is none: has other characters", |d| d.enums[0].entries[0].name.text = "a b".to_owned()),
    ("its value does not fit the enum", |d| d.enums[0].entries[1].value = 300),
    ("the indices of its params do not rise", |d| d.enums[1].entries[0].command.as_mut().unwrap().params.reverse()),
    ("its index is not one from 1 to 7", |d| d.enums[1].entries[0].command.as_mut().unwrap().params[1].index = 8),
    ("it names an enum that does not exist", |d| d.enums[1].entries[0].command.as_mut().unwrap().params[0].enum_ = Some(NO_ENUM)),
    ("its default is infinite", |d| d.enums[1].entries[0].command.as_mut().unwrap().params[0].default = Some(f64::INFINITY)),
    ("a limit is not finite", |d| d.enums[1].entries[0].command.as_mut().unwrap().params[0].limits.max = Some(f64::NAN)),
    ("the ids of its messages do not rise", |d| d.messages.reverse()),
    ("the ids of its messages do not rise", |d| d.messages[1].id = 1),
    ("message `PUMP` stands twice", |d| d.messages[1].name = d.messages[0].name.clone()),
    ("its id is more than 24 bits", |d| d.messages[1].id = 1 << 24),
    ("its name is none: begins with a digit", |d| d.messages[0].name.text = "1A".to_owned()),
    ("it has not 1 to 64 fields", |d| d.messages[1].fields.clear()),
    ("it has not 1 to 64 fields", |d| { let field = d.messages[1].fields[0].clone(); d.messages[1].fields = vec![field; 65]; }),
    ("field `state` stands twice", |d| pump(d).fields[1].name = pump(d).fields[0].name.clone()),
    ("an extension stands before a field that is none", |d| pump(d).fields[0].extension = true),
    ("its lengths are not the sum of its fields", |d| pump(d).len_v1 += 1),
    ("its lengths are not the sum of its fields", |d| pump(d).len_v2 = 0),
    ("a field does not lie where the wire has it", |d| pump(d).fields[0].offset += 1),
    ("its `crc_extra` is another", |d| pump(d).crc_extra ^= 1),
    ("its `crc_extra` is another", |d| pump(d).name.text = "PUMPS".to_owned()),
    ("a limit is not finite", |d| pump(d).fields[2].limits.min = Some(f64::NEG_INFINITY)),
    ("it is an array of versions", |d| { pump(d).fields[6].ty.scalar = Scalar::Version(3); }),
    ("it names an enum that does not exist", |d| pump(d).fields[0].values = Some(Values::Typed(NO_ENUM))),
    ("it is no integer and carries an enum", |d| pump(d).fields[3].values = Some(Values::Converted(EnumId(0)))),
    ("it is typed although", |d| pump(d).fields[1].values = Some(Values::Typed(EnumId(0)))),
    ("it is typed although", |d| pump(d).fields[0].values = Some(Values::Converted(EnumId(0)))),
    ("its sentinel is for an array", |d| pump(d).fields[2].invalid = Some(Invalid { scope: Scope::Whole, sentinel: Sentinel::Integer(0) })),
    ("it cannot have its sentinel", |d| pump(d).fields[2].invalid = Some(Invalid { scope: Scope::Each, sentinel: Sentinel::Integer(-1) })),
    ("it cannot have its sentinel", |d| pump(d).fields[2].invalid = Some(Invalid { scope: Scope::Each, sentinel: Sentinel::NotANumber })),
    ("it cannot have its sentinel", |d| pump(d).fields[3].invalid = Some(Invalid { scope: Scope::Each, sentinel: Sentinel::Float(1e300) })),
    ("its name is none", |d| pump(d).bindings[0].name.name.text = "é".to_owned()),
    ("it names an enum that does not exist", |d| pump(d).bindings[0].enum_ = NO_ENUM),
    ("it names a field that does not exist", |d| pump(d).bindings[0].field = NONE),
    ("its field is no scalar as wide as the enum", |d| pump(d).bindings[0].field = FieldIndex(2)),
    ("its field is no scalar as wide as the enum", |d| pump(d).bindings[0].field = FieldIndex(0)),
    ("its condition never holds", |d| pump(d).bindings[0].condition = Some(Condition { field: FieldIndex(9), value: 256, enum_: None })),
    ("its condition never holds", |d| pump(d).bindings[0].condition = Some(Condition { field: NONE, value: 0, enum_: None })),
    ("its condition never holds", |d| pump(d).bindings[0].condition = Some(Condition { field: FieldIndex(3), value: 0, enum_: None })),
    ("it names an enum that does not exist", |d| pump(d).bindings[0].condition = Some(Condition { field: FieldIndex(9), value: 0, enum_: Some(NO_ENUM) })),
    ("a word is of a field that does not exist", |d| in_view(d, "FLOW", |v| v.words[0] = Word::Joined(NONE))),
    ("a word stands twice", |d| in_view(d, "NOZZLE", |v| v.words[1] = v.words[0])),
    ("a word is of a type that is none", |d| in_view(d, "FLOW", |v| v.words[0] = Word::One(Place { field: FieldIndex(10), element: false }))),
    ("a word is an element of a scalar, or a whole array", |d| in_view(d, "FLOW", |v| v.words[0] = Word::Joined(FieldIndex(2)))),
    ("its width is not that of its words", |d| in_view(d, "FLOW", |v| v.width = 8)),
    ("its width is not that of its words", |d| in_view(d, "FLOW", |v| v.words.clear())),
    ("a word is an element, and there are no slots", |d| in_view(d, "NOZZLE", |v| { let name = v.members[0].name.clone(); v.access = Access::Once { getter: name }; })),
    ("a word is no element, and there are slots", |d| in_view(d, "NOZZLE", |v| v.words[0] = Word::Joined(FieldIndex(6)))),
    ("it names an element of what has none for each slot", |d| in_slots(d, |s| s.length = NonZeroU8::MAX)),
    ("its count is no scalar unsigned integer", |d| in_slots(d, |s| s.count = Some(NONE))),
    ("its count is no scalar unsigned integer", |d| in_slots(d, |s| s.count = Some(FieldIndex(3)))),
    ("its name is none", |d| in_slots(d, |s| s.item.text = String::new())),
    ("its name is none", |d| in_slots(d, |s| s.items.name.text = "_".to_owned())),
    ("it names a field that does not exist", |d| in_slots(d, |s| s.keys[0].place.field = NONE)),
    ("a field cannot have the value of its sentinel", |d| in_slots(d, |s| s.keys[0].invalid = Some(256))),
    ("it names an element of what has none for each slot", |d| in_slots(d, |s| s.keys[0].place.field = FieldIndex(8))),
    ("a field cannot have the value of its sentinel", |d| in_view(d, "NOZZLE", |v| v.invalid[0] = ViewSentinel::Field(Place { field: FieldIndex(3), element: false }, 0))),
    ("its words cannot have the value of its sentinel", |d| in_view(d, "NOZZLE", |v| v.invalid[1] = ViewSentinel::Words(1 << 16))),
    ("its switch looks at a field that is no such unsigned integer", |d| in_view(d, "NOZZLE", |v| v.switch.as_mut().unwrap().on = SwitchOn::Field(Place { field: FieldIndex(9), element: false }, Repr::U16))),
    ("it names a field that does not exist", |d| in_view(d, "NOZZLE", |v| v.switch.as_mut().unwrap().on = SwitchOn::Field(Place { field: NONE, element: false }, Repr::U8))),
    ("its switch looks at bits that are not there", |d| in_view(d, "FLOW", |v| v.switch.as_mut().unwrap().on = SwitchOn::Bits { at: 12, width: 5 })),
    ("its switch looks at bits that are not there", |d| in_view(d, "FLOW", |v| v.switch.as_mut().unwrap().on = SwitchOn::Bits { at: 0, width: 0 })),
    ("it has values, and bits as well", |d| in_view(d, "TANK", |v| v.width = 8)),
    ("it has no values", |d| in_record(d, |r| r.values.clear())),
    ("a value is twice in it, or asked by its condition", |d| in_record(d, |r| r.values[1].place = r.values[0].place)),
    ("a value is twice in it, or asked by its condition", |d| {
        let asked = pump(d).views[2].condition.unwrap().field;
        in_record(d, |r| r.values[1].place.field = asked);
    }),
    ("it names an element of what has none for each slot, or a whole array", |d| in_record(d, |r| r.values[0].place.element = true)),
    ("a field cannot have the value of its sentinel", |d| in_record(d, |r| r.values[0].invalid = Some(300))),
    ("its condition never holds", |d| in_view(d, "TANK", |v| v.condition.as_mut().unwrap().value = 1 << 40)),
    ("it hangs on a switch that there is not", |d| in_view(d, "NOZZLE", |v| v.switch = None)),
    ("its name is none", |d| in_member(d, "open", |m| m.name.name.text = "a-b".to_owned())),
    ("it has no bits", |d| in_member(d, "open", |m| m.width = 0)),
    ("it lies outside of the words", |d| in_member(d, "flow", |m| m.at = 9)),
    ("it lies outside of the words", |d| in_member(d, "flow", |m| (m.at, m.width) = (255, 255))),
    ("its repetition is none", |d| in_member(d, "steps", |m| m.repeat = Some(Repeat { count: 1, stride: 1 }))),
    ("its repetition is none", |d| in_member(d, "steps", |m| m.repeat = Some(Repeat { count: 2, stride: 0 }))),
    ("it lies outside of the words", |d| in_member(d, "steps", |m| m.repeat = Some(Repeat { count: 255, stride: 255 }))),
    ("it has bits of a member that stands before it", |d| in_member(d, "state", |m| m.at = 0)),
    ("one bit has no sign", |d| in_member(d, "open", |m| m.signed = true)),
    ("a flag is one bit", |d| in_member(d, "flow", |m| m.meaning = Meaning::Flag)),
    ("it names an enum that does not exist", |d| in_member(d, "state", |m| m.meaning = Meaning::Values(NO_ENUM))),
    ("its enum does not hold all values of its bits", |d| in_view(d, "FLOW", |v| { v.members[0].meaning = Meaning::Values(EnumId(0)); v.members[0].width = 9; })),
    ("its scale is none", |d| in_member(d, "heat", |m| if let Meaning::Scaled(scaled) = &mut m.meaning { scaled.factor = 0; })),
    ("its scale is none", |d| in_member(d, "heat", |m| if let Meaning::Scaled(scaled) = &mut m.meaning { scaled.divisor = 0; })),
    ("its exact getter has no factor, or no name", |d| in_member(d, "heat", |m| if let Meaning::Scaled(scaled) = &mut m.meaning { scaled.exact.as_mut().unwrap().units.clear(); })),
    ("the values of its switch are not sorted and apart, or all", |d| in_member(d, "flow", |m| m.presence = Presence::When(Vec::new()))),
    ("the values of its switch are not sorted and apart, or all", |d| in_member(d, "flow", |m| m.presence = Presence::When(vec![0..=255]))),
    ("the values of its switch are not sorted and apart, or all", |d| in_member(d, "flow", |m| m.presence = Presence::When(vec![0..=3, 4..=5]))),
    ("the values of its switch are not sorted and apart, or all", |d| in_member(d, "flow", |m| m.presence = Presence::When(vec![9..=9, 0..=3]))),
    ("the values of its switch are not sorted and apart, or all", |d| in_member(d, "flow", |m| m.presence = Presence::When(vec![0..=256]))),
    ("it has bits of a member that stands before it", |d| in_member(d, "error", |m| m.presence = Presence::When(vec![3..=255]))),
];

#[test]
fn everything_illegal_is_a_fault() {
    let legal = legal();
    for (index, (problem, change)) in ILLEGAL.iter().enumerate() {
        let mut dialect = legal.clone();
        change(&mut dialect);
        let faults = dialect.validate().map(|_| ()).unwrap_err();
        let said: Vec<String> = faults.iter().map(Fault::to_string).collect();
        assert!(said.iter().any(|said| said.contains(problem)), "{index}, {problem}: {said:#?}");
    }
}
