//! Several definitions of the same messages, as one model: each message is the union of what it was.
//!
//! Fields are those of the newest definition in its order, then what only older ones have. The longest array and the widest
//! number win, so that whatever a definition says has a place.

mod fields;
mod nesting;

use std::collections::HashMap;

use super::model::{self, Constant, EnumIndex, MessageIndex, Package};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Invalid, Name, Repr};
use crate::source::{FileId, Span};

/// Messages of one or several definitions.
#[derive(Clone, Debug, Default)]
pub struct Union {
    /// What the package is called: `px4`.
    pub name: String,
    /// The definitions, newest first.
    pub definitions: Vec<Definition>,
    /// The messages of all definitions.
    pub messages: Vec<Message>,
    /// The enums of all definitions.
    pub enums: Vec<Enum>,
}

/// What all messages were at one time.
#[derive(Clone, Debug)]
pub struct Definition {
    /// `main`, `v1_14`
    pub name: String,
    /// The messages.
    pub package: Package,
}

/// A message as all of its definitions together have it.
#[derive(Clone, Debug)]
pub struct Message {
    /// Its name, that of the file: `EscStatus`.
    pub name: String,
    /// The file of the newest definition.
    pub file: FileId,
    /// What that says about it.
    pub text: String,
    /// The topics that carry it; those of the newest definition come first.
    pub topics: Vec<String>,
    /// `MESSAGE_VERSION` of the newest definition.
    pub version: Option<u32>,
    /// `ORB_QUEUE_LENGTH` of the newest definition.
    pub queue: Option<u32>,
    /// Its fields.
    pub fields: Vec<Field>,
    /// Its constants that are in no enum.
    pub constants: Vec<Constant>,
    /// The definitions that have it, newest first.
    pub known: Vec<Known>,
}

/// A definition that has a message.
#[derive(Clone, Debug)]
pub struct Known {
    /// Which of [`Union::definitions`] it is.
    pub definition: usize,
    /// The message in its package.
    pub message: MessageIndex,
    /// For each field there, which of the union's it is.
    pub fields: Vec<usize>,
    /// A newer one of [`Message::known`] with the same hash, which is the same definition by another name.
    pub same_as: Option<usize>,
}

/// A field of a union.
#[derive(Clone, Debug)]
pub struct Field {
    /// Its name in the newest definition that has it.
    pub name: String,
    /// Where that stands.
    pub span: Span,
    /// The name that it had in older definitions.
    pub was: Option<String>,
    /// The type of its elements: the widest that a definition has. A message is one of [`Union::messages`].
    pub element: model::Element,
    /// The length of an array, the longest that a definition has.
    pub array: Option<u16>,
    /// What the comments say, of the newest definition that has it.
    pub docs: model::Docs,
    /// The enum that it carries.
    pub enum_: Option<EnumIndex>,
    /// The value that means "not known".
    pub invalid: Option<Invalid>,
    /// The newest of [`Union::definitions`] that has it, if that is not the newest that has the message.
    pub until: Option<usize>,
}

/// An enum: constants of all definitions.
#[derive(Clone, Debug)]
pub struct Enum {
    /// Its name.
    pub name: Name,
    /// The message whose constants they are.
    pub message: String,
    /// Whether they are bits.
    pub flags: bool,
    /// The integer: that of the first field that carries it.
    pub repr: Repr,
    /// The values, those of newer definitions first.
    pub entries: Vec<model::Entry>,
}

impl Union {
    /// Joins definitions, newest first. A field whose types cannot be one is an error.
    pub fn of(name: &str, definitions: Vec<Definition>, diagnostics: &mut Diagnostics) -> Self {
        let mut places: HashMap<&str, usize> = HashMap::new();
        let mut joined: Vec<Joined<'_>> = Vec::new();
        for (at, definition) in definitions.iter().enumerate() {
            for (i, message) in definition.package.messages.iter().enumerate() {
                let place = *places.entry(&message.name).or_insert(joined.len());
                match joined.get_mut(place) {
                    Some(known) => known.push((at, MessageIndex(i), message)),
                    None => joined.push(vec![(at, MessageIndex(i), message)]),
                }
            }
        }
        let mut enums = enums(&definitions, diagnostics);
        let context = fields::Context { definitions: &definitions, places: &places, enums: &enums };
        let messages = joined.iter().filter_map(|known| message(known, &context, diagnostics)).collect_vec();
        nesting::check(&messages, diagnostics);
        for (at, one) in enums.iter_mut().enumerate() {
            let mut fields = messages.iter().flat_map(|message| &message.fields);
            let first = fields.find(|field| field.enum_ == Some(EnumIndex(at)));
            one.repr = first.and_then(|field| field.element.scalar()?.repr()).unwrap_or(one.repr);
        }
        Self { name: name.to_owned(), definitions, messages, enums }
    }

    /// Keeps of a message's field what it carries only if the field's integer is the enum's.
    pub fn typed(&self, field: &Field) -> Option<EnumIndex> {
        let (index, repr) = (field.enum_?, field.element.scalar()?.repr()?);
        (self.enums.get(index.0)?.repr == repr).then_some(index)
    }
}

/// The definitions that have a message, newest first: which, where in it, and the message.
type Joined<'d> = Vec<(usize, MessageIndex, &'d model::Message)>;

fn message(known: &Joined<'_>, context: &fields::Context<'_>, diagnostics: &mut Diagnostics) -> Option<Message> {
    let (_, _, newest) = known.first()?;
    let (fields, places) = fields::join(known, context, diagnostics);
    let mut topics: Vec<String> = Vec::new();
    for topic in known.iter().flat_map(|(_, _, message)| &message.topics) {
        if !topics.contains(topic) {
            topics.push(topic.clone());
        }
    }
    let first_of = |hash: u32| known.iter().position(|(_, _, newer)| newer.hash == hash);
    let found = known.iter().zip(places).enumerate().map(|(at, (&(definition, index, message), fields))| {
        let same_as = first_of(message.hash).filter(|newer| *newer < at);
        Known { definition, message: index, fields, same_as }
    });
    Some(Message {
        name: newest.name.clone(),
        file: newest.file,
        text: newest.about.join("\n"),
        topics,
        version: newest.version,
        queue: newest.queue,
        fields,
        constants: constants(known, context, diagnostics),
        known: found.collect_vec(),
    })
}

/// The constants of the newest definition, then what only older ones have, without those that an enum has.
fn constants(known: &Joined<'_>, context: &fields::Context<'_>, diagnostics: &mut Diagnostics) -> Vec<Constant> {
    let mut constants: Vec<Constant> = Vec::new();
    for (_, _, message) in known {
        for constant in &message.constants {
            match constants.iter().find(|newer| newer.name == constant.name) {
                Some(newer) => diagnostics.extend(changed(newer, constant)),
                None if is_in_enum(context.enums, &message.name, &constant.name) => {}
                None => constants.push(constant.clone()),
            }
        }
    }
    constants
}

/// A constant is one thing for all definitions: a warning if an older one has another value.
fn changed(newer: &Constant, older: &Constant) -> Option<Diagnostic> {
    let (name, now, was) = (&older.name, newer.value, older.value);
    let message = format!("`{name}` is {was} here and {now} in a newer definition");
    let problem = Diagnostic::new(Code::UorbConstantChanged, older.span, message)
        .related(newer.span, "the newer definition has it here")
        .help(format!("the generated constant is {now}; what was sent by this definition means it by {was}"));
    (now != was).then_some(problem)
}

/// Whether a constant of a message is in an enum.
fn is_in_enum(enums: &[Enum], message: &str, constant: &str) -> bool {
    let own = enums.iter().filter(|one| one.message == message);
    own.flat_map(|one| &one.entries).any(|entry| entry.constant.name == constant)
}

/// The enums of all definitions, those of one name joined; each with the integer of the newest.
fn enums(definitions: &[Definition], diagnostics: &mut Diagnostics) -> Vec<Enum> {
    let mut enums: Vec<Enum> = Vec::new();
    for Definition { package, .. } in definitions {
        for one in &package.enums {
            match enums.iter_mut().find(|newer| newer.name.text == one.name.text) {
                Some(newer) => add(&mut newer.entries, &one.entries, diagnostics),
                None => enums.push(Enum {
                    name: one.name.clone(),
                    message: package.message(one.message).map_or_else(String::new, |of| of.name.clone()),
                    flags: one.flags,
                    repr: one.repr,
                    entries: one.entries.clone(),
                }),
            }
        }
    }
    enums
}

/// Adds what a newer definition lacks.
fn add(entries: &mut Vec<model::Entry>, older: &[model::Entry], diagnostics: &mut Diagnostics) {
    for entry in older {
        match entries.iter().find(|known| known.constant.name == entry.constant.name) {
            Some(newer) => diagnostics.extend(changed(&newer.constant, &entry.constant)),
            None => entries.push(entry.clone()),
        }
    }
}
