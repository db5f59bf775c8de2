//! The wire model: a resolved dialect, what its bytes are and mean.
//!
//! It is the public result of [`crate::Builder::resolve`]; tools other than the generator can be written on it. Everything is
//! spelled out: wire order, offsets, checksums, merged enums with every value filled in, bits of views. It belongs to no
//! language: names are those of the definitions.

mod carrier;
mod kept;
mod layout;
mod message;
mod name;
mod validate;
mod values;
mod view;
mod visit;

pub(crate) use carrier::Carrier;
pub(crate) use kept::Kept;
pub(crate) use layout::Layout;
pub use message::{Field, FieldType, Invalid, Limits, Message, Scalar, Scope, Sentinel, Values};
pub(crate) use message::{LARGEST_ID, MOST_FIELDS};
pub use name::{Label, Name};
pub(crate) use name::{param_words, unit_words};
pub use validate::{Fault, Valid};
pub(crate) use values::PARAMS;
pub use values::{Command, Entry, Enum, Param, Repr};
pub use view::{
    Access, Binding, Condition, Exact, FieldIndex, Key, Meaning, Member, Place, Presence, Record, Repeat, Scaled,
    Slots, Switch, SwitchOn, View, ViewSentinel, Word,
};
pub(crate) use view::{MOST_BITS, largest_of_bits, mask};
pub(crate) use visit::{enums_of_enum_mut, enums_of_message_mut};

use std::fmt;

use crate::order;
use crate::source::Span;

/// A dialect: the file that was asked for and all that it includes.
#[derive(Clone, Debug)]
pub struct Dialect {
    /// The stem of the file name: `autoquad`.
    pub name: String,
    /// `<version>` of the top file; 2, pymavlink's default, where it has none.
    pub version: u8,
    /// The files in merge order: breadth first from the top file.
    pub files: Vec<File>,
    /// The enums, each at the place of its first definition in merge order.
    pub enums: Vec<Enum>,
    /// The messages, by id.
    pub messages: Vec<Message>,
}

impl Dialect {
    /// The file behind an id of this dialect.
    pub fn file(&self, id: FileIndex) -> Option<&File> {
        self.files.get(id.0)
    }

    /// Orders the files by age: what is included comes before what includes it, overlays come last. Of two definitions that cannot
    /// stand together the younger one is wrong: its author knew of the other, and can mend it.
    pub fn age(&self, file: FileIndex) -> usize {
        let definitions = self.files.iter().take_while(|file| !file.overlay).count();
        if file.0 < definitions { definitions - 1 - file.0 } else { file.0 }
    }

    /// The enum behind an id of this dialect.
    pub fn enum_by_id(&self, id: EnumId) -> Option<&Enum> {
        self.enums.get(id.0)
    }
}

/// What could be resolved of a dialect, and the names of what could not: those are worth checking all the same, so that one run
/// finds all that is wrong.
#[derive(Clone, Debug)]
pub struct Partial {
    /// What could be resolved. Without an error it is legal; with one, ids and names may stand there twice.
    pub dialect: Dialect,
    /// The messages that are not in it.
    pub lost: Vec<LostMessage>,
    /// The types of views that are not in it.
    pub lost_views: Vec<LostView>,
}

/// A message that could not be resolved.
#[derive(Clone, Debug)]
pub struct LostMessage {
    /// Its name.
    pub name: Name,
    /// The file.
    pub file: FileIndex,
    /// The names of its fields, in the order of the XML.
    pub fields: Vec<Name>,
}

/// A view that could not be resolved, or its slot.
#[derive(Clone, Debug)]
pub struct LostView {
    /// The name of its type.
    pub name: Name,
    /// The overlay.
    pub file: FileIndex,
}

/// A file of the dialect, by its place in [`Dialect::files`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FileIndex(pub usize);

/// An enum of the dialect, by its place in [`Dialect::enums`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EnumId(pub usize);

/// A source file of the dialect.
#[derive(Clone, Debug)]
pub struct File {
    /// The file name without folders: `common.xml`.
    pub name: String,
    /// The files it includes.
    pub includes: Vec<FileIndex>,
    /// Whether it is an overlay.
    pub overlay: bool,
}

/// What `<wip>`, `<superseded>` and `<deprecated>` say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Lifecycle {
    /// May still change.
    Wip,
    /// Something better exists; still in use.
    Superseded(Successor),
    /// Going away.
    Deprecated(Successor),
}

/// The stage in words: `wip`, `deprecated since 2018-04, replaced by X`.
impl fmt::Display for Lifecycle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Wip => write!(f, "wip"),
            Self::Superseded(successor) => write!(f, "superseded{successor}"),
            Self::Deprecated(successor) => write!(f, "deprecated{successor}"),
        }
    }
}

/// What replaces something, since when and why.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Successor {
    /// `YYYY-MM`.
    pub since: Option<String>,
    /// The replacement, as the XML spells it; may be no name at all.
    pub replaced_by: Option<String>,
    /// The text of the element.
    pub description: String,
}

/// Since when, and what replaces it: ` since 2018-04, replaced by X`; nothing if neither is said.
impl fmt::Display for Successor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(since) = &self.since {
            write!(f, " since {since}")?;
        }
        match &self.replaced_by {
            Some(other) => write!(f, ", replaced by {other}"),
            None => Ok(()),
        }
    }
}

/// Where an item was written and what is said of it: common to messages, fields, enums, entries and params.
#[derive(Clone, Debug)]
pub struct Origin {
    /// The file.
    pub file: FileIndex,
    /// The overlays that add to it.
    pub overlays: Vec<FileIndex>,
    /// The start tag.
    pub span: Span,
    /// The description as the XML has it, with entities expanded; empty where there is none.
    pub description: String,
    /// Its stage of life, if the XML names one.
    pub lifecycle: Option<Lifecycle>,
}

impl Origin {
    /// The file and the overlays.
    pub fn files(&self) -> impl Iterator<Item = FileIndex> {
        std::iter::once(self.file).chain(self.overlays.iter().copied())
    }

    /// The files of several, each once.
    pub(crate) fn files_of<'o>(origins: impl Iterator<Item = &'o Self>) -> Vec<FileIndex> {
        let mut files = Vec::new();
        origins.for_each(|origin| files.extend(origin.files()));
        order::sort_and_dedup(&mut files);
        files
    }

    /// Changes every mention of a file.
    pub(crate) fn map_files(&mut self, mut change: impl FnMut(&mut FileIndex)) {
        change(&mut self.file);
        self.overlays.iter_mut().for_each(change);
    }

    /// Adds a paragraph to the description.
    pub(crate) fn append(&mut self, paragraph: &str) {
        if !self.description.trim().is_empty() {
            self.description.push_str("\n\n");
        }
        self.description.push_str(paragraph);
    }
}
