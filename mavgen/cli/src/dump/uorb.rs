//! uORB messages: hashes, lengths, both layouts, constants and enums.

use mavgen::ir::{Invalid, Scope, Sentinel};
use mavgen::uorb::log_format;
use mavgen::uorb::model::{Element, Enum, Field, Message, Package};
use mavgen::uorb::union::Definition;
use serde_json::{Number, Value, json};

/// A definition as JSON. What a message nests stands before it; fields, constants and entries are in the order of the file.
pub(super) fn json(definition: &Definition) -> String {
    let package = &definition.package;
    let value = json!({
        "definition": definition.name,
        "enums": package.enums.iter().map(|one| enum_json(package, one)).collect::<Vec<_>>(),
        "messages": package.messages.iter().map(|message| message_json(package, message)).collect::<Vec<_>>(),
    });
    format!("{value:#}\n")
}

fn enum_json(package: &Package, one: &Enum) -> Value {
    let entries = one.entries.iter();
    json!({
        "name": one.name.text,
        "message": package.message(one.message).map(|message| &message.name),
        "flags": one.flags,
        "type": one.repr.name(),
        "entries": entries
            .map(|entry| json!({ "name": entry.label, "value": integer(entry.value), "constant": entry.constant.name }))
            .collect::<Vec<_>>(),
    })
}

/// A value of a constant, which is one of 64 bits with or without a sign.
fn integer(value: i128) -> Option<Number> {
    u64::try_from(value).map(Number::from).or_else(|_| i64::try_from(value).map(Number::from)).ok()
}

fn message_json(package: &Package, message: &Message) -> Value {
    let constants = message.constants.iter().map(
        |constant| json!({ "name": constant.name, "type": constant.scalar.name(), "value": integer(constant.value) }),
    );
    json!({
        "name": message.name,
        "topics": message.topics,
        "version": message.version,
        "queue": message.queue,
        "message_hash": format!("{:08x}", message.hash),
        "type_hash": message.type_hash,
        "cdr_len": message.cdr_len,
        "struct_len": message.struct_len,
        "record_len": message.struct_len - message.struct_padding,
        "log_format": log_format(message, package),
        "fields": message.fields.iter().map(|field| field_json(package, field)).collect::<Vec<_>>(),
        "constants": constants.collect::<Vec<_>>(),
    })
}

fn field_json(package: &Package, field: &Field) -> Value {
    json!({
        "name": field.name,
        "type": type_name(package, field),
        "array": field.array,
        "cdr_offset": field.cdr_offset,
        "struct_offset": field.struct_offset,
        "enum": field.enum_.and_then(|index| package.enum_(index)).map(|one| &one.name.text),
        "units": field.docs.units,
        "invalid": field.invalid.as_ref().map(invalid),
        "range": field.docs.range.as_ref().map(|(low, high)| [low, high]),
        "frame": field.docs.frame,
        "was": field.was,
    })
}

/// The name of the type of its elements.
fn type_name<'p>(package: &'p Package, field: &Field) -> &'p str {
    match field.element {
        Element::Scalar(scalar) => scalar.name(),
        Element::Message(index) => package.message(index).map_or("", |message| &message.name),
    }
}

/// A sentinel as the grammar of `invalid` writes it.
fn invalid(invalid: &Invalid) -> String {
    let value = match invalid.sentinel {
        Sentinel::Integer(value) => value.to_string(),
        Sentinel::Float(value) => value.to_string(),
        Sentinel::NotANumber => "NaN".to_owned(),
    };
    match invalid.scope {
        Scope::Each => value,
        Scope::Whole => format!("[{value}:]"),
        Scope::First => format!("[{value},]"),
    }
}

/// A definition as lines for a person: messages with both layouts, then enums.
pub(super) fn text(definition: &Definition) -> String {
    let package = &definition.package;
    let mut text = String::new();
    for message in &package.messages {
        let Message { name, hash, cdr_len, struct_len, .. } = message;
        let version = message.version.map(|version| format!(" version {version}")).unwrap_or_default();
        text += &format!("{name}{version}: hash {hash:08x}, {cdr_len} bytes as CDR, {struct_len} as a struct\n");
        text += &format!("  {}\n", message.type_hash);
        text += &format!("  topics: {}\n", message.topics.join(" "));
        text += "   cdr struct\n";
        for field in &message.fields {
            field_line(&mut text, package, field);
        }
        for constant in &message.constants {
            text += &format!("  {} = {}: {}\n", constant.name, constant.value, constant.scalar.name());
        }
    }
    for one in &package.enums {
        let kind = if one.flags { "flags" } else { "enum" };
        text += &format!("{kind} {}: {}\n", one.name.text, one.repr.name());
        for entry in &one.entries {
            text += &format!("  {:>10} {} ({})\n", entry.value, entry.label, entry.constant.name);
        }
    }
    text
}

fn field_line(text: &mut String, package: &Package, field: &Field) {
    let enum_ = field.enum_.and_then(|index| package.enum_(index)).map(|one| one.name.text.clone());
    let unknown = field.invalid.as_ref().map(|one| format!("unknown: {}", invalid(one)));
    let said = [field.docs.units.clone(), enum_, unknown].into_iter().flatten();
    let said: String = said.map(|part| format!(" {part}")).collect();
    let array = field.array.map(|length| format!("[{length}]")).unwrap_or_default();
    let (cdr, at, name, ty) = (field.cdr_offset, field.struct_offset, &field.name, type_name(package, field));
    *text += &format!("  {cdr:>4} {at:>6}  {name}: {ty}{array}{said}\n");
}
