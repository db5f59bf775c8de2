//! One change, and how it is said.

use std::fmt;

use heck::ToKebabCase as _;

use crate::source::Span;

/// A change from an old state of a dialect to a new one. `Display` says it in a sentence, without the places.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// What kind of change.
    pub kind: Kind,
    /// Whether what worked with the old state no longer works with the new one.
    pub breaking: bool,
    /// What it is about, as the old state calls it: `HEARTBEAT.type`, `MAV_STATE.MAV_STATE_BOOT`, in Rust `MavState::BOOT`.
    pub item: String,
    /// How it was, if it was.
    pub from: Option<String>,
    /// How it is, if it is.
    pub to: Option<String>,
    /// What became of the frames of the message, if something did.
    pub frame: Option<Frame>,
    /// Where it is in the old definitions.
    pub old: Option<Span>,
    /// Where it is in the new definitions.
    pub new: Option<Span>,
}

/// What changed in the frames of a message: old and new.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// `crc_extra`.
    pub crc_extra: (u8, u8),
    /// Bytes of the payload in MAVLink 1.
    pub len_v1: (u8, u8),
    /// Bytes of the payload in MAVLink 2.
    pub len_v2: (u8, u8),
}

/// Kinds of changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// A message is new.
    MessageAdded,
    /// A message is gone.
    MessageRemoved,
    /// A message is called differently; its `crc_extra` hangs on its name.
    MessageName,
    /// A message is called differently and has other fields: another one has taken its id.
    MessageReplaced,
    /// A message has another id.
    MessageId,
    /// A field is new.
    FieldAdded,
    /// A field is gone.
    FieldRemoved,
    /// A field is called differently; if it is no extension, `crc_extra` hangs on its name.
    FieldName,
    /// A field has another type or length.
    FieldType,
    /// A field has another place among its neighbours.
    FieldOrder,
    /// A field became an extension, or ceased to be one.
    FieldExtension,
    /// An enum is new.
    EnumAdded,
    /// An enum is gone.
    EnumRemoved,
    /// An enum is called differently.
    EnumName,
    /// An entry is new.
    EntryAdded,
    /// An entry is gone.
    EntryRemoved,
    /// An entry is called differently.
    EntryName,
    /// An entry has another value.
    EntryValue,
    /// A type, field, constant, method or implementation is new in Rust.
    ItemAdded,
    /// One is gone.
    ItemRemoved,
    /// One is called differently.
    ItemName,
    /// One has another type or signature.
    ItemType,
    /// One makes the compiler warn.
    ItemDeprecated,
    /// One no longer makes the compiler warn.
    ItemUndeprecated,
    /// A field of `DEFAULT` has another value.
    ItemDefault,
    /// Something that neither the wire nor the types show: its name.
    Fact(&'static str),
}

/// What changes are grouped by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Group {
    /// Messages: their ids, layouts and checksums.
    Wire,
    /// Enums: which values there are, and what they are called.
    Enums,
    /// The generated Rust.
    Api,
    /// Units, ranges, stages of life and the like.
    Metadata,
}

impl Group {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Wire, Self::Enums, Self::Api, Self::Metadata];

    /// A short name: `wire`, `enums`, `api`, `metadata`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wire => "wire",
            Self::Enums => "enums",
            Self::Api => "api",
            Self::Metadata => "metadata",
        }
    }
}

impl Kind {
    /// The group that it belongs to.
    pub fn group(self) -> Group {
        match self.subject() {
            "message" | "field" => Group::Wire,
            "enum" | "entry" => Group::Enums,
            "item" => Group::Api,
            _ => Group::Metadata,
        }
    }

    /// A short name, for programs: `field-type`.
    pub fn name(self) -> String {
        match self {
            Self::Fact(name) => name.to_owned(),
            kind => format!("{kind:?}").to_kebab_case(),
        }
    }

    /// What it is about; nothing for a fact, which may be about any of them.
    fn subject(self) -> &'static str {
        use Kind::*;
        match self {
            MessageAdded | MessageRemoved | MessageName | MessageReplaced | MessageId => "message",
            FieldAdded | FieldRemoved | FieldName | FieldType | FieldOrder | FieldExtension => "field",
            EnumAdded | EnumRemoved | EnumName => "enum",
            EntryAdded | EntryRemoved | EntryName | EntryValue => "entry",
            ItemAdded | ItemRemoved | ItemName | ItemType | ItemDeprecated | ItemUndeprecated | ItemDefault => "item",
            Fact(_) => "",
        }
    }
}

impl Change {
    /// A change of something that goes on to be there.
    pub(super) fn new(kind: Kind, breaking: bool, item: impl Into<String>) -> Self {
        let item = item.into();
        Self { kind, breaking, item, from: None, to: None, frame: None, old: None, new: None }
    }

    /// How it was, and how it is.
    pub(super) fn with(mut self, from: Option<impl ToString>, to: Option<impl ToString>) -> Self {
        (self.from, self.to) = (from.map(|from| from.to_string()), to.map(|to| to.to_string()));
        self
    }

    /// Where it is.
    pub(super) fn at(mut self, old: Option<Span>, new: Option<Span>) -> Self {
        (self.old, self.new) = (old, new);
        self
    }

    /// The group that it belongs to.
    pub fn group(&self) -> Group {
        self.kind.group()
    }
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, item, .. } = self;
        let (from, to) = (self.from.as_deref().unwrap_or("nothing"), self.to.as_deref().unwrap_or("nothing"));
        let said = |what: &Option<String>| what.as_ref().map_or_else(String::new, |what| format!(": {what}"));
        match kind.subject() {
            // The item says it.
            "" | "item" => write!(f, "{item}"),
            noun => write!(f, "{noun} {item}"),
        }?;
        match kind.name().as_str() {
            name if name.ends_with("-added") => write!(f, " is new{}", said(&self.to)),
            name if name.ends_with("-removed") => write!(f, " is gone{}", said(&self.from)),
            name if name.ends_with("-name") => write!(f, " is called {to} now"),
            "message-replaced" => write!(f, " is {to} now, with other fields"),
            "message-id" => write!(f, " has the id {to}, was {from}"),
            "field-order" => write!(f, " begins at byte {to}, was {from}"),
            "item-deprecated" => write!(f, " is deprecated"),
            "item-undeprecated" => write!(f, " is no longer deprecated"),
            "item-default" => write!(f, " is {to} by default, was {from}"),
            name if kind.group() == Group::Metadata => match (&self.from, &self.to) {
                (None, _) => write!(f, ": {name} {to}, was not there"),
                (_, None) => write!(f, ": no {name}, was {from}"),
                _ => write!(f, ": {name} {to}, was {from}"),
            },
            _ => write!(f, " is {to}, was {from}"),
        }?;
        self.frame.map_or(Ok(()), |frame| frame.fmt(f))
    }
}

impl fmt::Display for Frame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut facts = Vec::new();
        if self.crc_extra.0 != self.crc_extra.1 {
            facts.push(format!("crc_extra {}, was {}", self.crc_extra.1, self.crc_extra.0));
        }
        if self.len_v2.0 != self.len_v2.1 {
            facts.push(format!("{} bytes, was {}", self.len_v2.1, self.len_v2.0));
        }
        if self.len_v1.0 != self.len_v1.1 && self.len_v1 != self.len_v2 {
            facts.push(format!("in MAVLink 1 {} bytes, was {}", self.len_v1.1, self.len_v1.0));
        }
        if facts.is_empty() { Ok(()) } else { write!(f, " ({})", facts.join("; ")) }
    }
}
