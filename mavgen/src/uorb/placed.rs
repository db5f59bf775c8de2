//! Where fields lie in the bytes of a definition: in a CDR body, and in a record of a log.

use super::layout::struct_order;
use super::model::{Element, Field, Message, MessageIndex, Package};
use super::scalar::Scalar;
use crate::collect::CollectVec as _;

/// A field in the bytes of its message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Placed {
    /// Which field of the message it is.
    pub(crate) field: usize,
    /// Where it begins, from the beginning of the message.
    pub(crate) at: u32,
    /// What is there.
    pub(crate) held: Held,
}

/// What is in a field's bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Held {
    /// A scalar, or an array of this length.
    Scalars(Scalar, Option<u16>),
    /// Nested messages.
    Messages(MessageIndex, Vec<Run>),
}

/// Elements of an array of messages that have one layout; a message that is no array is one of one.
///
/// In CDR the first may differ from the others: how a message is laid out hangs on where it begins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Run {
    /// The first of them.
    pub(crate) first: u16,
    /// How many there are.
    pub(crate) count: u16,
    /// Where the first one begins, from the beginning of the message that nests them.
    pub(crate) at: u32,
    /// From one to the next.
    pub(crate) stride: u32,
    /// Bytes of one.
    pub(crate) len: u32,
    /// Its fields.
    pub(crate) fields: Vec<Placed>,
}

/// Where the fields of a message lie in a CDR body, in the order of the file.
pub(crate) fn in_cdr(package: &Package, message: &Message) -> Vec<Placed> {
    cdr(&package.messages, &message.fields, 0).0
}

/// The fields of a message that begins at `base`, and where it ends: both from there. They are not so many that lengths do not fit:
/// [as a struct](super::layout::arrange) the message has at most 64 KiB.
pub(super) fn cdr(messages: &[Message], fields: &[Field], base: u32) -> (Vec<Placed>, u32) {
    let (mut placed, mut at) = (Vec::new(), 0_u32);
    for (i, field) in fields.iter().enumerate() {
        match field.element {
            Element::Scalar(scalar) => {
                at = (base + at).next_multiple_of(scalar.size()) - base;
                placed.push(Placed { field: i, at, held: Held::Scalars(scalar, field.array) });
                at += scalar.size() * field.elements();
            }
            Element::Message(index) => {
                let Some(nested) = messages.get(index.0) else { continue };
                let mut runs: Vec<Run> = Vec::new();
                for i in 0..field.array.unwrap_or(1) {
                    let begins = (base + at).next_multiple_of(alignment(messages, nested)) - base;
                    at = add(&mut runs, (messages, &nested.fields), i, (base, begins));
                }
                let at = runs.first().map_or(at, |run| run.at);
                placed.push(Placed { field: i, at, held: Held::Messages(index, runs) });
            }
        }
    }
    (placed, at)
}

/// What the first scalar of a message is aligned to: the message begins where that does.
fn alignment(messages: &[Message], message: &Message) -> u32 {
    match message.fields.first().map(|field| field.element) {
        Some(Element::Scalar(scalar)) => scalar.size(),
        Some(element) => element.message(messages).map_or(1, |nested| alignment(messages, nested)),
        None => 1,
    }
}

/// Adds an element that begins at `base + at` to the last run if it is laid out as that, else as a new one; gives its end.
fn add(runs: &mut Vec<Run>, (messages, fields): (&[Message], &[Field]), i: u16, (base, at): (u32, u32)) -> u32 {
    if let Some(run) = runs.last_mut() {
        let before = run.at + run.stride * u32::from(run.count - 1);
        let same = (base + before) % 8 == (base + at) % 8;
        if same && (run.count == 1 || at - before == run.stride) {
            run.stride = at - before;
            run.count += 1;
            return at + run.len;
        }
    }
    let (fields, len) = cdr(messages, fields, base + at);
    runs.push(Run { first: i, count: 1, at, stride: len, len, fields });
    at + len
}

/// Where the fields of a message lie in a record of a log, by offset.
pub(crate) fn in_record(package: &Package, message: &Message) -> Vec<Placed> {
    let order = struct_order(&message.fields).into_iter();
    let fields = order.filter_map(|(_, i)| Some((i, message.fields.get(i)?)));
    let placed = fields.map(|(i, field)| {
        let at = field.struct_offset;
        let held = match field.element {
            Element::Scalar(scalar) => Held::Scalars(scalar, field.array),
            Element::Message(index) => {
                let nested = package.messages.get(index.0);
                let run = nested.map(|nested| Run {
                    first: 0,
                    count: field.array.unwrap_or(1),
                    at,
                    stride: nested.struct_len,
                    len: nested.struct_len,
                    fields: in_record(package, nested),
                });
                Held::Messages(index, run.into_iter().collect_vec())
            }
        };
        Placed { field: i, at, held }
    });
    placed.collect_vec()
}
