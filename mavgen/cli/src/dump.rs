//! `mavgen dump`: the resolved dialect as JSON in a stable schema, and as text.

mod uorb;
mod view;

use std::process::ExitCode;

use clap::Args;
use mavgen::ir::{Dialect, Enum, Field, Message, Scalar};
use mavgen::{Failure, Resolved, Topics};
use serde_json::{Value, json};

use super::input::{Input, resolve, resolve_topics};
use super::report::{self, Report, plural};
use view::Overlaid;

/// Prints the resolved dialect: wire order, offsets, checksums, merged enums, packed bits.
///
/// Of uORB messages: both layouts, hashes, formats of logs, constants and enums.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Dump {
    #[command(flatten)]
    input: Input,
    /// As JSON, in a stable schema; of several dialects, one object after the other.
    #[arg(long)]
    json: bool,
}

const AFTER_HELP: &str = "\
Examples:
  mavgen dump xml/acme.xml
  mavgen dump xml/common.xml --messages HEARTBEAT
  mavgen dump xml/acme.xml --json | jq '.messages[].name'
  mavgen dump px4_msgs/msg --messages VehicleStatus
  mavgen dump px4_msgs/msg/EscStatus.msg --json | jq '.messages[].cdr_len'";

impl Dump {
    pub(super) fn run(&self, report: &Report) -> Result<ExitCode, Failure> {
        let builder = self.input.builder()?;
        if builder.is_uorb() {
            return self.topics(&resolve_topics(&builder, report)?);
        }
        let Resolved { dialect, others, .. } = resolve(&builder, report)?;
        for dialect in std::iter::once(&dialect).chain(&others) {
            report::print(&if self.json { json(dialect) } else { text(dialect) })?;
        }
        Ok(ExitCode::SUCCESS)
    }

    fn topics(&self, topics: &Topics) -> Result<ExitCode, Failure> {
        for definition in &topics.union.definitions {
            report::print(&if self.json { uorb::json(definition) } else { uorb::text(definition) })?;
        }
        Ok(ExitCode::SUCCESS)
    }
}

/// The dialect as JSON.
///
/// Enums stand in merge order with their entries by value, messages by id, fields in the order of the XML. An enum that
/// several files define is `defined_in` the first of them, as in pymavlink's model. What overlays add to a message stands in its
/// `bindings` and `views`.
fn json(dialect: &Dialect) -> String {
    let files: Vec<&str> = dialect.files.iter().map(|file| file.name.as_str()).collect();
    let enums: Vec<Value> = dialect.enums.iter().map(|enum_| enum_json(dialect, enum_)).collect();
    let messages: Vec<Value> = dialect.messages.iter().map(|message| message_json(dialect, message)).collect();
    let value = json!({
        "dialect": dialect.name,
        "version": dialect.version,
        "files": files,
        "enums": enums,
        "messages": messages,
    });
    format!("{value:#}\n")
}

fn enum_json(dialect: &Dialect, enum_: &Enum) -> Value {
    let entries: Vec<Value> = enum_
        .entries
        .iter()
        .map(|entry| json!({ "name": entry.name.text, "value": entry.value, "auto": entry.auto }))
        .collect();
    json!({
        "name": enum_.name.text,
        "bitmask": enum_.bitmask,
        "defined_in": dialect.file(enum_.origin.file).map(|file| file.name.as_str()),
        "entries": entries,
    })
}

fn message_json(dialect: &Dialect, message: &Message) -> Value {
    let overlaid = Overlaid { dialect, message };
    let fields: Vec<Value> = message.fields.iter().map(|field| field_json(dialect, field)).collect();
    json!({
        "id": message.id,
        "name": message.name.text,
        "crc_extra": message.crc_extra,
        "len_v1": message.len_v1,
        "len_v2": message.len_v2,
        "defined_in": dialect.file(message.origin.file).map(|file| file.name.as_str()),
        "fields": fields,
        "bindings": overlaid.bindings_json(),
        "views": overlaid.views_json(),
    })
}

fn field_json(dialect: &Dialect, field: &Field) -> Value {
    let (ty, version) = match field.ty.scalar {
        Scalar::Version(version) => ("uint8_t_mavlink_version", Some(version)),
        other => (other.wire_name(), None),
    };
    json!({
        "name": field.name.text,
        "type": ty,
        "array": field.ty.array,
        "offset": field.offset,
        "extension": field.extension,
        "enum": enum_name(dialect, field),
        "units": field.units,
        "version": version,
    })
}

fn enum_name<'d>(dialect: &'d Dialect, field: &Field) -> Option<&'d str> {
    let enum_ = dialect.enum_by_id(field.values?.id())?;
    Some(enum_.name.text.as_str())
}

/// The dialect as lines for a person: messages with their wire layout, then enums.
fn text(dialect: &Dialect) -> String {
    let mut text = String::new();
    for message in &dialect.messages {
        let Message { id, name, crc_extra, len_v1, len_v2, .. } = message;
        text += &format!(
            "{id} {}: {} ({len_v1} in MAVLink 1), crc_extra {crc_extra}\n",
            name.text,
            plural(usize::from(*len_v2), "byte")
        );
        for field in message.wire_order() {
            field_line(&mut text, dialect, field);
        }
        for overlaid in (Overlaid { dialect, message }).lines() {
            text += &format!("  {overlaid}\n");
        }
    }
    for enum_ in &dialect.enums {
        let kind = if enum_.bitmask { "flags" } else { "enum" };
        text += &format!("{kind} {}: {}\n", enum_.name.text, enum_.repr.name());
        for entry in &enum_.entries {
            let auto = if entry.auto { " (automatic)" } else { "" };
            text += &format!("  {:>10} {}{auto}\n", entry.value, entry.name.text);
        }
    }
    text
}

fn field_line(text: &mut String, dialect: &Dialect, field: &Field) {
    let array = field.ty.array.map_or_else(String::new, |n| format!("[{n}]"));
    let units = field.units.as_ref().map_or_else(String::new, |units| format!(" {units}"));
    let enum_ = enum_name(dialect, field).map_or_else(String::new, |name| format!(" {name}"));
    let extension = if field.extension { " extension" } else { "" };
    let (offset, name, ty) = (field.offset, &field.name.text, field.ty.scalar.wire_name());
    *text += &format!("  {offset:>3} {name}: {ty}{array}{units}{enum_}{extension}\n");
}
