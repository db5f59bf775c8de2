//! All that a payload says, as one tree: what every format writes, and nobody has to interpret again.

use mavlink_wire::EnumInfo;
use mavlink_wire::reflect::{Element, Field, Number, Reflected, Value as FieldValue};

use super::node::{Entry, Node, number};
use super::parameter::parameter;
use super::{Bits, Content, KeyValue, Reading, Slot, Tables, Value, bindings, views};
use crate::ir::{Access, Dialect, EnumId, Meaning, Member, Message};

/// Everything that a message says.
#[derive(Clone, Debug, PartialEq)]
pub struct Contents {
    /// The fields in the order of the XML.
    pub fields: Vec<Entry>,
    /// What overlays see in the fields, each by the name that generated code has for it.
    ///
    /// A bound enum stands here where its condition holds. A view is the record of the members that its layout has, and
    /// [`Node::Unknown`] where its bits mean nothing; where its condition does not hold, it is not here. A view of slots is
    /// a list of records: the keys, and the view as `status`. A view of values is the record of them.
    ///
    /// After them comes the `parameter` of a message with one whose type is not that of the field: what it can be, `bytewise`
    /// and as a number that was `cast` to a float ([`parameter_readings`](super::parameter_readings)).
    pub views: Vec<Entry>,
}

/// Everything that a message of the dialect says.
#[must_use]
pub fn contents(dialect: &Dialect, tables: &Tables, reflected: &Reflected<'_>) -> Contents {
    let id = reflected.info().id;
    let message = dialect.messages.binary_search_by_key(&id, |message| message.id).ok();
    let message = message.and_then(|at| dialect.messages.get(at));
    Contents {
        fields: reflected.fields().map(field).collect(),
        views: message.map_or_else(Vec::new, |message| overlaid(message, tables, reflected.payload())),
    }
}

fn field(field: Field<'_>) -> Entry {
    let node = match field.value() {
        _ if field.info().secret => Node::Secret,
        _ if field.is_invalid() => Node::Unknown,
        FieldValue::Text(_) if field.info().array.is_none() => {
            bytes(field).first().copied().map_or(Node::Unknown, Node::Char)
        }
        FieldValue::Text(_) => Node::Text(bytes(field)),
        FieldValue::One(one) => element(one),
        FieldValue::Array(elements) => Node::List(elements.map(element).collect()),
    };
    let info = field.info();
    let units = if info.values.is_some() { None } else { info.units };
    Entry { name: info.name.to_owned(), units: units.map(str::to_owned), node }
}

/// The bytes of a text, those behind a NUL as well.
fn bytes(field: Field<'_>) -> Vec<u8> {
    let numbers = field.elements().map(|element| element.number());
    numbers.map(|number| if let Number::U64(byte) = number { byte as u8 } else { 0 }).collect()
}

fn element(element: Element<'_>) -> Node {
    match element.entry() {
        _ if element.is_invalid() => Node::Unknown,
        Some((values, value)) => entry(values, value).unwrap_or_else(|| number(element.number())),
        None => number(element.number()),
    }
}

/// A value of an enum by name; `None` if it has none.
fn entry(values: &'static EnumInfo, value: u64) -> Option<Node> {
    match value {
        0 if values.bitmask => Some(Node::Flags(String::new())),
        _ if values.bitmask => Some(Node::Flags(values.display(value).to_string())),
        _ => values.entry_name(value).map(|name| Node::Name(name.to_owned())),
    }
}

/// What overlays see in the fields.
fn overlaid(message: &Message, tables: &Tables, payload: &[u8]) -> Vec<Entry> {
    let bound = bindings(message, payload)
        .filter_map(|(binding, value)| Some(Entry::of(binding.name.shown(), named(tables, binding.enum_, value?))));
    let views = views(message, payload).filter_map(|reading| view(tables, &reading));
    bound.chain(views).chain(parameter(message, payload)).collect()
}

fn view(tables: &Tables, reading: &Reading<'_>) -> Option<Entry> {
    let (name, node) = match (&reading.view.access, &reading.content) {
        (Access::Once { getter }, Content::Once(Some(bits))) => (getter, Node::Record(members(tables, bits))),
        (Access::Once { getter }, Content::Once(None)) if reading.view.condition.is_none() => (getter, Node::Unknown),
        (Access::Slots(parts), Content::Slots(slots)) => {
            (&parts.items, Node::List(slots.iter().map(|one| slot(tables, one)).collect()))
        }
        (Access::Record(parts), Content::Record(Some(values))) => {
            (&parts.getter, Node::Record(values.iter().map(|one| key(tables, one)).collect()))
        }
        _ => return None,
    };
    Some(Entry::of(name.shown(), node))
}

fn slot(tables: &Tables, slot: &Slot<'_>) -> Node {
    let mut entries: Vec<Entry> = slot.keys.iter().map(|one| key(tables, one)).collect();
    let status = slot.status.as_ref().map_or(Node::Unknown, |bits| Node::Record(members(tables, bits)));
    entries.push(Entry::of("status", status));
    Node::Record(entries)
}

fn key(tables: &Tables, one: &KeyValue<'_>) -> Entry {
    let value = one.values.zip(one.number.as_integer().and_then(|value| u64::try_from(value).ok()));
    let node = match value {
        _ if one.is_invalid() => Node::Unknown,
        Some((values, value)) => named(tables, values, value),
        None => number(one.number),
    };
    Entry { name: one.key.name.shown(), units: one.key.units.clone(), node }
}

/// The members that the bits' layout has.
fn members(tables: &Tables, bits: &Bits<'_>) -> Vec<Entry> {
    let present = bits.view().members.iter().filter(|member| bits.has(member));
    present
        .map(|one| Entry { name: one.name.shown(), units: member_units(one), node: member(tables, bits, one) })
        .collect()
}

fn member(tables: &Tables, bits: &Bits<'_>, member: &Member) -> Node {
    let count = member.repeat.map_or(1, |repeat| repeat.count);
    let mut nodes = (0..count).filter_map(|index| bits.value(member, index)).map(|value| match value {
        Value::Flag(flag) => Node::Flag(flag),
        Value::Entry(id, value) => named(tables, id, value),
        Value::Unsigned(value) => Node::Unsigned(value),
        Value::Signed(value) => Node::Signed(value),
        Value::Scaled(ratio) => Node::Scaled(ratio),
    });
    if member.repeat.is_some() { Node::List(nodes.collect()) } else { nodes.next().unwrap_or(Node::Unknown) }
}

/// The unit of a member's values.
pub(super) fn member_units(member: &Member) -> Option<String> {
    match &member.meaning {
        Meaning::Number { units } => units.clone(),
        Meaning::Scaled(scaled) => scaled.units.clone(),
        Meaning::Flag | Meaning::Values(_) => None,
    }
}

/// An entry by name, flags by their names, or the number.
fn named(tables: &Tables, id: EnumId, value: u64) -> Node {
    let Some((values, number)) = tables.values(id).zip(tables.number(id, value)) else {
        return Node::Unsigned(value.into());
    };
    let listed = number.as_integer().and_then(|value| u64::try_from(value).ok());
    listed.and_then(|value| entry(values, value)).unwrap_or_else(|| self::number(number))
}
