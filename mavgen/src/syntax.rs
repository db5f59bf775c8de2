//! The spanned syntax: what a file says, spelled as it is spelled.
//!
//! One type per element of `mavlink.xsd`; those of overlays are in [`overlay`] and `uorb_overlay`. Nothing is defaulted,
//! converted or checked beyond what XML and the presence of required attributes demand; that is the work of
//! [`crate::Builder::resolve`].

mod element;
pub mod overlay;
#[cfg(feature = "uorb")]
pub mod uorb_overlay;

pub(crate) use element::{Attribute, Element, Tag, Type, Written};
pub use overlay::Overlay;

use crate::source::{FileId, Span, Spanned};
use element::{Member, element};

/// Character data, with entities expanded, or an attribute value.
pub type Text = Spanned<String>;

/// One dialect file: the `<mavlink>` element.
#[derive(Debug)]
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
#[derive(Debug)]
pub struct Version {
    /// The number as it is written, trimmed.
    pub text: Text,
    /// How many messages of the file stand before it: those do not see it (pymavlink reads in document order).
    pub messages_before: usize,
}

element! {
    /// `<enum>`.
    Enum {
        name: Text = "name",
        bitmask: Option<Text> = "bitmask" as Boolean,
        ;
        /// `<wip>`, `<superseded>` or `<deprecated>`.
        lifecycle: Option<Lifecycle>,
        /// `<description>`.
        description: Option<Text>,
        /// The entries, in document order.
        entries: Vec<Entry>,
    }
}

element! {
    /// `<entry>`.
    Entry {
        /// Without one the entry gets its value automatically.
        value: Option<Text> = "value" as Number,
        name: Text = "name",
        has_location: Option<Text> = "hasLocation" as Boolean,
        is_destination: Option<Text> = "isDestination" as Boolean,
        mission_only: Option<Text> = "missionOnly" as Boolean,
        ;
        /// `<wip>`, `<superseded>` or `<deprecated>`.
        lifecycle: Option<Lifecycle>,
        /// `<description>`.
        description: Option<Text>,
        /// The params, in document order.
        params: Vec<Param>,
        ;
        unread
        "hasAltitudeOnly" as Boolean,
        "mission" as Boolean,
        "fence" as Boolean,
        "rally" as Boolean,
        "command" as Boolean,
    }
}

element! {
    /// `<param>` of a command.
    Param {
        index: Text = "index" as Byte,
        label: Option<Text> = "label",
        units: Option<Text> = "units",
        enum_: Option<Text> = "enum",
        increment: Option<Text> = "increment" as Float,
        min: Option<Text> = "minValue" as Float,
        max: Option<Text> = "maxValue" as Float,
        reserved: Option<Text> = "reserved" as Boolean,
        default: Option<Text> = "default" as Default,
        ;
        /// The text.
        description: Option<Text>,
        ;
        unread
        "multiplier" as Multiplier,
        "instance" as Boolean,
        "decimalPlaces" as Byte,
    }
}

element! {
    /// `<message>`.
    Message {
        id: Text = "id",
        name: Text = "name",
        ;
        /// `<wip>`, `<superseded>` or `<deprecated>`.
        lifecycle: Option<Lifecycle>,
        /// `<description>`.
        description: Option<Text>,
        /// The fields, in document order.
        fields: Vec<Field>,
        /// Every `<extensions/>`, and how many fields stand before it.
        extensions: Vec<Spanned<usize>>,
    }
}

element! {
    /// `<field>`.
    Field {
        ty: Text = "type" as OfField,
        name: Text = "name",
        print_format: Option<Text> = "print_format",
        enum_: Option<Text> = "enum",
        display: Option<Text> = "display",
        units: Option<Text> = "units",
        increment: Option<Text> = "increment" as Float,
        min: Option<Text> = "minValue" as Float,
        max: Option<Text> = "maxValue" as Float,
        multiplier: Option<Text> = "multiplier" as Multiplier,
        default: Option<Text> = "default" as Default,
        instance: Option<Text> = "instance" as Boolean,
        invalid: Option<Text> = "invalid",
        ;
        /// The text.
        description: Option<Text>,
    }
}

/// `<wip>`, `<superseded>` or `<deprecated>`.
#[derive(Debug)]
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
