//! Commands with their params, the messages that carry them, and what overlays call params.

use std::fmt::Write;

use crate::Construct;
use crate::chance::Chance;
use crate::enums::Enum;
use crate::messages::Scalar;
use crate::names::{self, Scope};
use crate::xml::{attribute, lifecycle, prose};

/// Entries called like what the module of commands has already.
const ENTRIES: [&str; 8] = ["LONG", "INT", "FRAME", "COMMANDS", "SELF", "DEBUG", "GO_1", "GO1"];

/// Labels that are keywords, methods, one another, or no name at all.
const LABELS: [&str; 16] = [
    "Type",
    "self",
    "°",
    "4th",
    "Latitude/X",
    "Speed",
    "speed ",
    "param2",
    "Param 2",
    "p",
    "long",
    "int",
    "params",
    "é",
    "-",
    "yaw_",
];

/// `MAV_CMD`, whose entries have params.
pub(crate) fn make(chance: &mut Chance, file: usize, of: Option<&str>) -> (Enum, String) {
    chance.say(Construct::Command);
    let mut text = String::from("<enum name=\"MAV_CMD\">\n");
    let mut entries: Vec<(String, u64)> = Vec::new();
    for nth in 0..chance.between(1, 4) {
        let odd = chance.maybe(3, Construct::OddCommand).then(|| chance.word(&ENTRIES).to_owned());
        let name = odd.unwrap_or_else(|| match of.filter(|_| chance.one_in(4)) {
            Some(of) => of.to_owned(),
            None => names::entry(chance, "DO", nth),
        });
        let (name, value) = (format!("MAV_CMD_{name}"), 20 + nth as u64);
        if entries.iter().any(|(known, _)| *known == name) {
            continue;
        }
        let place = if chance.maybe(3, Construct::Location) { " hasLocation=\"true\"" } else { "" };
        _ = writeln!(text, "<entry value=\"{value}\" name=\"{name}\"{place}>{}", lifecycle(chance, 8).0);
        for index in 1..=7 {
            text += &param(chance, index, of);
        }
        text.push_str("</entry>\n");
        entries.push((name, value));
    }
    text.push_str("</enum>\n");
    let (name, scalar) = ("MAV_CMD".to_owned(), Scalar::unsigned(16));
    (Enum { name, file, bitmask: false, deprecated: false, refined: false, entries, scalar, uses: Vec::new() }, text)
}

fn param(chance: &mut Chance, index: usize, of: Option<&str>) -> String {
    let default =
        ["", "", " default=\"0\"", " default=\"0.1\"", " default=\"NaN\"", " default=\"300\""][chance.below(6)];
    let more = match chance.below(6) {
        0 => attribute("label", "Speed") + &attribute("units", "m/s") + " minValue=\"-1\" maxValue=\"10\"",
        1 => of.map(|of| attribute("label", "State") + &attribute("enum", of)).unwrap_or_default(),
        // An overlay may name the last one.
        2 if index < 7 => " reserved=\"true\"".to_owned(),
        3 => attribute("label", "Count") + " increment=\"1\" minValue=\"0\"",
        4 => {
            chance.say(Construct::OddLabel);
            attribute("label", chance.word(&LABELS)) + ["", " units=\"degE7\""][chance.below(2)]
        }
        _ => return String::new(),
    };
    format!("<param index=\"{index}\"{more}{default}>{}</param>\n", prose(chance))
}

/// `COMMAND_LONG` and `COMMAND_INT`, both or one.
pub(crate) fn carriers(chance: &mut Chance, types: &mut Scope) -> Vec<String> {
    let (both, head) =
        (chance.below(3), |id: u32, name: &str, life: String| format!("<message id=\"{id}\" name=\"{name}\">{life}\n"));
    let field = |ty: &str, name: &str, more: &str| format!("<field type=\"{ty}\" name=\"{name}\"{more}>.</field>\n");
    let command = field("uint16_t", "command", " enum=\"MAV_CMD\"");
    let target = field("uint8_t", "target_system", "") + &field("uint8_t", "target_component", "");
    let floats = |names: &[&str]| names.iter().map(|name| field("float", name, "")).collect::<String>();
    let mut made = Vec::new();
    if both != 1 && types.take("COMMAND_LONG") {
        chance.say(Construct::CommandLong);
        let params = floats(&["param1", "param2", "param3", "param4", "param5", "param6", "param7"]);
        let head = head(76, "COMMAND_LONG", lifecycle(chance, 8).0);
        made.push(format!("{head}{target}{command}{}{params}</message>\n", field("uint8_t", "confirmation", "")));
    }
    if both != 0 && types.take("COMMAND_INT") {
        chance.say(Construct::CommandInt);
        let integers = ["frame", "current", "autocontinue"].map(|name| field("uint8_t", name, "")).concat();
        let place = field("int32_t", "x", "") + &field("int32_t", "y", "") + &field("float", "z", "");
        let params = floats(&["param1", "param2", "param3", "param4"]);
        let head = head(75, "COMMAND_INT", lifecycle(chance, 8).0);
        made.push(format!("{head}{target}{command}{integers}{params}{place}</message>\n"));
    }
    made
}

/// What an overlay says of the commands of its file.
pub(crate) fn overlay(chance: &mut Chance, of: &Enum) -> String {
    let Some((name, _)) = chance.pick(&of.entries).cloned() else { return String::new() };
    chance.say(Construct::NamedParam);
    let place = ["", " hasLocation=\"true\"", " isDestination=\"true\""][chance.below(3)];
    let param = ["", "<param index=\"7\" label=\"Overlaid\" units=\"m\"/>"][chance.below(2)];
    format!("<command{}{place}>{param}</command>\n", attribute("name", &name))
}
