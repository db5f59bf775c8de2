//! Where fields lie: in the C struct that PX4 keeps and logs, and in CDR.

use super::model::{Element, Field, Message, MessageIndex};

/// What the layouts of nested messages say of them: bytes as a struct, and how CDR goes on behind them.
pub(super) struct Nested<'m>(pub(super) &'m [Message]);

impl Nested<'_> {
    fn get(&self, index: MessageIndex) -> Option<&Message> {
        self.0.get(index.0)
    }

    /// Bytes and alignment of one element in the struct.
    fn in_struct(&self, element: Element) -> (u32, u32) {
        match element {
            Element::Scalar(scalar) => (scalar.size(), scalar.size()),
            // PX4 aligns what is nested to eight bytes.
            Element::Message(index) => (self.get(index).map_or(0, |message| message.struct_len), 8),
        }
    }
}

/// Puts the fields into the order of the struct and gives each its offset; returns the length, and how much of it is padding at
/// the end. `None` if it is longer than 4 GiB.
pub(super) fn arrange(fields: &mut [Field], nested: &Nested<'_>) -> Option<(u32, u32)> {
    let mut at = 0_u32;
    for (_, i) in struct_order(fields) {
        let field = fields.get_mut(i)?;
        let (size, alignment) = nested.in_struct(field.element);
        at = at.checked_next_multiple_of(alignment)?;
        field.struct_offset = at;
        at = at.checked_add(size.checked_mul(field.elements())?)?;
    }
    let length = at.checked_next_multiple_of(8)?;
    Some((length, length - at))
}

/// The fields as the struct has them: by the size of their scalars, largest first, and nested messages last.
pub(super) fn struct_order(fields: &[Field]) -> Vec<(u32, usize)> {
    let size = |field: &Field| match field.element {
        Element::Scalar(scalar) => scalar.size(),
        Element::Message(_) => 0,
    };
    let mut order: Vec<_> = fields.iter().map(size).zip(0..).collect();
    order.sort_by_key(|(size, _)| std::cmp::Reverse(*size));
    order
}

/// Gives each field of a message its offset in the CDR body; returns the length. `None` if it is longer than 4 GiB.
pub(super) fn arrange_cdr(fields: &mut [Field], nested: &Nested<'_>) -> Option<u32> {
    let mut at = 0_u32;
    for field in fields {
        field.cdr_offset = at.checked_next_multiple_of(cdr_alignment(field.element, nested))?;
        at = cdr_end(std::slice::from_ref(field), nested, at)?;
    }
    Some(at)
}

/// Where an element may begin in CDR: that of its first scalar.
fn cdr_alignment(element: Element, nested: &Nested<'_>) -> u32 {
    match element {
        Element::Scalar(scalar) => scalar.size(),
        Element::Message(index) => {
            let first = nested.get(index).and_then(|message| message.fields.first());
            first.map_or(1, |field| cdr_alignment(field.element, nested))
        }
    }
}

/// The offset behind these fields in a CDR body, when they begin at `at`: each scalar is aligned to its size. `None` if that
/// is behind 4 GiB.
fn cdr_end(fields: &[Field], nested: &Nested<'_>, mut at: u32) -> Option<u32> {
    for field in fields {
        match field.element {
            Element::Scalar(scalar) => {
                at = at
                    .checked_next_multiple_of(scalar.size())?
                    .checked_add(scalar.size().checked_mul(field.elements())?)?;
            }
            Element::Message(index) => {
                for _ in 0..field.elements() {
                    at = cdr_end(&nested.get(index)?.fields, nested, at)?;
                }
            }
        }
    }
    Some(at)
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
            Element::Message(index) => nested
                .get(index.0)
                .map(|message| (super::topic_name(&message.name), message.struct_len))
                .unwrap_or_default(),
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
