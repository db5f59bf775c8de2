//! uORB messages of one to three definitions, with an overlay: names that Rust has, narrower types, fields that come and go.

use std::fmt::Write;

use crate::chance::Chance;

/// Folders of `.msg` files, and what an overlay says of the newest.
#[derive(Clone, Debug)]
pub struct Topics {
    /// The number that it was made of.
    pub seed: u64,
    /// Path below a folder, `v3/Pump.msg`, and text.
    pub files: Vec<(String, String)>,
    /// The folders of the definitions, newest first.
    pub definitions: Vec<String>,
    /// The overlay, a file beside them.
    pub overlay: String,
}

const MESSAGES: [&str; 10] =
    ["Option", "Bindings", "Topics", "Field", "Definition", "Pump", "PumpState", "Px4ioTank2", "Debug", "Default"];

const FIELDS: [&str; 24] = [
    "p",
    "one",
    "read",
    "record",
    "places",
    "topic",
    "body",
    "type",
    "self",
    "crate",
    "get",
    "put",
    "definition",
    "fn",
    "x1",
    "wire",
    "main",
    "v3",
    "unknown",
    "name",
    "clone",
    "eq",
    "to_cdr",
    "level_m",
];

const CONSTANTS: [&str; 10] =
    ["NAME", "V3", "UNKNOWN", "VERSION", "MODE_OFF", "MODE_2ND", "MODE_Slow", "STATE", "FIELDS", "Mixed_Case"];

/// Types, each with those that widen to it.
const TYPES: [(&str, &[&str]); 12] = [
    ("uint8", &["bool"]),
    ("int8", &["bool"]),
    ("uint16", &["uint8", "bool"]),
    ("int16", &["int8", "uint8"]),
    ("uint32", &["uint16", "uint8"]),
    ("int32", &["int16", "uint16"]),
    ("uint64", &["uint32", "bool"]),
    ("int64", &["uint32", "int8"]),
    ("float32", &["uint16", "int8"]),
    ("float64", &["float32", "int32"]),
    ("bool", &[]),
    ("char", &[]),
];

#[derive(Clone)]
struct Field {
    name: &'static str,
    /// The place of a type, or behind all of them that of a message.
    ty: usize,
    narrower: Option<&'static str>,
    array: Option<usize>,
    comment: String,
}

#[derive(Clone)]
struct Message {
    name: &'static str,
    fields: Vec<Field>,
    constants: String,
}

/// The topics of a seed.
#[must_use]
pub fn topics(seed: u64) -> Topics {
    let chance = &mut Chance::new(seed ^ 0x70_7069_6373);
    let mut messages = newest(chance);
    let (mut files, mut overlay) = (Vec::new(), String::new());
    for message in &messages {
        _ = write!(overlay, "<message name=\"{}\">{}</message>", message.name, refined(message, chance));
    }
    let definitions: Vec<String> = (1..=chance.between(1, 3)).rev().map(|number| format!("v{number}")).collect();
    for definition in &definitions {
        files.extend(messages.iter().map(|message| written(definition, message, &messages)));
        messages.iter_mut().for_each(|message| make_older(message, chance));
    }
    let newest = definitions.first().cloned().unwrap_or_default();
    let overlay = format!("<uorb-overlay version=\"1\" for=\"{newest}\">{overlay}</uorb-overlay>");
    Topics { seed, files, definitions, overlay }
}

fn newest(chance: &mut Chance) -> Vec<Message> {
    let mut names = MESSAGES.to_vec();
    let count = chance.between(1, 4);
    let mut messages: Vec<Message> = Vec::new();
    for nested in 0..count {
        let name = names.swap_remove(chance.below(names.len()));
        let mut free = FIELDS.to_vec();
        let fields = (0..chance.between(1, 9)).map(|_| {
            let name = free.swap_remove(chance.below(free.len()));
            let ty = chance.below(TYPES.len() + nested);
            let array = chance.one_in(3).then(|| chance.between(1, 5));
            Field { name, ty, narrower: None, array, comment: comment(ty, chance) }
        });
        let mut fields: Vec<Field> = fields.collect();
        let time = Field { name: "timestamp", ty: 6, narrower: None, array: None, comment: String::new() };
        // Mostly it comes first. Where it does not, elements of an array lie in two ways.
        let at = if chance.one_in(3) { chance.below(fields.len() + 1) } else { 0 };
        fields.insert(at, time);
        messages.push(Message { name, fields, constants: constants(chance) });
    }
    messages
}

fn comment(ty: usize, chance: &mut Chance) -> String {
    let group = match chance.below(8) {
        0 if ty < 6 => "[@enum MODE]",
        1 => "[@invalid 0]",
        2 if (8..10).contains(&ty) => "[@invalid NaN]",
        3 => "[m/s] [@range -1,]",
        4 => "[@frame NED] a `comment` with <b> and *stars*;",
        _ => return String::new(),
    };
    format!(" # {group}")
}

fn constants(chance: &mut Chance) -> String {
    let mut text = String::new();
    let sign = if chance.one_in(3) { -1 } else { 1 };
    for (at, name) in CONSTANTS.iter().enumerate() {
        if chance.one_in(2) {
            let value = sign * i32::try_from(at).unwrap_or_default();
            _ = writeln!(text, "{} {name} = {value} # One;", if sign < 0 { "int8" } else { "uint8" });
        }
    }
    text
}

/// What an overlay says of some fields.
fn refined(message: &Message, chance: &mut Chance) -> String {
    let mut text = String::new();
    for field in message.fields.iter().filter(|field| field.name != "timestamp") {
        let says = match chance.below(6) {
            0 => "units=\"m\"",
            1 if field.ty < 8 => "invalid=\"1\"",
            2 => "was=\"former\"",
            _ => continue,
        };
        if !(says.starts_with("was") && text.contains("was")) {
            _ = write!(text, "<field name=\"{}\" {says}/>", field.name);
        }
    }
    text
}

/// Makes it what it may have been before.
fn make_older(message: &mut Message, chance: &mut Chance) {
    message.fields.retain(|field| field.name == "timestamp" || !chance.one_in(6));
    for field in &mut message.fields {
        if field.name == "timestamp" {
            continue;
        }
        if let Some((_, narrower)) = TYPES.get(field.ty).filter(|_| field.narrower.is_none() && chance.one_in(3)) {
            field.narrower = chance.pick(narrower).copied();
        }
        if let Some(length) = field.array.filter(|_| chance.one_in(2)) {
            field.array = Some((length + chance.below(4)).saturating_sub(1).max(1));
        }
        if chance.one_in(9) {
            field.name = "former";
            break;
        }
    }
    if chance.one_in(3) {
        message.constants.clear();
        message.fields.iter_mut().for_each(|field| field.comment.clear());
    }
    let is_free = message.fields.iter().all(|field| field.name != "older_only");
    if is_free && chance.one_in(2) {
        let field =
            Field { name: "older_only", ty: chance.below(9), narrower: None, array: None, comment: String::new() };
        message.fields.insert(chance.below(message.fields.len() + 1), field);
    }
}

fn written(definition: &str, message: &Message, messages: &[Message]) -> (String, String) {
    let mut text = message.constants.clone();
    for field in &message.fields {
        let ty = match TYPES.get(field.ty) {
            Some((name, _)) => field.narrower.unwrap_or(name),
            None => messages.get(field.ty - TYPES.len()).map_or("uint8", |nested| nested.name),
        };
        let array = field.array.map(|length| format!("[{length}]")).unwrap_or_default();
        _ = writeln!(text, "{ty}{array} {}{}", field.name, field.comment);
    }
    (format!("{definition}/{}.msg", message.name), text)
}
