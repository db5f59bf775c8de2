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

use super::{Enum, Text};
use crate::source::{FileId, Span};

/// One overlay: the `<mavlink-overlay>` element.
#[derive(Clone, Debug)]
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

/// `<command>`: what the params of a command are.
#[derive(Clone, Debug)]
pub struct Command {
    /// `name`: an entry of `MAV_CMD`.
    pub name: Text,
    /// `hasLocation`.
    pub has_location: Option<Text>,
    /// `isDestination`.
    pub is_destination: Option<Text>,
    /// `<param>`, in document order.
    pub params: Vec<NamedParam>,
}

/// `<param>` of a command in an overlay.
#[derive(Clone, Debug)]
pub struct NamedParam {
    /// `index`.
    pub index: Text,
    /// `label`.
    pub label: Text,
    /// `units`.
    pub units: Option<Text>,
    /// `enum`.
    pub enum_: Option<Text>,
    /// The start tag.
    pub span: Span,
}

/// `<refine>`: what the definitions leave unsaid about an enum.
#[derive(Clone, Debug)]
pub struct Refinement {
    /// `enum`.
    pub enum_: Text,
    /// `bitmask`.
    pub bitmask: Option<Text>,
    /// `deprecated`.
    pub deprecated: Option<Text>,
    /// The start tag.
    pub span: Span,
}

/// `<note>`: a paragraph for the documentation of something.
#[derive(Clone, Debug)]
pub struct Note {
    /// `message`.
    pub message: Option<Text>,
    /// `field`, of the message.
    pub field: Option<Text>,
    /// `enum`.
    pub enum_: Option<Text>,
    /// `entry`, of the enum.
    pub entry: Option<Text>,
    /// The text, trimmed.
    pub text: Option<Text>,
    /// The start tag.
    pub span: Span,
}

/// `<message>` of an overlay: what it adds to a message.
#[derive(Clone, Debug)]
pub struct Additions {
    /// `name`.
    pub name: Text,
    /// `<bind>`, in document order.
    pub bindings: Vec<Bind>,
    /// `<view>`, in document order.
    pub views: Vec<View>,
    /// The start tag.
    pub span: Span,
}

/// `<bind>`: a field that carries an enum.
#[derive(Clone, Debug)]
pub struct Bind {
    /// `name` of the getter.
    pub name: Text,
    /// `field`.
    pub field: Text,
    /// `enum`.
    pub enum_: Text,
    /// `if` and `is`.
    pub condition: Condition,
    /// The text, trimmed.
    pub description: Option<Text>,
}

/// `if="field" is="value"`: both or none.
#[derive(Clone, Debug)]
pub struct Condition {
    /// `if`.
    pub field: Option<Text>,
    /// `is`.
    pub value: Option<Text>,
}

/// `<view>`: a layout of bits over fields, or values in fields.
#[derive(Clone, Debug)]
pub struct View {
    /// `name`.
    pub name: Text,
    /// `words`; a view of values has none.
    pub words: Option<Text>,
    /// `item`.
    pub item: Option<Text>,
    /// `items`.
    pub items: Option<Text>,
    /// `count`.
    pub count: Option<Text>,
    /// `partial`.
    pub partial: Option<Text>,
    /// `if` and `is`.
    pub condition: Condition,
    /// `<key>`, in document order.
    pub keys: Vec<Key>,
    /// `<value>`, in document order.
    pub values: Vec<Key>,
    /// `<invalid>`, in document order.
    pub invalids: Vec<Invalid>,
    /// `<bits>`, `<reserved>` and `<switch>`, in document order.
    pub parts: Vec<Part>,
    /// `<description>`, or else the text, trimmed.
    pub description: Option<Text>,
    /// The start tag.
    pub span: Span,
}

/// `<key>`: a field that a slot carries along; or `<value>`: a field that a view gives a name.
#[derive(Clone, Debug)]
pub struct Key {
    /// `name`.
    pub name: Text,
    /// `field`.
    pub field: Text,
    /// `units`.
    pub units: Option<Text>,
    /// `invalid`.
    pub invalid: Option<Text>,
    /// The text, trimmed.
    pub description: Option<Text>,
    /// The start tag.
    pub span: Span,
}

/// `<invalid>`: a value that says that a view means nothing.
#[derive(Clone, Debug)]
pub struct Invalid {
    /// `field`; without one the words themselves.
    pub field: Option<Text>,
    /// `value`.
    pub value: Text,
    /// The start tag.
    pub span: Span,
}

/// A part of a view.
#[derive(Clone, Debug)]
pub enum Part {
    /// `<bits>`, `<reserved>`.
    Piece(Piece),
    /// `<switch>`.
    Switch(Switch),
}

/// Bits with a name, or without a meaning.
#[derive(Clone, Debug)]
pub enum Piece {
    /// `<bits>`.
    Bits(Box<Bits>),
    /// `<reserved>`.
    Reserved(Reserved),
}

/// `<bits>`.
#[derive(Clone, Debug)]
pub struct Bits {
    /// `name` of the getter.
    pub name: Text,
    /// `at`: the first bit.
    pub at: Text,
    /// `width`.
    pub width: Text,
    /// `enum`.
    pub enum_: Option<Text>,
    /// `signed`.
    pub signed: Option<Text>,
    /// `scale`.
    pub scale: Option<Text>,
    /// `bias`.
    pub bias: Option<Text>,
    /// `units`.
    pub units: Option<Text>,
    /// `exact`: the unit of an integer getter.
    pub exact: Option<Text>,
    /// `repeat`: how many of them.
    pub repeat: Option<Text>,
    /// `stride`: from one to the next.
    pub stride: Option<Text>,
    /// The text, trimmed.
    pub description: Option<Text>,
    /// The start tag.
    pub span: Span,
}

/// `<reserved>`.
#[derive(Clone, Debug)]
pub struct Reserved {
    /// `at`: the first bit.
    pub at: Text,
    /// `width`.
    pub width: Text,
    /// The start tag.
    pub span: Span,
}

/// `<switch>`: layouts to choose from.
#[derive(Clone, Debug)]
pub struct Switch {
    /// `field`.
    pub field: Option<Text>,
    /// `bits`: the name of a `<bits>`.
    pub bits: Option<Text>,
    /// `<case>` and `<default>`, in document order.
    pub cases: Vec<Case>,
    /// The start tag.
    pub span: Span,
}

/// `<case>`, or `<default>`.
#[derive(Clone, Debug)]
pub struct Case {
    /// `value` of a `<case>`; `None` for `<default>`.
    pub value: Option<Text>,
    /// `<bits>` and `<reserved>`, in document order.
    pub pieces: Vec<Piece>,
    /// The start tag.
    pub span: Span,
}
