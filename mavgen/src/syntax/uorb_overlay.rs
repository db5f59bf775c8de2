//! What an overlay of uORB messages says: `<uorb-overlay>` and the elements in it.
//!
//! ```xml
//! <uorb-overlay version="1" for="px4_msgs/msg">
//!   <message name="EscReport">
//!     <field name="failures" flags="EscFailures" bits="FAILURE_*" except="FAILURE_COUNT"/>
//!     <field name="esc_temperature" units="degC" invalid="NaN" was="temperature"/>
//!   </message>
//!   <message name="EscStatus">
//!     <field name="esc_connectiontype" enum="EscConnectionType" constants="ESC_CONNECTION_TYPE_*"/>
//!   </message>
//! </uorb-overlay>
//! ```

use super::Text;
use crate::source::{FileId, Span};

/// One overlay: the `<uorb-overlay>` element.
#[derive(Clone, Debug)]
pub struct Overlay {
    /// The source.
    pub id: FileId,
    /// `version` of the grammar.
    pub version: Option<Text>,
    /// `for`: the folder of `.msg` files that it belongs to, or the last folders of its path.
    pub base: Option<Text>,
    /// `<message>`, in document order.
    pub messages: Vec<Message>,
}

/// `<message>`: what is said of a message.
#[derive(Clone, Debug)]
pub struct Message {
    /// `name`.
    pub name: Text,
    /// `<field>`, in document order.
    pub fields: Vec<Field>,
    /// The start tag.
    pub span: Span,
}

/// `<field>`: what is said of a field.
#[derive(Clone, Debug)]
pub struct Field {
    /// `name`.
    pub name: Text,
    /// `enum`: the name of the enum that the field carries.
    pub enum_: Option<Text>,
    /// `flags`: the name of the flags that the field carries.
    pub flags: Option<Text>,
    /// `constants`: those of the file that are its values.
    pub constants: Option<Text>,
    /// `bits`: those of the file that are numbers of its bits.
    pub bits: Option<Text>,
    /// `except`: of these, those that are not.
    pub except: Option<Text>,
    /// `units`.
    pub units: Option<Text>,
    /// `invalid`: the value that says "not known".
    pub invalid: Option<Text>,
    /// `was`: the name of the field in older definitions.
    pub was: Option<Text>,
    /// The start tag.
    pub span: Span,
}
