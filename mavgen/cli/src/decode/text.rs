//! Messages as text: a line each, and one more for each view and slot.

use std::fmt::Write;

use mavgen::decode::{Contents, Entry, Node};
use mavlink_wire::reflect::Reflected;

use super::received::{Received, hexadecimal};

/// `2014-05-13T16:53:20.123456Z 1/1 #12 HEARTBEAT { … }`, and what overlays see in it.
pub(super) fn message(received: &Received<'_>, reflected: &Reflected<'_>, contents: &Contents) -> String {
    let mut text = format!("{}{reflected}\n", head(received));
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
    // Writing into a String cannot fail.
    let _ = match &view.node {
        Node::List(slots) => slots
            .iter()
            .enumerate()
            .try_for_each(|(index, slot)| writeln!(text, "    {name}[{index}]: {}", value(slot, None))),
        other => writeln!(text, "    {name}: {}", value(other, view.units.as_deref())),
    };
}

fn value(node: &Node, units: Option<&str>) -> String {
    let text = match node {
        Node::Unknown => return "unknown".to_owned(),
        Node::Secret => return "secret".to_owned(),
        Node::Unsigned(value) => value.to_string(),
        Node::Signed(value) => value.to_string(),
        Node::Float(value) => format!("{value:?}"),
        Node::Double(value) => format!("{value:?}"),
        Node::Scaled(ratio) => ratio.to_string(),
        Node::Flag(flag) => flag.to_string(),
        Node::Name(name) => name.clone(),
        Node::Text(bytes) => format!("{:?}", String::from_utf8_lossy(bytes)),
        Node::List(nodes) => {
            let nodes: Vec<String> = nodes.iter().map(|node| value(node, None)).collect();
            format!("[{}]", nodes.join(", "))
        }
        Node::Record(entries) => entries.iter().map(entry).collect::<Vec<String>>().join(", "),
    };
    units.map_or(text.clone(), |units| format!("{text} {units}"))
}

/// `voltage 12.34 V`; the members of a slot stand beside its keys.
fn entry(entry: &Entry) -> String {
    let text = value(&entry.node, entry.units.as_deref());
    if matches!(entry.node, Node::Record(_)) { text } else { format!("{} {text}", entry.name) }
}
