//! Messages as text: a line each, and one more for each view and slot.

use mavgen::decode::{Contents, Entry, Node};
use mavlink_wire::reflect::Number;

use super::received::{Received, hexadecimal};

/// `2014-05-13T16:53:20.123456Z 1/1 #12 HEARTBEAT { … }`, and what overlays see in it.
pub(super) fn message(received: &Received<'_>, name: &str, contents: &Contents) -> String {
    let fields: Vec<String> = contents.fields.iter().map(field).collect();
    let mut text = match fields.is_empty() {
        true => format!("{}{name}\n", head(received)),
        false => format!("{}{name} {{ {} }}\n", head(received), fields.join(", ")),
    };
    for view in &contents.views {
        lines(&mut text, view);
    }
    text
}

/// `1/1 #12 message 152, unverified: 01ff…`
pub(super) fn unverified(received: &Received<'_>) -> String {
    let (id, payload) = (received.frame.message_id(), hexadecimal(received.frame.payload()));
    format!("{}message {id}, unverified: {payload}\n", head(received))
}

fn head(received: &Received<'_>) -> String {
    let (time, frame) = (received.time, &received.frame);
    let time = time.map(|time| format!("{time} ")).unwrap_or_default();
    format!("{time}{}/{} #{} ", frame.system_id(), frame.component_id(), frame.sequence())
}

/// The lines of a view: `    escs[0]: id 3, age_ms 12 ms, state ESC32_STATE_RUNNING, …`
fn lines(text: &mut String, view: &Entry) {
    let name = &view.name;
    match &view.node {
        Node::List(slots) => {
            let slots = slots.iter().enumerate();
            text.extend(slots.map(|(index, slot)| format!("    {name}[{index}]: {}\n", value(slot, None))));
        }
        other => *text += &format!("    {name}: {}\n", value(other, view.units.as_deref())),
    }
}

fn field(field: &Entry) -> String {
    format!("{}: {}", field.name, value(&field.node, field.units.as_deref()))
}

fn value(node: &Node, units: Option<&str>) -> String {
    let text = match node {
        Node::Unknown => return "unknown".to_owned(),
        Node::Secret => return "secret".to_owned(),
        Node::Text(bytes) => return quoted(text_of(bytes)),
        Node::Char(byte) => return quoted(text_of(&[*byte])),
        Node::Flags(flags) if flags.is_empty() => "0".to_owned(),
        Node::List(nodes) => {
            let nodes: Vec<String> = nodes.iter().map(|node| value(node, None)).collect();
            format!("[{}]", nodes.join(", "))
        }
        Node::Record(entries) => entries.iter().map(entry).collect::<Vec<String>>().join(", "),
        Node::Scaled(ratio) => ratio.to_string(),
        other => plain(other),
    };
    units.map_or(text.clone(), |units| format!("{text} {units}"))
}

/// A value that is neither unknown nor made of others, as text and CSV have it.
pub(super) fn plain(node: &Node) -> String {
    match node {
        Node::Unsigned(value) => value.to_string(),
        Node::Signed(value) => value.to_string(),
        Node::Float(value) => Number::F32(*value).to_string(),
        Node::Double(value) => Number::F64(*value).to_string(),
        Node::Scaled(ratio) => ratio.to_f64().to_string(),
        Node::Flag(flag) => flag.to_string(),
        Node::Name(name) | Node::Flags(name) => name.clone(),
        Node::Secret => "secret".to_owned(),
        Node::Text(bytes) => unquoted(text_of(bytes)),
        Node::Char(byte) => unquoted(text_of(&[*byte])),
        Node::Unknown | Node::List(_) | Node::Record(_) => String::new(),
    }
}

/// The bytes up to the first NUL.
fn text_of(bytes: &[u8]) -> &[u8] {
    bytes.split(|byte| *byte == 0).next().unwrap_or_default()
}

/// In quotes; as a byte string where it is not UTF-8.
fn quoted(bytes: &[u8]) -> String {
    std::str::from_utf8(bytes).map_or_else(|_| escaped(bytes), |text| format!("{text:?}"))
}

fn unquoted(bytes: &[u8]) -> String {
    std::str::from_utf8(bytes).map_or_else(|_| escaped(bytes), str::to_owned)
}

fn escaped(bytes: &[u8]) -> String {
    format!("b\"{}\"", bytes.escape_ascii())
}

/// `voltage 12.34 V`; the members of a slot stand beside its keys.
fn entry(entry: &Entry) -> String {
    let text = value(&entry.node, entry.units.as_deref());
    if matches!(entry.node, Node::Record(_)) { text } else { format!("{} {text}", entry.name) }
}
