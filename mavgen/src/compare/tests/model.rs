//! A dialect that can be made at random and edited.

use std::fmt::Write;

use proptest::prelude::*;

pub(super) const TYPES: [&str; 6] = ["uint8_t", "int16_t", "uint32_t", "float", "uint8_t[3]", "uint64_t"];

/// A dialect that can be edited.
#[derive(Clone, Debug)]
pub(super) struct Model {
    pub(super) messages: Vec<Message>,
    pub(super) enums: Vec<Enum>,
}

#[derive(Clone, Debug)]
pub(super) struct Message {
    pub(super) id: u32,
    pub(super) name: String,
    pub(super) fields: Vec<Field>,
    pub(super) extensions: Vec<Field>,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Field {
    pub(super) ty: usize,
    pub(super) name: String,
}

#[derive(Clone, Debug)]
pub(super) struct Enum {
    pub(super) name: String,
    pub(super) entries: Vec<(String, u64)>,
}

impl Model {
    pub(super) fn xml(&self) -> String {
        let mut xml = "<mavlink><enums>".to_owned();
        for Enum { name, entries } in &self.enums {
            write!(xml, "<enum name='{name}'>").unwrap();
            entries.iter().for_each(|(name, value)| write!(xml, "<entry name='{name}' value='{value}'/>").unwrap());
            xml += "</enum>";
        }
        xml += "</enums><messages>";
        for Message { id, name, fields, extensions } in &self.messages {
            write!(xml, "<message id='{id}' name='{name}'><description>.</description>").unwrap();
            let field = |xml: &mut String, Field { ty, name }: &Field| {
                write!(xml, "<field type='{}' name='{name}'/>", TYPES[*ty]).unwrap();
            };
            fields.iter().for_each(|one| field(&mut xml, one));
            if !extensions.is_empty() {
                xml += "<extensions/>";
            }
            extensions.iter().for_each(|one| field(&mut xml, one));
            xml += "</message>";
        }
        xml + "</messages></mavlink>"
    }
}

fn fields(prefix: &'static str, count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<Field>> {
    let field = move |(at, ty): (usize, usize)| Field { ty, name: format!("{prefix}{at}") };
    prop::collection::vec(0..TYPES.len(), count)
        .prop_map(move |types| types.into_iter().enumerate().map(field).collect())
}

pub(super) fn model() -> impl Strategy<Value = Model> {
    let message = (fields("f", 2..7), fields("x", 0..4));
    let messages = prop::collection::vec(message, 1..4).prop_map(|messages| {
        let message =
            |(at, (fields, extensions))| Message { id: at as u32, name: format!("M{at}"), fields, extensions };
        messages.into_iter().enumerate().map(message).collect()
    });
    let enums = prop::collection::vec(prop::collection::btree_set(0..100_u64, 2..6), 1..3).prop_map(|enums| {
        let entry = |of: usize, value: u64| (format!("E{of}_V{value}"), value);
        let values = |(at, values): (usize, std::collections::BTreeSet<u64>)| Enum {
            name: format!("E{at}"),
            entries: values.into_iter().map(|value| entry(at, value)).collect(),
        };
        enums.into_iter().enumerate().map(values).collect()
    });
    (messages, enums).prop_map(|(messages, enums)| Model { messages, enums })
}
