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

use super::element::{Member, element};
use super::{Attribute, Element, Tag, Text};
use crate::source::{FileId, Span};

/// One overlay: the `<uorb-overlay>` element.
#[derive(Debug)]
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

element! {
    /// `<message>`: what is said of a message.
    Message {
        name: Text = "name",
        ;
        /// `<field>`, in document order.
        fields: Vec<Field>,
    }
}

element! {
    /// `<field>`: what is said of a field.
    Field {
        name: Text = "name",
        /// The name of the enum that the field carries.
        enum_: Option<Text> = "enum",
        /// The name of the flags that the field carries.
        flags: Option<Text> = "flags",
        /// Those of the file that are its values.
        constants: Option<Text> = "constants",
        /// Those of the file that are numbers of its bits.
        bits: Option<Text> = "bits",
        /// Of these constants, those that are not meant.
        except: Option<Text> = "except",
        units: Option<Text> = "units",
        /// The value that says "not known".
        invalid: Option<Text> = "invalid",
        /// The name of the field in older definitions.
        was: Option<Text> = "was",
    }
}
