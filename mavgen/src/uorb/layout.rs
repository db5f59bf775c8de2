//! Where fields lie in the C struct that PX4 keeps and logs.

use super::model::{Element, Field, Message};
use super::scalar::Scalar;
use crate::collect::CollectVec as _;
use crate::order;

/// Puts the fields into the order of the struct and gives each its offset; returns the length, and how much of it is padding at
/// the end. `None` if it is longer than 4 GiB.
pub(super) fn arrange(fields: &mut [Field], nested: &[Message]) -> Option<(u32, u32)> {
    let mut at = 0_u32;
    for (_, i) in struct_order(fields) {
        let field = fields.get_mut(i)?;
        let (size, alignment) = match field.element {
            Element::Scalar(scalar) => (scalar.size(), scalar.size()),
            // PX4 aligns what is nested to eight bytes.
            Element::Message(index) => (nested.get(index.0)?.struct_len, 8),
        };
        at = at.checked_next_multiple_of(alignment)?;
        field.struct_offset = at;
        at = at.checked_add(size.checked_mul(field.elements())?)?;
    }
    let length = at.checked_next_multiple_of(8)?;
    Some((length, length - at))
}

/// The fields as the struct has them: by the size of their scalars, largest first, and nested messages last.
pub(super) fn struct_order(fields: &[Field]) -> Vec<(u32, usize)> {
    let size = |field: &Field| field.element.scalar().map_or(0, Scalar::size);
    let mut order = fields.iter().map(size).zip(0..).collect_vec();
    order::sort_by_key(&mut order, |(size, _)| std::cmp::Reverse(*size));
    order
}

/// The fields of the struct as a log defines them: `uint64_t timestamp;uint8_t[2] _padding0;`.
pub(super) fn log_format(message: &Message, nested: &[Message], padding_at_end: bool) -> String {
    let (mut text, mut at, mut paddings) = (String::new(), 0, 0);
    let mut pad = |text: &mut String, from: u32, to: u32| {
        if to > from {
            text.push_str(&format!("uint8_t[{}] _padding{paddings};", to - from));
            paddings += 1;
        }
    };
    for (_, i) in struct_order(&message.fields) {
        let Some(field) = message.fields.get(i) else { continue };
        pad(&mut text, at, field.struct_offset);
        let (element, size) = match field.element {
            Element::Scalar(scalar) => (scalar.log_name().to_owned(), scalar.size()),
            Element::Message(index) => {
                let Some(message) = nested.get(index.0) else { continue };
                (super::topic_name(&message.name), message.struct_len)
            }
        };
        let array = field.array.map(|length| format!("[{length}]")).unwrap_or_default();
        text.push_str(&format!("{element}{array} {};", field.name));
        at = field.struct_offset + size * field.elements();
    }
    if padding_at_end {
        pad(&mut text, at, message.struct_len);
    }
    text
}
