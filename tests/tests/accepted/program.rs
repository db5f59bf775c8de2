//! The program that tells payloads by generated accessors.

use std::fmt::Write;

use mavgen::GeneratedFile;
use mavgen::ir::{Access, Key, Meaning, Member, Message, Place, Presence, Scalar, View};

/// What stands around the functions for each dialect.
pub(crate) const HEAD: &str = r#"
use std::fmt::{Debug, Display};
use std::io::{BufRead, stdin};
use mavlink_wire::{Encode, Message, Version};

fn say(name: &str, value: Option<impl Display>) {
    match value {
        Some(value) => println!("{name} {value}"),
        None => println!("{name} -"),
    }
}

fn say_float(name: &str, value: Option<impl Debug>) {
    say(name, value.map(|value| format!("{value:?}")));
}

fn sent(message: &dyn Encode) -> String {
    message.payload(Version::V2, &mut [0; 255]).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn default_of<M: Message>(_: &M) -> M {
    M::DEFAULT
}

/// What a getter gave was set, which changes nothing.
fn same(one: &dyn Encode, other: &dyn Encode) {
    assert_eq!(sent(one), sent(other), "{}", one.info().name);
}

fn main() {
    for line in stdin().lock().lines() {
        let line = line.unwrap();
        let words: Vec<&str> = line.split(' ').collect();
        let byte = |at: usize| u8::from_str_radix(&words[2][at..at + 2], 16).unwrap();
        let payload: Vec<u8> = (0..words[2].len()).step_by(2).map(byte).collect();
        println!("{line}");
        tell(words[0].parse().unwrap(), words[1].parse().unwrap(), &payload);
    }
}
"#;

/// The generated files of one dialect, and the name of its module.
pub(crate) struct Sources<'a> {
    pub(crate) module: String,
    pub(crate) files: &'a [GeneratedFile],
}

impl Sources<'_> {
    /// The type that stands after `before` in the file of which `is_it` is true.
    fn ty(&self, folder: &str, before: &str, is_it: impl Fn(&str) -> bool) -> Option<String> {
        let mut files = self.files.iter().filter(|file| file.path.starts_with(folder) && is_it(&file.text));
        let (_, rest) = files.next()?.text.split_once(before)?;
        let name = rest.split(|letter: char| letter != '_' && !letter.is_alphanumeric()).next()?;
        Some(format!("{}::{name}", self.module))
    }

    /// `if id == 300 { … }`
    pub(crate) fn message(&self, message: &Message) -> String {
        let (id, name) = (message.id, &message.name.text);
        let info = |text: &str| {
            text.split("MessageInfo::new(").nth(1).and_then(|rest| rest.split(')').next()).map(str::to_owned)
        };
        let is_it = |text: &str| info(text).is_some_and(|info| info.contains(&format!("{name:?}")));
        let ty = self.ty("messages/", "impl wire::Message for ", is_it).unwrap();
        let mut code = format!("if id == {id} {{\nlet m = {ty}::decode(payload);\nsay(\"sent\", Some(sent(&m)));\n");
        for binding in &message.bindings {
            let getter = ident(&binding.name.shown());
            let value = optional(&format!("m.{getter}()"), binding.condition.is_some());
            writeln!(code, "say({:?}, {value});", binding.name.shown()).unwrap();
            let set = getter.trim_start_matches("r#");
            writeln!(code, "if let Some(x) = {value} {{ let mut n = m; n.set_{set}(x); same(&n, &m); }}").unwrap();
        }
        message.views.iter().for_each(|view| code += &self.view(message, view));
        code + "}\n"
    }

    fn view(&self, message: &Message, view: &View) -> String {
        let is_it = |text: &str| text.contains(&format!("/// `{}` of `", view.name.text));
        let ty = self.ty("views/", "pub struct ", is_it).unwrap();
        match &view.access {
            Access::Once { getter } => {
                let (name, get) = (getter.shown(), ident(&getter.shown()));
                let back = format!("let mut n = m; n.set_{}(v); same(&n, &m);", get.trim_start_matches("r#"));
                format!("let v: Option<{ty}> = m.{get}().into();\n{}", members(&name, view, &back))
            }
            Access::Record(record) => {
                let (name, get) = (record.getter.shown(), ident(&record.getter.shown()));
                let plain = get.trim_start_matches("r#");
                let values: String = record.values.iter().map(|value| self::key(message, value)).collect();
                format!(
                    "let v: Option<{ty}> = m.{get}().into();\nsay({name:?}, v.map(|_| \"is\"));\n\
                     if let Some(slot) = v {{\nlet mut n = m; n.set_{plain}(slot); same(&n, &m);\n{}{values}}}\n",
                    back_from_nothing(&ty, &get)
                )
            }
            Access::Slots(slots) => {
                let (name, get) = (slots.items.shown(), ident(&slots.items.shown()));
                let one = snake(&slots.item.text);
                let keys: String = slots.keys.iter().map(|key| self::key(message, key)).collect();
                let back =
                    format!("let mut n = m; _ = n.set_{}(index, slot); same(&n, &m);", one.trim_start_matches("r#"));
                let members = members(&name, view, &back);
                format!(
                    "for (index, slot) in m.{get}().enumerate() {{\n{keys}\
                     let v: Option<{ty}> = slot.status.into();\n{members}}}\n"
                )
            }
        }
    }
}

/// What a record is written into need not have been one: then it is, and has these values.
fn back_from_nothing(ty: &str, get: &str) -> String {
    let with = format!("with_{}", get.trim_start_matches("r#"));
    format!(
        "let n = default_of(&m).{with}(slot);\nlet w: Option<{ty}> = n.{get}().into();\n\
         assert_eq!(format!(\"{{w:?}}\"), format!(\"{{v:?}}\"));\n"
    )
}

/// Tells the members of `v`, and writes each back.
fn members(name: &str, view: &View, back: &str) -> String {
    let mut code = format!("say({name:?}, v.map(|_| \"is\"));\nif let Some(v) = v {{\n{back}\n");
    for member in &view.members {
        let count = member.repeat.map_or(1, |repeat| repeat.count);
        (0..count).for_each(|index| code += &self::member(member, index));
    }
    code + "}\n"
}

fn member(member: &Member, index: u8) -> String {
    let (name, get) = (member.name.shown(), ident(&member.name.shown()));
    let plain = get.trim_start_matches("r#").trim_end_matches('_');
    let at = if member.repeat.is_some() { index.to_string() } else { String::new() };
    let is_optional = member.repeat.is_some() || member.presence != Presence::Always;
    let scaled = matches!(member.meaning, Meaning::Scaled(_));
    let value = optional(&format!("v.{get}({at})"), is_optional);
    // A rounded number does not lead back to every raw one.
    let (get, set) = match scaled {
        true => (format!("{plain}_raw"), format!("set_{plain}_raw")),
        false => (get.clone(), format!("set_{}", get.trim_start_matches("r#"))),
    };
    let raw = optional(&format!("v.{get}({at})"), is_optional);
    let at = if at.is_empty() { at } else { at + ", " };
    format!(
        "{}({name:?}, {value});\nif let Some(x) = {raw} {{ let mut w = v; _ = w.{set}({at}x); assert_eq!(w, v, {name:?}); }}\n",
        if scaled { "say_float" } else { "say" }
    )
}

fn key(message: &Message, key: &Key) -> String {
    let name = key.name.shown();
    let Place { field, .. } = key.place;
    let field = &message.fields[field.0];
    let value = optional(&format!("slot.{}", ident(&name)), key.invalid.is_some());
    match field.ty.scalar {
        Scalar::F32 | Scalar::F64 => format!("say_float({name:?}, {value});\n"),
        _ => format!("say({name:?}, {value});\n"),
    }
}

fn optional(value: &str, is_optional: bool) -> String {
    if is_optional { value.to_owned() } else { format!("Some({value})") }
}

/// A name as Rust spells it; what is no keyword may be raw as well.
fn ident(name: &str) -> String {
    match name {
        "self" | "super" | "crate" => format!("{name}_"),
        _ if name.starts_with(|first: char| first.is_ascii_digit()) => format!("_{name}"),
        _ => format!("r#{name}"),
    }
}

fn snake(name: &str) -> String {
    ident(&heck::ToSnakeCase::to_snake_case(name))
}

/// `fn tell` over all dialects, as modules of that crate.
pub(crate) fn tell<'a>(dialects: impl Iterator<Item = (u64, Sources<'a>, &'a [Message])>) -> String {
    let mut code = String::from("fn tell(seed: u64, id: u32, payload: &[u8]) {\nmatch seed {\n");
    for (seed, sources, messages) in dialects {
        let messages: String = messages.iter().map(|message| sources.message(message)).collect();
        writeln!(code, "{seed} => {{\n{messages}}}").unwrap();
    }
    code + "_ => {}\n}\n}\n"
}
