//! What an overlay says: `<mavlink-overlay>` and the elements in it.
//!
//! ```xml
//! <mavlink-overlay version="1" for="acme.xml">
//!   <enums>…</enums>
//!   <refine enum="ACME_FLAGS" bitmask="true"/>
//!   <note message="SPRAYER" field="level">Tanks from before 2020 report the level of the pump.</note>
//!   <command name="MAV_CMD_SPRAY"><param index="1" label="Flow" units="m/s"/></command>
//!   <message name="SPRAYER">
//!     <bind name="flags" field="raw_flags" enum="ACME_FLAGS" if="maker" is="MAKER_ACME"/>
//!     <view name="NOZZLE_STATUS" words="low[i] high[i]" item="nozzle" items="nozzles" count="used">
//!       <key name="age" field="age[i]" units="ms" invalid="UINT16_MAX"/>
//!       <invalid value="0"/>
//!       <bits name="pressure" at="0" width="12" scale="1/100" units="bar" exact="cbar">Pressure.</bits>
//!       <reserved at="12" width="4"/>
//!       <switch field="version[i]">
//!         <case value="3..=9 30.."><bits name="flow" at="16" width="16"/></case>
//!         <default><bits name="errors" at="16" width="16"/></default>
//!       </switch>
//!     </view>
//!     <view name="WIND" item="wind" if="kind" is="3"><value name="speed" field="x" units="m/s"/></view>
//!   </message>
//! </mavlink-overlay>
//! ```

use super::element::{Member, element};
use super::{Attribute, Element, Enum, Tag, Text};
use crate::source::{FileId, Span};

/// One overlay: the `<mavlink-overlay>` element.
#[derive(Debug)]
pub struct Overlay {
    /// The source.
    pub id: FileId,
    /// `version` of the grammar.
    pub version: Option<Text>,
    /// `for`: the file of the dialect that it belongs to.
    pub base: Option<Text>,
    /// New enums, in document order.
    pub enums: Vec<Enum>,
    /// `<refine>`, in document order.
    pub refinements: Vec<Refinement>,
    /// `<note>`, in document order.
    pub notes: Vec<Note>,
    /// `<message>`, in document order.
    pub messages: Vec<Additions>,
    /// `<command>`, in document order.
    pub commands: Vec<Command>,
}

element! {
    /// `<command>`: what the params of a command are.
    Command {
        /// An entry of `MAV_CMD`.
        name: Text = "name",
        has_location: Option<Text> = "hasLocation",
        is_destination: Option<Text> = "isDestination",
        ;
        /// `<param>`, in document order.
        params: Vec<NamedParam>,
    }
}

element! {
    /// `<param>` of a command in an overlay.
    NamedParam {
        index: Text = "index",
        label: Text = "label",
        units: Option<Text> = "units",
        enum_: Option<Text> = "enum",
    }
}

element! {
    /// `<refine>`: what the definitions leave unsaid about an enum.
    Refinement {
        enum_: Text = "enum",
        bitmask: Option<Text> = "bitmask",
        deprecated: Option<Text> = "deprecated",
    }
}

element! {
    /// `<note>`: a paragraph for the documentation of something.
    Note {
        message: Option<Text> = "message",
        /// One of the message.
        field: Option<Text> = "field",
        enum_: Option<Text> = "enum",
        /// One of the enum.
        entry: Option<Text> = "entry",
        ;
        /// The text, trimmed.
        text: Option<Text>,
    }
}

element! {
    /// `<message>` of an overlay: what it adds to a message.
    Additions {
        name: Text = "name",
        ;
        /// `<bind>`, in document order.
        bindings: Vec<Bind>,
        /// `<view>`, in document order.
        views: Vec<View>,
    }
}

element! {
    /// `<bind>`: a field that carries an enum.
    Bind {
        /// That of the getter.
        name: Text = "name",
        field: Text = "field",
        enum_: Text = "enum",
        condition: Condition = "if" and "is",
        ;
        /// The text, trimmed.
        description: Option<Text>,
    }
}

/// `if="field" is="value"`: both or none.
#[derive(Debug)]
pub struct Condition {
    /// `if`.
    pub field: Option<Text>,
    /// `is`.
    pub value: Option<Text>,
}

impl Member for Condition {
    fn take(tag: &mut Tag<'_>, _: &'static str) -> Self {
        match (tag.take("if"), tag.take("is")) {
            (Some(field), None) => Self { field: Some(field), value: Some(tag.require("is")) },
            (None, Some(value)) => Self { field: Some(tag.require("if")), value: Some(value) },
            (field, value) => Self { field, value },
        }
    }
}

element! {
    /// `<view>`: a layout of bits over fields, or values in fields.
    View {
        name: Text = "name",
        /// A view of values has none.
        words: Option<Text> = "words",
        item: Option<Text> = "item",
        items: Option<Text> = "items",
        count: Option<Text> = "count",
        partial: Option<Text> = "partial",
        condition: Condition = "if" and "is",
        ;
        /// `<key>`, in document order.
        keys: Vec<Key>,
        /// `<value>`, in document order.
        values: Vec<Key>,
        /// `<invalid>`, in document order.
        invalids: Vec<Invalid>,
        /// `<bits>`, `<reserved>` and `<switch>`, in document order.
        parts: Vec<Part>,
        /// `<description>`, or else the text, trimmed.
        description: Option<Text>,
    }
}

element! {
    /// `<key>`: a field that a slot carries along; or `<value>`: a field that a view gives a name.
    Key {
        name: Text = "name",
        field: Text = "field",
        units: Option<Text> = "units",
        invalid: Option<Text> = "invalid",
        ;
        /// The text, trimmed.
        description: Option<Text>,
    }
}

element! {
    /// `<invalid>`: a value that says that a view means nothing.
    Invalid {
        /// Without one it is about the words themselves.
        field: Option<Text> = "field",
        value: Text = "value",
    }
}

/// A part of a view.
#[derive(Debug)]
pub enum Part {
    /// `<bits>`, `<reserved>`.
    Piece(Piece),
    /// `<switch>`.
    Switch(Switch),
}

/// Bits with a name, or without a meaning.
#[derive(Debug)]
pub enum Piece {
    /// `<bits>`.
    Bits(Box<Bits>),
    /// `<reserved>`.
    Reserved(Reserved),
}

element! {
    /// `<bits>`.
    Bits {
        /// That of the getter.
        name: Text = "name",
        /// The first bit.
        at: Text = "at",
        width: Text = "width",
        enum_: Option<Text> = "enum",
        signed: Option<Text> = "signed",
        scale: Option<Text> = "scale",
        bias: Option<Text> = "bias",
        units: Option<Text> = "units",
        /// The unit of an integer getter.
        exact: Option<Text> = "exact",
        /// How many of them.
        repeat: Option<Text> = "repeat",
        /// From one to the next.
        stride: Option<Text> = "stride",
        ;
        /// The text, trimmed.
        description: Option<Text>,
    }
}

element! {
    /// `<reserved>`.
    Reserved {
        /// The first bit.
        at: Text = "at",
        width: Text = "width",
    }
}

element! {
    /// `<switch>`: layouts to choose from.
    Switch {
        field: Option<Text> = "field",
        /// The name of a `<bits>`.
        bits: Option<Text> = "bits",
        ;
        /// `<case>` and `<default>`, in document order.
        cases: Vec<Case>,
    }
}

/// `<case>`, or `<default>`.
#[derive(Debug)]
pub struct Case {
    /// `value` of a `<case>`; `None` for `<default>`.
    pub value: Option<Text>,
    /// `<bits>` and `<reserved>`, in document order.
    pub pieces: Vec<Piece>,
    /// The start tag.
    pub span: Span,
}
