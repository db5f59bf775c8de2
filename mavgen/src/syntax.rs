//! The spanned syntax: what a file says, spelled as it is spelled.
//!
//! One type per element of `mavlink.xsd`; those of overlays are in [`overlay`] and `uorb_overlay`. Nothing is defaulted, converted or
//! checked beyond what XML and the presence of
//! required attributes demand; that is the work of [`crate::resolve`].

pub mod overlay;
#[cfg(feature = "uorb")]
pub mod uorb_overlay;

pub use overlay::Overlay;

use crate::source::{FileId, Span, Spanned};

/// Character data, with entities expanded, or an attribute value.
pub type Text = Spanned<String>;

/// One dialect file: the `<mavlink>` element.
#[derive(Clone, Debug)]
pub struct File {
    /// The source.
    pub id: FileId,
    /// `<include>` paths in document order, trimmed.
    pub includes: Vec<Text>,
    /// `<version>`, if it stands in the file.
    pub version: Option<Version>,
    /// `<dialect>`, if it stands in the file.
    pub dialect: Option<Text>,
    /// The enums, in document order.
    pub enums: Vec<Enum>,
    /// The messages, in document order.
    pub messages: Vec<Message>,
}

/// `<version>`.
#[derive(Clone, Debug)]
pub struct Version {
    /// The number as it is written, trimmed.
    pub text: Text,
    /// How many messages of the file stand before it: those do not see it (pymavlink reads in document order).
    pub messages_before: usize,
}

/// `<enum>`.
#[derive(Clone, Debug)]
pub struct Enum {
    /// `name`.
    pub name: Text,
    /// `bitmask`.
    pub bitmask: Option<Text>,
    /// `<wip>`, `<superseded>` or `<deprecated>`.
    pub lifecycle: Option<Lifecycle>,
    /// `<description>`.
    pub description: Option<Text>,
    /// The entries, in document order.
    pub entries: Vec<Entry>,
    /// The start tag.
    pub span: Span,
}

/// `<entry>`.
#[derive(Clone, Debug)]
pub struct Entry {
    /// `name`.
    pub name: Text,
    /// `value`; without one the entry gets its value automatically.
    pub value: Option<Text>,
    /// `hasLocation`.
    pub has_location: Option<Text>,
    /// `isDestination`.
    pub is_destination: Option<Text>,
    /// `missionOnly`.
    pub mission_only: Option<Text>,
    /// `<wip>`, `<superseded>` or `<deprecated>`.
    pub lifecycle: Option<Lifecycle>,
    /// `<description>`.
    pub description: Option<Text>,
    /// The params, in document order.
    pub params: Vec<Param>,
    /// The start tag.
    pub span: Span,
}

/// `<param>` of a command.
#[derive(Clone, Debug)]
pub struct Param {
    /// `index`.
    pub index: Text,
    /// `label`.
    pub label: Option<Text>,
    /// `units`.
    pub units: Option<Text>,
    /// `enum`.
    pub enum_: Option<Text>,
    /// `increment`.
    pub increment: Option<Text>,
    /// `minValue`.
    pub min: Option<Text>,
    /// `maxValue`.
    pub max: Option<Text>,
    /// `reserved`.
    pub reserved: Option<Text>,
    /// `default`.
    pub default: Option<Text>,
    /// The text.
    pub description: Option<Text>,
    /// The start tag.
    pub span: Span,
}

/// `<message>`.
#[derive(Clone, Debug)]
pub struct Message {
    /// `id`.
    pub id: Text,
    /// `name`.
    pub name: Text,
    /// `<wip>`, `<superseded>` or `<deprecated>`.
    pub lifecycle: Option<Lifecycle>,
    /// `<description>`.
    pub description: Option<Text>,
    /// The fields, in document order.
    pub fields: Vec<Field>,
    /// Every `<extensions/>`, and how many fields stand before it.
    pub extensions: Vec<Spanned<usize>>,
    /// The start tag.
    pub span: Span,
}

/// `<field>`.
#[derive(Clone, Debug)]
pub struct Field {
    /// `type`.
    pub ty: Text,
    /// `name`.
    pub name: Text,
    /// `enum`.
    pub enum_: Option<Text>,
    /// `display`.
    pub display: Option<Text>,
    /// `units`.
    pub units: Option<Text>,
    /// `print_format`.
    pub print_format: Option<Text>,
    /// `default`.
    pub default: Option<Text>,
    /// `minValue`.
    pub min: Option<Text>,
    /// `maxValue`.
    pub max: Option<Text>,
    /// `increment`.
    pub increment: Option<Text>,
    /// `multiplier`.
    pub multiplier: Option<Text>,
    /// `invalid`.
    pub invalid: Option<Text>,
    /// `instance`.
    pub instance: Option<Text>,
    /// The text.
    pub description: Option<Text>,
    /// The start tag.
    pub span: Span,
}

/// `<wip>`, `<superseded>` or `<deprecated>`.
#[derive(Clone, Debug)]
pub struct Lifecycle {
    /// Which of the three.
    pub stage: Stage,
    /// `since`, as `YYYY-MM`.
    pub since: Option<Text>,
    /// `replaced_by`; may be empty.
    pub replaced_by: Option<Text>,
    /// The text.
    pub description: Option<Text>,
    /// The start tag.
    pub span: Span,
}

/// The stage of life that a lifecycle element names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Work in progress: may change.
    Wip,
    /// Something better exists; still in use.
    Superseded,
    /// Going away.
    Deprecated,
}
