//! Messages: what became of their ids, layouts and checksums.

use super::order::moved;
use super::pairs::{MessagePair, Pairs, type_of};
use super::{Change, Frame, Kind};
use crate::ir::{Field, Message};

/// The changes of all messages.
pub(super) fn changes(pairs: &Pairs<'_>) -> Vec<Change> {
    let messages = &pairs.messages;
    let removed = messages.removed.iter().map(|message| {
        Change::new(Kind::MessageRemoved, true, name(message)).from(id(message)).at(Some(message.origin.span), None)
    });
    let added = messages.added.iter().map(|message| {
        Change::new(Kind::MessageAdded, false, name(message)).to(id(message)).at(None, Some(message.origin.span))
    });
    removed.chain(messages.both.iter().flat_map(message)).chain(added).collect()
}

fn name(message: &Message) -> &str {
    &message.name.text
}

fn id(message: &Message) -> String {
    format!("id {}", message.id)
}

/// `HEARTBEAT.type`
fn path(message: &Message, field: &Field) -> String {
    format!("{}.{}", message.name.text, field.name.text)
}

/// The changes of one message. Each that changes its frames says how they changed.
fn message(pair: &MessagePair<'_>) -> Vec<Change> {
    let MessagePair { old, new, .. } = pair;
    let (frame, mut changes) = (frame(pair), Vec::new());
    let both = |change: Change| change.at(Some(old.origin.span), Some(new.origin.span));
    if old.name.text != new.name.text && !pair.has_one_layout() {
        // The id has another message now. That its fields are others says nothing more.
        let change = Change::new(Kind::MessageReplaced, true, name(old)).to(name(new));
        return vec![Change { frame, ..both(change) }];
    }
    if old.name.text != new.name.text {
        changes.push(both(Change::new(Kind::MessageName, checksum_differs(pair), name(old)).to(name(new))));
    }
    if old.id != new.id {
        let change = Change::new(Kind::MessageId, true, name(old)).from(old.id.to_string()).to(new.id.to_string());
        changes.push(both(change));
    }
    changes.extend(fields(pair));
    changes.into_iter().map(|change| Change { frame, ..change }).collect()
}

fn checksum_differs(pair: &MessagePair<'_>) -> bool {
    pair.old.crc_extra != pair.new.crc_extra
}

fn frame(MessagePair { old, new, .. }: &MessagePair<'_>) -> Option<Frame> {
    let frame = Frame {
        crc_extra: (old.crc_extra, new.crc_extra),
        len_v1: (old.len_v1, new.len_v1),
        len_v2: (old.len_v2, new.len_v2),
    };
    let same = [frame.crc_extra, frame.len_v1, frame.len_v2].iter().all(|(old, new)| old == new);
    (!same).then_some(frame)
}

fn fields(pair: &MessagePair<'_>) -> Vec<Change> {
    let mut changes = Vec::new();
    for field in &pair.fields.removed {
        let change = Change::new(Kind::FieldRemoved, true, path(pair.old, field)).from(described(field));
        changes.push(change.at(Some(field.origin.span), None));
    }
    for (old, new) in &pair.fields.both {
        changes.extend(field(pair, old, new));
    }
    changes.extend(reordered(pair));
    for field in &pair.fields.added {
        let breaking = !is_appended(pair, field);
        let change = Change::new(Kind::FieldAdded, breaking, path(pair.new, field)).to(described(field));
        changes.push(change.at(None, Some(field.origin.span)));
    }
    changes
}

/// `uint8_t, an extension`
fn described(field: &Field) -> String {
    if field.extension { format!("{}, an extension", type_of(field)) } else { type_of(field) }
}

fn kind_of(field: &Field) -> &'static str {
    if field.extension { "an extension" } else { "a plain field" }
}

/// The changes of a field that is in both states, but for its place.
fn field(pair: &MessagePair<'_>, old: &Field, new: &Field) -> Vec<Change> {
    let change = |kind, breaking, from: String, to: String| {
        let change = Change::new(kind, breaking, path(pair.old, old)).from(from).to(to);
        change.at(Some(old.origin.span), Some(new.origin.span))
    };
    let mut changes = Vec::new();
    if old.name.text != new.name.text {
        let breaking = checksum_differs(pair);
        changes.push(change(Kind::FieldName, breaking, old.name.text.clone(), new.name.text.clone()));
    }
    if type_of(old) != type_of(new) {
        changes.push(change(Kind::FieldType, true, type_of(old), type_of(new)));
    }
    if old.extension != new.extension {
        changes.push(change(Kind::FieldExtension, true, kind_of(old).to_owned(), kind_of(new).to_owned()));
    }
    changes
}

/// Fields that have other neighbours. What a new, removed or changed field does to the places of others is no news.
fn reordered(pair: &MessagePair<'_>) -> Vec<Change> {
    let unchanged = |(old, new): &&(&Field, &Field)| type_of(old) == type_of(new) && old.extension == new.extension;
    let mut fields: Vec<_> = pair.fields.both.iter().filter(unchanged).collect();
    fields.sort_by_key(|(old, _)| old.offset);
    let positions: Vec<usize> = fields.iter().map(|(_, new)| usize::from(new.offset)).collect();
    let moved = moved(&positions).into_iter().filter_map(|at| fields.get(at));
    let change = moved.map(|(old, new)| {
        let change = Change::new(Kind::FieldOrder, true, path(pair.old, old));
        let change = change.from(old.offset.to_string()).to(new.offset.to_string());
        change.at(Some(old.origin.span), Some(new.origin.span))
    });
    change.collect()
}

/// Whether a new field follows all others on the wire, where receivers that do not know it do not look.
fn is_appended(pair: &MessagePair<'_>, field: &Field) -> bool {
    field.extension && pair.fields.both.iter().all(|(_, other)| other.offset < field.offset)
}
