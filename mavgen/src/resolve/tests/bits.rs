//! Views: what the bits of a message mean.

use std::path::Path;

use super::{Outcome, enumeration, message, overlaid};
use crate::diag::{Code, Diagnostics};
use crate::ir::{Access, Dialect, Meaning, Member, Presence, Scaled, SwitchOn, View, ViewSentinel, Word};
use crate::read::load;
use crate::roots::resolve;
use crate::source::Sources;

/// A member in short: `temperature 52+9 (raw * 1 + -128) / 4 degC cdegC [3..=9, 30..=255]`.
fn short(dialect: &Dialect, member: &Member) -> String {
    let Member { name, at, width, signed, meaning, repeat, presence, .. } = member;
    let sign = if *signed { " signed" } else { "" };
    let units = |units: &Option<String>| units.as_ref().map_or_else(String::new, |units| format!(" {units}"));
    let meaning = match meaning {
        Meaning::Flag => " flag".to_owned(),
        Meaning::Number { units: own } => units(own),
        Meaning::Values(id) => format!(" {}", dialect.enum_by_id(*id).unwrap().name.text),
        Meaning::Scaled(Scaled { factor, bias, divisor, units: own, exact }) => {
            let exact = exact
                .as_ref()
                .map(|exact| format!(" {}={}*{}+{}", exact.units, exact.suffix(), exact.factor, exact.bias));
            format!(" (raw*{factor}+{bias})/{divisor}{}{}", units(own), exact.unwrap_or_default())
        }
    };
    let repeat = repeat.map_or_else(String::new, |repeat| format!(" x{} every {}", repeat.count, repeat.stride));
    let presence = match presence {
        Presence::Always => String::new(),
        Presence::When(ranges) => format!(" {ranges:?}"),
    };
    format!("{name} {at}+{width}{sign}{meaning}{repeat}{presence}")
}

fn members(dialect: &Dialect, view: &View) -> Vec<String> {
    view.members.iter().map(|member| short(dialect, member)).collect()
}

/// The words: `i` for the element of a slot, `*` for a joined array.
fn words(dialect: &Dialect, view: &View) -> Vec<String> {
    let mut messages = dialect.messages.iter();
    let message = messages.find(|message| message.views.iter().any(|other| other.name == view.name)).unwrap();
    let word = |word: &Word| match word {
        Word::One(place) if place.element => format!("{}[i]", message.fields[place.field.0].name.text),
        Word::One(place) => message.fields[place.field.0].name.text.clone(),
        Word::Joined(field) => format!("{}[*]", message.fields[field.0].name.text),
    };
    view.words.iter().map(word).collect()
}

fn getter(view: &View) -> String {
    match &view.access {
        Access::Once { getter } => getter.shown(),
        Access::Slots(_) | Access::Record(_) => panic!("not once"),
    }
}

/// Resolves one message with one view, whose attributes and parts are given.
fn viewed(fields: &[&str], attributes: &str, parts: &str) -> Outcome {
    let view = format!("<message name='M'><view name='V' {attributes}>{parts}</view></message>");
    overlaid(&[("a.xml", &message(1, "M", fields))], &[&view])
}

fn only_view(outcome: &Outcome) -> &View {
    let [view] = &outcome.dialect().messages[0].views[..] else { panic!("one view") };
    view
}

/// The dialect of this repository.
fn autoquad() -> Dialect {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../xml");
    let overlays = [folder.join("overlay/autoquad.xml")];
    let loaded = load(&folder.join("autoquad.xml"), &[], &overlays, &mut sources, &mut diagnostics);
    let dialect = resolve(&loaded, &sources, &mut diagnostics).map(|named| named.dialect);
    let about_overlay = diagnostics.iter().filter(|problem| problem.code.number() >= 600);
    assert_eq!(about_overlay.map(|problem| &problem.message).collect::<Vec<_>>(), [&""; 0]);
    dialect.unwrap()
}

/// The layout of `esc32CanStatus_t`, packed, and of firmware that did not pack it.
#[test]
fn esc32_status() {
    let dialect = autoquad();
    let message = dialect.messages.iter().find(|message| message.id == 152).unwrap();
    let [status, unpacked] = &message.views[..] else { panic!("two views") };
    assert_eq!((&*status.name.text, &*unpacked.name.text), ("ESC32_STATUS", "ESC32_STATUS_UNPACKED"));
    let (legacy, version_3) = ("[0..=2, 10..=29]", "[3..=9, 30..=255]");
    assert_eq!(
        members(&dialect, status),
        [
            "state 0+3 ESC32_STATE".to_owned(),
            "voltage 3+12 (raw*1+0)/100 V mV=mv*10+0".to_owned(),
            "current 15+14 (raw*1+0)/100 A mA=ma*10+0".to_owned(),
            "rpm 29+15 rpm".to_owned(),
            "duty 44+8 (raw*20+0)/51 %".to_owned(),
            format!("temperature 52+9 (raw*1+-128)/4 degC cdegC=cdegc*25+-3200 {version_3}"),
            format!("disarm_v3 61+3 ESC32_DISARM_V3 {version_3}"),
            format!("errors 52+9 {legacy}"),
            format!("disarm_v2 61+3 ESC32_DISARM_V2 {legacy}"),
        ]
    );
    assert_eq!(
        members(&dialect, unpacked),
        [
            "state 0+3 ESC32_STATE",
            "voltage 3+12 (raw*1+0)/100 V mV=mv*10+0",
            "current 15+14 (raw*1+0)/100 A mA=ma*10+0",
            "rpm 32+15 rpm",
            "duty 47+8 (raw*20+0)/51 %",
            "errors 55+9",
        ]
    );
    for (view, item, items) in [(status, "esc", "escs"), (unpacked, "legacy_esc", "legacy_escs")] {
        assert_eq!((view.width, words(&dialect, view)), (64, vec!["data0[i]".to_owned(), "data1[i]".to_owned()]));
        let Access::Slots(slots) = &view.access else { panic!("no slots") };
        assert_eq!((&*slots.item.text, &*slots.items.shown(), slots.length.get()), (item, items, 4));
        assert_eq!(message.fields[slots.count.unwrap().0].name.text, "num_in_seq");
        let keys: Vec<_> = slots.keys.iter().map(|key| (key.name.shown(), key.units.as_deref(), key.invalid)).collect();
        assert_eq!(keys, [("id".to_owned(), None, None), ("age_ms".to_owned(), Some("ms"), Some(65535))]);
        let [ViewSentinel::Field(place, 65535), ViewSentinel::Words(0)] = view.invalid[..] else {
            panic!("{:?}", view.invalid)
        };
        assert_eq!((&*message.fields[place.field.0].name.text, place.element), ("status_age", true));
    }
    let switch = status.switch.as_ref().unwrap();
    assert_eq!(switch.name.shown(), "data_version");
    assert!(matches!(switch.on, SwitchOn::Field(place, _) if place.element));
    assert!(unpacked.switch.is_none());
}

#[test]
fn autoquad_binds_its_flags() {
    let dialect = autoquad();
    let message = dialect.messages.iter().find(|message| message.id == 0).unwrap();
    let [binding] = &message.bindings[..] else { panic!("one binding") };
    let values = dialect.enum_by_id(binding.enum_).unwrap();
    assert_eq!(
        (&*binding.name.shown(), &*values.name.text, values.bitmask),
        ("nav_status", "AUTOQUAD_NAV_STATUS", true)
    );
    assert_eq!(binding.condition.map(|condition| condition.value), Some(14));
}

#[test]
fn rtcm_flags() {
    let parts = "<bits name='fragmented' at='0' width='1'/><bits name='fragment' at='1' width='2'/>\
                 <bits name='sequence' at='3' width='5'/>";
    let outcome = viewed(&["uint8_t flags", "uint8_t len"], "words='flags' item='packed_flags'", parts);
    let view = only_view(&outcome);
    assert_eq!(members(outcome.dialect(), view), ["fragmented 0+1 flag", "fragment 1+2", "sequence 3+5"]);
    assert_eq!((view.width, &*getter(view)), (8, "packed_flags"));
}

#[test]
fn event_log_levels() {
    let levels = enumeration("LOG_LEVEL", &["LOG_LEVEL_EMERGENCY=0", "LOG_LEVEL_DISABLED=15"]);
    let view = "<message name='EVENT'><view name='LOG_LEVELS' words='log_levels' item='levels'>\
                <bits name='external' at='0' width='4' enum='LOG_LEVEL'/>\
                <bits name='internal' at='4' width='4' enum='LOG_LEVEL'/></view></message>";
    let outcome = overlaid(&[("a.xml", &message(1, "EVENT", &["uint8_t log_levels"]))], &[&(levels + view)]);
    let expected = ["external 0+4 LOG_LEVEL", "internal 4+4 LOG_LEVEL"];
    assert_eq!(members(outcome.dialect(), only_view(&outcome)), expected);
}

#[test]
fn flight_software_version() {
    let base = enumeration("FIRMWARE_VERSION_TYPE", &["T_DEV=0", "T_ALPHA=64", "T_OFFICIAL=255"]);
    let base = base + &message(1, "AUTOPILOT_VERSION", &["uint32_t flight_sw_version"]);
    let view = "<message name='AUTOPILOT_VERSION'><view name='FIRMWARE_VERSION' \
                words='flight_sw_version' item='flight_sw'>\
                <invalid value='0'/><bits name='type' at='0' width='8' enum='FIRMWARE_VERSION_TYPE'/>\
                <bits name='patch' at='8' width='8'/><bits name='minor' at='16' width='8'/>\
                <bits name='major' at='24' width='8'/></view></message>";
    let outcome = overlaid(&[("a.xml", &base)], &[view]);
    let view = only_view(&outcome);
    let expected = ["type 0+8 FIRMWARE_VERSION_TYPE", "patch 8+8", "minor 16+8", "major 24+8"];
    assert_eq!(members(outcome.dialect(), view), expected);
    assert_eq!((&*getter(view), &view.invalid[..]), ("flight_sw", &[ViewSentinel::Words(0)][..]));
}

/// A switch on other bits, for one autopilot only.
#[test]
fn px4_custom_mode() {
    let base = enumeration("MAV_AUTOPILOT", &["MAV_AUTOPILOT_GENERIC=0", "MAV_AUTOPILOT_PX4=12"]);
    let base = base + &message(0, "HEARTBEAT", &["uint32_t custom_mode", "uint8_t autopilot MAV_AUTOPILOT"]);
    let enums = enumeration("PX4_MODE", &["PX4_MODE_MANUAL=1", "PX4_MODE_POSCTL=3", "PX4_MODE_AUTO=4"])
        + &enumeration("PX4_AUTO", &["PX4_AUTO_READY=1", "PX4_AUTO_TAKEOFF=2"])
        + &enumeration("PX4_POSCTL", &["PX4_POSCTL_PLAIN=0", "PX4_POSCTL_ORBIT=1"]);
    let view = "<message name='HEARTBEAT'>\
        <view name='PX4_CUSTOM_MODE' words='custom_mode' item='px4_mode' if='autopilot' is='MAV_AUTOPILOT_PX4'>\
        <reserved at='0' width='16'/><bits name='main_mode' at='16' width='8' enum='PX4_MODE'/>\
        <switch bits='main_mode'>\
        <case value='PX4_MODE_AUTO'><bits name='auto_mode' at='24' width='8' enum='PX4_AUTO'/></case>\
        <case value='3'><bits name='posctl_mode' at='24' width='8' enum='PX4_POSCTL'/></case>\
        <default><reserved at='24' width='8'/></default></switch></view></message>";
    let outcome = overlaid(&[("a.xml", &base)], &[&(enums + view)]);
    let view = only_view(&outcome);
    let expected =
        ["main_mode 16+8 PX4_MODE", "auto_mode 24+8 PX4_AUTO [4..=4]", "posctl_mode 24+8 PX4_POSCTL [3..=3]"];
    assert_eq!(members(outcome.dialect(), view), expected);
    let switch = view.switch.as_ref().unwrap();
    assert_eq!((&*switch.name.shown(), switch.on), ("main_mode", SwitchOn::Bits { at: 16, width: 8 }));
    assert_eq!(view.condition.map(|condition| (condition.field.0, condition.value)), Some((1, 12)));
}

#[test]
fn repeated_flags() {
    let relays = viewed(&["uint16_t on"], "words='on' item='relays'", "<bits name='on' at='0' width='1' repeat='16'/>");
    assert_eq!(members(relays.dialect(), only_view(&relays)), ["on 0+1 flag x16 every 1"]);
    let parts = "<bits name='a' at='0' width='2' repeat='4' stride='4'/>\
                 <bits name='b' at='2' width='2' repeat='4' stride='4'/>";
    let woven = viewed(&["uint16_t f"], "words='f' item='v'", parts);
    assert_eq!(members(woven.dialect(), only_view(&woven)), ["a 0+2 x4 every 4", "b 2+2 x4 every 4"]);
}

#[test]
fn signed_and_scaled() {
    let parts = "<bits name='channel' at='0' width='13' signed='true' scale='5/32' bias='1500' units='us'/>\
                 <bits name='level' at='13' width='2' signed='true'/>\
                 <bits name='rssi' at='15' width='8' scale='-1' units='dBm' exact='dBm'/>\
                 <bits name='on' at='23' width='1' units='s'/><reserved at='24' width='8'/>";
    let outcome = viewed(&["uint32_t f"], "words='f' item='v'", parts);
    let expected = [
        "channel 0+13 signed (raw*5+48000)/32 us",
        "level 13+2 signed",
        "rssi 15+8 (raw*-1+0)/1 dBm dBm=dbm*-1+0",
        "on 23+1 s",
    ];
    assert_eq!(members(outcome.dialect(), only_view(&outcome)), expected);
}

/// 24 bits of 32: an ICAO address.
#[test]
fn reserved_and_partial() {
    let icao = "<bits name='address' at='0' width='24'/>";
    let codes = |attributes: &str, parts: &str| viewed(&["uint32_t icao"], attributes, parts).codes();
    assert_eq!(codes("words='icao' item='v'", icao), [Code::BitsUncovered]);
    assert_eq!(codes("words='icao' item='v' partial='true'", icao), []);
    assert_eq!(codes("words='icao' item='v'", &format!("{icao}<reserved at='24' width='8'/>")), []);
}

#[test]
fn joined_arrays() {
    let parts = "<bits name='low' at='0' width='100'/><bits name='high' at='100' width='28' scale='0.5'/>";
    let outcome = viewed(&["uint32_t[3] x", "uint16_t y", "uint8_t[2] z"], "words='x[*] y z[*]' item='v'", parts);
    let view = only_view(&outcome);
    assert_eq!((view.width, words(outcome.dialect(), view)), (128, ["x[*]", "y", "z[*]"].map(str::to_owned).to_vec()));
    assert_eq!(members(outcome.dialect(), view), ["low 0+100", "high 100+28 (raw*1+0)/2"]);
}

/// The same bits under the same name in several cases are one member, at the place of the switch.
#[test]
fn members_of_several_cases() {
    let parts = "<bits name='first' at='0' width='4'/>\
        <switch field='kind'>\
        <case value='0'><bits name='all' at='4' width='4'/><bits name='some' at='8' width='4'>Text.</bits>\
        <reserved at='12' width='4'/></case>\
        <case value='1 5..=7'><bits name='all' at='4' width='4'/><bits name='some' at='8' width='4'/>\
        <bits name='one' at='12' width='4'/></case>\
        <default><bits name='all' at='4' width='4'/><reserved at='8' width='8'/></default></switch>\
        <bits name='last' at='16' width='16'/>";
    let outcome = viewed(&["uint32_t f", "uint8_t kind"], "words='f' item='v'", parts);
    let expected = ["first 0+4", "all 4+4", "some 8+4 [0..=1, 5..=7]", "one 12+4 [1..=1, 5..=7]", "last 16+16"];
    let view = only_view(&outcome);
    assert_eq!(members(outcome.dialect(), view), expected);
    assert_eq!(view.members[2].description, "Text.");
}

#[test]
fn descriptions_are_text_or_elements() {
    let bits = "<bits name='a' at='0' width='8'>\n  Bits.\n</bits>";
    for (parts, expected) in [
        (format!("<description> View. </description>{bits}"), "View."),
        (format!("\n  View.\n  {bits}\n"), "View."),
        (bits.to_owned(), ""),
    ] {
        let outcome = viewed(&["uint8_t f"], "words='f' item='v'", &parts);
        let view = only_view(&outcome);
        assert_eq!((&*view.origin.description, &*view.members[0].description), (expected, "Bits."));
    }
}

#[test]
fn keys_are_named_after_their_units() {
    let keys = "<key name='age' field='age[i]' units='ms'/><key name='speed' field='v' units='m/s'/>\
                <key name='plain' field='kind'/><bits name='a' at='0' width='8'/>";
    let fields = ["uint8_t[4] x", "uint16_t[4] age", "float v", "uint8_t kind"];
    let outcome = viewed(&fields, "words='x[i]' item='slot' items='slots'", keys);
    let Access::Slots(slots) = &only_view(&outcome).access else { panic!("no slots") };
    let keys: Vec<_> = slots.keys.iter().map(|key| (key.name.shown(), key.place.element)).collect();
    assert_eq!(
        keys,
        [("age_ms", true), ("speed", false), ("plain", false)].map(|(name, element)| (name.to_owned(), element))
    );
    assert_eq!(slots.count, None);
}
