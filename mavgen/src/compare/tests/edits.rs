//! One edit each, and the change that it has to be.

use proptest::sample::Index;

use super::model::{Enum, Field, Message, Model, TYPES};
use crate::compare::Kind;

/// What an edit is on the wire or in enums, and in Rust; and of each whether it breaks something.
pub(super) type Expected = ((Kind, bool), Option<(Kind, bool)>);

/// Edits a dialect; nothing if there is nothing to edit so.
pub(super) type Edit = fn(&mut Model, &Index) -> Option<Expected>;

pub(super) const EDITS: [Edit; 18] = [
    rename_field,
    retype_field,
    add_field,
    remove_field,
    swap_fields,
    append_extension,
    insert_extension,
    swap_extensions,
    rename_message,
    renumber_message,
    add_message,
    remove_message,
    rename_entry,
    renumber_entry,
    add_entry,
    remove_entry,
    add_enum,
    remove_enum,
];

const RENAMED: Option<(Kind, bool)> = Some((Kind::ItemName, true));
const RETYPED: Option<(Kind, bool)> = Some((Kind::ItemType, true));
const GONE: Option<(Kind, bool)> = Some((Kind::ItemRemoved, true));
const NEW: Option<(Kind, bool)> = Some((Kind::ItemAdded, false));
const NEW_FIELD: Option<(Kind, bool)> = Some((Kind::ItemAdded, true));

fn added() -> Field {
    Field { ty: 0, name: "added".to_owned() }
}

fn message<'m>(model: &'m mut Model, at: &Index) -> (&'m mut Message, usize) {
    let index = at.index(model.messages.len());
    let message = &mut model.messages[index];
    let field = at.index(message.fields.len());
    (message, field)
}

fn values<'m>(model: &'m mut Model, at: &Index) -> (&'m mut Enum, usize) {
    let index = at.index(model.enums.len());
    let values = &mut model.enums[index];
    let entry = at.index(values.entries.len());
    (values, entry)
}

fn rename_field(model: &mut Model, at: &Index) -> Option<Expected> {
    let (message, field) = message(model, at);
    message.fields[field].name = "renamed".to_owned();
    Some(((Kind::FieldName, true), RENAMED))
}

fn retype_field(model: &mut Model, at: &Index) -> Option<Expected> {
    let (message, field) = message(model, at);
    message.fields[field].ty = (message.fields[field].ty + 1) % TYPES.len();
    Some(((Kind::FieldType, true), RETYPED))
}

fn add_field(model: &mut Model, at: &Index) -> Option<Expected> {
    let (message, field) = message(model, at);
    message.fields.insert(field, added());
    Some(((Kind::FieldAdded, true), NEW_FIELD))
}

fn remove_field(model: &mut Model, at: &Index) -> Option<Expected> {
    let (message, field) = message(model, at);
    message.fields.remove(field);
    Some(((Kind::FieldRemoved, true), GONE))
}

/// Two neighbours of one type; of others, the larger would go first whatever the XML says.
fn swap_fields(model: &mut Model, at: &Index) -> Option<Expected> {
    let (message, field) = message(model, at);
    let next = message.fields.get(field + 1)?;
    if next.ty != message.fields[field].ty {
        return None;
    }
    message.fields.swap(field, field + 1);
    Some(((Kind::FieldOrder, true), None))
}

fn append_extension(model: &mut Model, at: &Index) -> Option<Expected> {
    message(model, at).0.extensions.push(added());
    Some(((Kind::FieldAdded, false), NEW_FIELD))
}

fn insert_extension(model: &mut Model, at: &Index) -> Option<Expected> {
    let (message, _) = message(model, at);
    message.extensions.first()?;
    message.extensions.insert(0, added());
    Some(((Kind::FieldAdded, true), NEW_FIELD))
}

fn swap_extensions(model: &mut Model, at: &Index) -> Option<Expected> {
    let (message, _) = message(model, at);
    message.extensions.get(1)?;
    message.extensions.swap(0, 1);
    Some(((Kind::FieldOrder, true), None))
}

fn rename_message(model: &mut Model, at: &Index) -> Option<Expected> {
    message(model, at).0.name = "RENAMED".to_owned();
    Some(((Kind::MessageName, true), RENAMED))
}

fn renumber_message(model: &mut Model, at: &Index) -> Option<Expected> {
    message(model, at).0.id = 255;
    Some(((Kind::MessageId, true), None))
}

fn add_message(model: &mut Model, _: &Index) -> Option<Expected> {
    let new = Message { id: 200, name: "ADDED".to_owned(), fields: vec![added()], extensions: Vec::new() };
    model.messages.push(new);
    Some(((Kind::MessageAdded, false), NEW))
}

fn remove_message(model: &mut Model, at: &Index) -> Option<Expected> {
    model.messages.remove(at.index(model.messages.len()));
    Some(((Kind::MessageRemoved, true), GONE))
}

fn rename_entry(model: &mut Model, at: &Index) -> Option<Expected> {
    let (values, entry) = values(model, at);
    values.entries[entry].0 = format!("{}_RENAMED", values.name);
    Some(((Kind::EntryName, false), RENAMED))
}

fn renumber_entry(model: &mut Model, at: &Index) -> Option<Expected> {
    let (values, entry) = values(model, at);
    values.entries[entry].1 = 200;
    Some(((Kind::EntryValue, true), None))
}

fn add_entry(model: &mut Model, at: &Index) -> Option<Expected> {
    let (values, _) = values(model, at);
    values.entries.push((format!("{}_ADDED", values.name), 200));
    Some(((Kind::EntryAdded, false), NEW))
}

fn remove_entry(model: &mut Model, at: &Index) -> Option<Expected> {
    let (values, entry) = values(model, at);
    values.entries.remove(entry);
    Some(((Kind::EntryRemoved, true), GONE))
}

fn add_enum(model: &mut Model, _: &Index) -> Option<Expected> {
    model.enums.push(Enum { name: "ADDED".to_owned(), entries: vec![("ADDED_A".to_owned(), 201)] });
    Some(((Kind::EnumAdded, false), NEW))
}

fn remove_enum(model: &mut Model, at: &Index) -> Option<Expected> {
    model.enums.remove(at.index(model.enums.len()));
    Some(((Kind::EnumRemoved, true), GONE))
}
