//! Messages as JSON: an object on a line of its own each.
//!
//! | key | |
//! |---|---|
//! | `time`, `unix_time` | when it was received, as RFC 3339 in UTC and in seconds since 1970; null where the input has none |
//! | `version` | of MAVLink: 1 or 2 |
//! | `system_id`, `component_id`, `sequence`, `message_id` | of the frame |
//! | `signed` | whether the frame carries a signature; it is not checked |
//! | `verified` | whether the definitions have the message; if not, there are `crc_extra` and `payload` instead of the rest |
//! | `message` | its name as `type`, and its fields in the order of the XML |
//! | `units` | of those fields that have one, by their keys in `message` |
//! | `views` | what overlays see in the fields |
//! | `view_units` | of the values in `views`, without the lists |
//!
//! `message` is what serde makes of a message in generated code (`mavlink_wire::generated::serde` says how), and is read by it,
//! with two differences: what the sender does not know is null, because whoever draws or sums up values wants no 65535 among
//! them, and a secret key is the text `"secret"`, because nobody wants it in a log. Views follow the same rules; numbers over 64 bits are texts.

use mavgen::decode::{Contents, Entry, Node};
use mavlink_wire::Version;
use mavlink_wire::reflect::Number;
use serde_json::{Map, Value, json};

use super::received::{Received, hexadecimal};

/// The line of a message.
pub(super) fn message(received: &Received<'_>, name: &str, contents: &Contents) -> String {
    let fields = || contents.fields.iter().map(|field| (key(&field.name), field));
    let mut message: Map<String, Value> = [("type".to_owned(), name.into())].into_iter().collect();
    message.extend(fields().map(|(key, field)| (key.to_owned(), value(&field.node))));
    let units = fields().filter_map(|(key, field)| Some((key.to_owned(), field.units.clone()?.into())));
    let mut line = head(received);
    line.insert("message".to_owned(), Value::Object(message));
    line.insert("units".to_owned(), Value::Object(units.collect()));
    line.insert("views".to_owned(), record(&contents.views));
    line.insert("view_units".to_owned(), Value::Object(units_of(&contents.views)));
    format!("{}\n", Value::Object(line))
}

/// The key of a field, as serde has it: `type` is the name of the message.
fn key(field: &str) -> &str {
    match field {
        "type" => "mavtype",
        "mavtype" => "mavmavtype",
        name => name,
    }
}

/// The units of what has one; elements of a list have the same.
fn units_of(entries: &[Entry]) -> Map<String, Value> {
    let mut units = Map::new();
    for Entry { name, units: unit, node } in entries {
        let value = match unit {
            Some(unit) => unit.as_str().into(),
            None => Value::Object(units_within(node)),
        };
        if value != json!({}) {
            units.insert(name.clone(), value);
        }
    }
    units
}

fn units_within(node: &Node) -> Map<String, Value> {
    match node {
        Node::Record(entries) => units_of(entries),
        Node::List(nodes) => {
            let mut units = Map::new();
            for (name, value) in nodes.iter().flat_map(units_within) {
                merge(&mut units, name, value);
            }
            units
        }
        _ => Map::new(),
    }
}

/// Adds what another element knows: one slot's status may be unknown, and the layouts of two may differ.
fn merge(units: &mut Map<String, Value>, name: String, value: Value) {
    match (units.get_mut(&name), value) {
        (Some(Value::Object(there)), Value::Object(more)) => {
            more.into_iter().for_each(|(name, value)| merge(there, name, value));
        }
        (_, value) => {
            units.insert(name, value);
        }
    }
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
        "unix_time": received.time.and_then(|time| time.unix().parse::<f64>().ok()),
        "version": version,
        "system_id": frame.system_id().to_u32(),
        "component_id": frame.component_id().to_u32(),
        "sequence": frame.sequence(),
        "signed": frame.signature().is_some(),
        "message_id": frame.message_id(),
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
        Node::Float(value) => float(Number::F32(*value), shortest(*value)),
        Node::Double(value) => float(Number::F64(*value), *value),
        Node::Scaled(ratio) => ratio.to_f64().into(),
        Node::Flag(flag) => (*flag).into(),
        Node::Name(name) | Node::Flags(name) => name.as_str().into(),
        Node::Char(byte) => (*byte).into(),
        Node::Text(bytes) => text(bytes).map_or_else(|| bytes.clone().into(), Value::from),
        Node::List(nodes) => nodes.iter().map(value).collect(),
        Node::Record(entries) => record(entries),
    }
}

/// The text, if the bytes are it and nothing else.
fn text(bytes: &[u8]) -> Option<&str> {
    let nul = bytes.iter().position(|byte| *byte == 0).unwrap_or(bytes.len());
    let (text, rest) = bytes.split_at_checked(nul)?;
    if rest.iter().all(|byte| *byte == 0) { std::str::from_utf8(text).ok() } else { None }
}

/// The double that is written like the float: 0.1, not 0.10000000149011612; the float's own value where that would be read as
/// another float.
fn shortest(value: f32) -> f64 {
    let double: f64 = value.to_string().parse().unwrap_or(f64::NAN);
    if double as f32 == value { double } else { value.into() }
}

/// A number, or the text for what JSON has no number for.
fn float(number: Number, value: f64) -> Value {
    if value.is_finite() {
        return value.into();
    }
    match value.is_nan() {
        true => number.to_string().into(),
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
            (Node::Float(f32::from_bits(u32::MAX)), "\"NaN(0xffffffff)\""),
            (Node::Double(f64::from_bits(u64::MAX)), "\"NaN(0xffffffffffffffff)\""),
            (Node::Float(f32::from_bits(0x15ae_43fd)), "7.038530691851209e-26"),
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

    #[test]
    fn bytes_are_text_unless_that_would_lose_some() {
        for (bytes, expected) in [
            (&b"tank\0\0"[..], json!("tank")),
            (b"\0\0", json!("")),
            (b"t\0k", json!([116, 0, 107])),
            (b"\xff", json!([255])),
        ] {
            assert_eq!(value(&Node::Text(bytes.to_vec())), expected);
        }
    }
}
