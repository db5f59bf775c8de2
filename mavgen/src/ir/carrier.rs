//! The messages that carry commands: `COMMAND_LONG` and `COMMAND_INT`.

use super::{FieldType, Message, Scalar};

/// A message that carries commands, as `common.xml` defines it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Carrier {
    /// `COMMAND_LONG`: seven floats.
    Long,
    /// `COMMAND_INT`: params 5 and 6 are integers, and there is a frame.
    Int,
}

/// Fields that stand side by side on the wire: their type, and their names.
type Fields = (Scalar, &'static str);

const LONG: [Fields; 3] = [
    (Scalar::F32, "param1 param2 param3 param4 param5 param6 param7"),
    (Scalar::U16, "command"),
    (Scalar::U8, "target_system target_component confirmation"),
];

const INT: [Fields; 5] = [
    (Scalar::F32, "param1 param2 param3 param4"),
    (Scalar::I32, "x y"),
    (Scalar::F32, "z"),
    (Scalar::U16, "command"),
    (Scalar::U8, "target_system target_component frame current autocontinue"),
];

impl Carrier {
    /// The field of `COMMAND_INT` that says what coordinates are.
    pub(crate) const FRAME: &'static str = "frame";

    /// What a message is; `None` if it carries no commands, or is something else under the same name.
    pub(crate) fn of(message: &Message) -> Option<Self> {
        let (carrier, id, fields): (_, _, &[Fields]) = match message.name.text.as_str() {
            "COMMAND_LONG" => (Self::Long, 76, &LONG),
            "COMMAND_INT" => (Self::Int, 75, &INT),
            _ => return None,
        };
        let of_type =
            |&(scalar, names): &Fields| names.split(' ').map(move |name| (name, FieldType { scalar, array: None }));
        // Extensions may follow: they stay zero.
        let own = message.wire_order().into_iter().filter(|field| !field.extension);
        let same =
            message.id == id && own.map(|field| (&*field.name.text, field.ty)).eq(fields.iter().flat_map(of_type));
        same.then_some(carrier)
    }
}
