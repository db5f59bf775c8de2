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

/// A field of a carrier: name, type, and offset.
type Part = (&'static str, Scalar, u8);

/// What both carriers have.
const BOTH: [Part; 7] = [
    ("param1", Scalar::F32, 0),
    ("param2", Scalar::F32, 4),
    ("param3", Scalar::F32, 8),
    ("param4", Scalar::F32, 12),
    ("command", Scalar::U16, 28),
    ("target_system", Scalar::U8, 30),
    ("target_component", Scalar::U8, 31),
];

const LONG: [Part; 4] = [
    ("param5", Scalar::F32, 16),
    ("param6", Scalar::F32, 20),
    ("param7", Scalar::F32, 24),
    ("confirmation", Scalar::U8, 32),
];

const INT: [Part; 6] = [
    ("x", Scalar::I32, 16),
    ("y", Scalar::I32, 20),
    ("z", Scalar::F32, 24),
    (Carrier::FRAME, Scalar::U8, 32),
    ("current", Scalar::U8, 33),
    ("autocontinue", Scalar::U8, 34),
];

impl Carrier {
    /// The field of `COMMAND_INT` that says what coordinates are.
    pub(crate) const FRAME: &'static str = "frame";

    /// What a message is; `None` if it carries no commands, or is something else under the same name.
    pub(crate) fn of(message: &Message) -> Option<Self> {
        let (carrier, id, parts): (_, _, &[Part]) = match message.name.text.as_str() {
            "COMMAND_LONG" => (Self::Long, 76, &LONG),
            "COMMAND_INT" => (Self::Int, 75, &INT),
            _ => return None,
        };
        // Extensions may follow: they stay zero.
        let parts = BOTH.iter().chain(parts);
        let is_there = |&(name, scalar, offset): &Part| {
            let ty = FieldType { scalar, array: None };
            message.fields.iter().any(|field| (field.name.text.as_str(), field.ty, field.offset) == (name, ty, offset))
        };
        let length = parts.clone().map(|(_, scalar, _)| scalar.size()).sum::<usize>();
        let same = message.id == id && usize::from(message.len_v1) == length && parts.clone().all(is_there);
        same.then_some(carrier)
    }
}
