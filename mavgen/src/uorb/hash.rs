//! The two hashes of a message: PX4's message hash and ROS 2's type hash.

use std::fmt::Write;

use sha2::{Digest, Sha256};

use super::model::{Element, Field, Message};
use crate::collect::CollectVec as _;
use crate::order;

/// FNV-1a of 32 bits over the types and names of the fields, in the order of the file; what a field nests follows it.
pub(super) fn message_hash(fields: &[Field], nested: &[Message]) -> u32 {
    fn add(text: &mut String, fields: &[Field], nested: &[Message]) {
        for field in fields {
            let element = field.element.name(nested);
            let array = field.array.map(|length| format!("[{length}]")).unwrap_or_default();
            text.push_str(&format!("{element}{array} {}\n", field.name));
            if let Some(message) = field.element.message(nested) {
                add(text, &message.fields, nested);
            }
        }
    }
    let mut text = String::new();
    add(&mut text, fields, nested);
    text.bytes().fold(0x811c_9dc5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

/// ROS 2's type hash of `px4_msgs/msg/NAME`, as REP 2016 and the interface of type descriptions define it: SHA-256 of the
/// description as JSON.
pub(super) fn type_hash(name: &str, fields: &[Field], nested: &[Message]) -> String {
    let mut referenced = Vec::new();
    collect(fields, nested, &mut referenced);
    // They begin with the names, by which they are ordered.
    order::sort_and_dedup(&mut referenced);
    let json = format!(
        r#"{{"type_description": {}, "referenced_type_descriptions": [{}]}}"#,
        description(name, fields, nested),
        referenced.join(", ")
    );
    let mut hash = String::from("RIHS01_");
    for byte in Sha256::digest(json) {
        // Writing to a String cannot fail.
        let _ = write!(hash, "{byte:02x}");
    }
    hash
}

/// The descriptions of all that is nested.
fn collect(fields: &[Field], nested: &[Message], found: &mut Vec<String>) {
    for field in fields {
        if let Some(message) = field.element.message(nested) {
            found.push(description(&message.name, &message.fields, nested));
            collect(&message.fields, nested, found);
        }
    }
}

fn description(name: &str, fields: &[Field], nested: &[Message]) -> String {
    let fields = fields.iter().map(|field| field_description(field, nested)).collect_vec();
    format!(r#"{{"type_name": "px4_msgs/msg/{name}", "fields": [{}]}}"#, fields.join(", "))
}

fn field_description(field: &Field, nested: &[Message]) -> String {
    let (id, message) = match field.element {
        Element::Scalar(scalar) => (scalar.type_id(), String::new()),
        Element::Message(_) => (1, format!("px4_msgs/msg/{}", field.element.name(nested))),
    };
    // The ids of arrays are those of their elements, 48 on.
    let (id, capacity) = field.array.map_or((id, 0), |length| (id + 48, length));
    format!(
        r#"{{"name": "{}", "type": {{"type_id": {id}, "capacity": {capacity}, "string_capacity": 0, "nested_type_name": "{message}"}}}}"#,
        field.name
    )
}
