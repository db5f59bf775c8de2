//! Messages as JSON: an object on a line of its own each.
//!
//! | key | |
//! |---|---|
//! | `time` | RFC 3339 in UTC, or null where the input has none |
//! | `version` | of MAVLink: 1 or 2 |
//! | `system`, `component`, `sequence`, `id` | of the frame |
//! | `signed` | whether the frame carries a signature; it is not checked |
//! | `verified` | whether the definitions have the message; if not, there are `crc_extra` and `payload` instead of the rest |
//! | `name` | of the message |
//! | `fields` | values by the names of the XML, in its order |
//! | `units` | of those fields that have one |
//! | `views` | what overlays see in the fields |
//!
//! A value that the sender does not know is null, a secret key the text `"secret"`. An enum is the name of its entry, or the number where no entry has it;
//! flags are `"A | B | 0x40"`. Floats that JSON cannot write are the texts `"NaN"`, `"Infinity"` and `"-Infinity"`, numbers
//! over 64 bits are texts as well.

use mavgen::decode::{Contents, Entry, Node};
use mavlink_wire::Version;
use mavlink_wire::reflect::Reflected;
use serde_json::{Map, Value, json};

use super::received::{Received, hexadecimal};

/// The line of a message.
pub(super) fn message(received: &Received<'_>, reflected: &Reflected<'_>, contents: &Contents) -> String {
    let units = contents.fields.iter().filter_map(|field| Some((field.name.clone(), field.units.clone()?.into())));
    let mut line = head(received);
    line.insert("name".to_owned(), reflected.info().name.into());
    line.insert("fields".to_owned(), record(&contents.fields));
    line.insert("units".to_owned(), Value::Object(units.collect()));
    line.insert("views".to_owned(), record(&contents.views));
    format!("{}\n", Value::Object(line))
}

/// The line of a message that the definitions do not have.
pub(super) fn unverified(received: &Received<'_>) -> String {
    let mut line = head(received);
    line.insert("crc_extra".to_owned(), received.frame.crc_extra().into());
    line.insert("payload".to_owned(), hexadecimal(received.frame.payload()).into());
    format!("{}\n", Value::Object(line))
}

fn head(received: &Received<'_>) -> Map<String, Value> {
    let frame = &received.frame;
    let version = match frame.version() {
        Version::V1 => 1,
        Version::V2 => 2,
    };
    let head = json!({
        "time": received.time.map(|time| time.to_string()),
        "version": version,
        "system": frame.system_id().to_u32(),
        "component": frame.component_id().to_u32(),
        "sequence": frame.sequence(),
        "signed": frame.signature().is_some(),
        "id": frame.message_id(),
        "verified": frame.is_verified(),
    });
    match head {
        Value::Object(head) => head,
        _ => Map::new(),
    }
}

fn record(entries: &[Entry]) -> Value {
    Value::Object(entries.iter().map(|entry| (entry.name.clone(), value(&entry.node))).collect())
}

fn value(node: &Node) -> Value {
    match node {
        Node::Unknown => Value::Null,
        Node::Secret => "secret".into(),
        Node::Unsigned(value) => u64::try_from(*value).map_or_else(|_| value.to_string().into(), Value::from),
        Node::Signed(value) => i64::try_from(*value).map_or_else(|_| value.to_string().into(), Value::from),
        // The double that is written like the float: 0.1, not 0.10000000149011612, and the same float again.
        Node::Float(value) => value.to_string().parse().map_or(Value::Null, float),
        Node::Double(value) => float(*value),
        Node::Scaled(ratio) => float(ratio.to_f64()),
        Node::Flag(flag) => (*flag).into(),
        Node::Name(name) => name.as_str().into(),
        Node::Text(bytes) => String::from_utf8_lossy(bytes).into(),
        Node::List(nodes) => nodes.iter().map(value).collect(),
        Node::Record(entries) => record(entries),
    }
}

fn float(value: f64) -> Value {
    if value.is_finite() {
        return value.into();
    }
    match value.is_nan() {
        true => "NaN".into(),
        false if value > 0.0 => "Infinity".into(),
        false => "-Infinity".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_without_loss() {
        for (node, text) in [
            (Node::Float(0.1), "0.1"),
            (Node::Float(-0.0), "-0.0"),
            (Node::Float(f32::MAX), "3.4028235e+38"),
            (Node::Float(f32::NAN), "\"NaN\""),
            (Node::Double(f64::INFINITY), "\"Infinity\""),
            (Node::Float(f32::NEG_INFINITY), "\"-Infinity\""),
            (Node::Double(0.1), "0.1"),
            (Node::Unsigned(u64::MAX.into()), "18446744073709551615"),
            (Node::Unsigned(1 << 64), "\"18446744073709551616\""),
            (Node::Signed(i64::MIN.into()), "-9223372036854775808"),
            (Node::Signed(i128::MIN), "\"-170141183460469231731687303715884105728\""),
        ] {
            assert_eq!(value(&node).to_string(), text, "{node:?}");
        }
    }
}
