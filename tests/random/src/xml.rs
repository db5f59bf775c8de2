//! Text of XML.

use crate::chance::Chance;

/// What people write about things, and what no compiler of documentation likes.
const PROSE: [&str; 12] = [
    "",
    "Level of the tank.",
    "What is left, see https://example.org/a_b.",
    "A <b> & [x] `y` */ \"z\" 'w'",
    "First paragraph.\n\n        Second one, indented.",
    "# Not a heading",
    "MAV_CMD_X, TANK_LEVEL and Option<T>",
    "0: off, 1: on; 50 %",
    "[0..1] {} \\ \\n",
    "é ∞ 漢字",
    "- a\n- b",
    "deprecated",
];

/// ` name="value"`.
pub(crate) fn attribute(name: &str, value: &str) -> String {
    format!(" {name}=\"{}\"", escaped(value))
}

/// As [`attribute`]; nothing for `None`.
pub(crate) fn optional(name: &str, value: Option<&str>) -> String {
    value.map(|value| attribute(name, value)).unwrap_or_default()
}

/// A text between tags, mostly a plain one.
pub(crate) fn prose(chance: &mut Chance) -> String {
    if chance.one_in(2) { "What it says.".to_owned() } else { escaped(chance.word(&PROSE)) }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

/// `<deprecated …>` and its kin; mostly nothing. Also tells whether it is deprecated.
pub(crate) fn lifecycle(chance: &mut Chance, times: usize) -> (String, bool) {
    if !chance.one_in(times) {
        return (String::new(), false);
    }
    let (element, deprecated) = [("deprecated", true), ("deprecated", true), ("superseded", false)][chance.below(3)];
    let replaced = chance.word(&["TANK", "", "MAV_CMD_X, or nothing"]);
    (format!("<{element} since=\"2020-01\" replaced_by=\"{replaced}\">Why.</{element}>"), deprecated)
}
