//! Messages: what became of their ids, layouts and checksums.

use super::order::moved;
use super::pairs::{MessagePair, Named as _, Pairs, differs, renamed, type_of};
use super::{Change, Frame, Kind};
use crate::ir::{Field, Message};

/// The changes of all messages.
pub(super) fn changes(Pairs { messages, .. }: &Pairs<'_>) -> Vec<Change> {
    let id = |message: &Message| Some(format!("id {}", message.id));
    let removed = messages.removed(Kind::MessageRemoved, "", id);
    removed.chain(messages.both.iter().flat_map(message)).chain(messages.added(Kind::MessageAdded, "", id)).collect()
}

/// The changes of one message. Each that changes its frames says how they changed.
fn message(pair: &MessagePair<'_>) -> Vec<Change> {
    let (item, both) = (&pair.old.name.text, (pair.old, pair.new));
    let name = renamed((Kind::MessageName, checksum_differs(pair)), item, both);
    let changes = match name {
        // The id has another message now. That its fields are others says nothing more.
        Some(name) if !pair.has_one_layout() => vec![Change { kind: Kind::MessageReplaced, breaking: true, ..name }],
        name => {
            let id = differs((Kind::MessageId, true), item, both, |message| message.id);
            name.into_iter().chain(id).chain(fields(pair)).collect()
        }
    };
    let frame = frame(pair);
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
    let MessagePair { old, new, fields } = pair;
    let [before, after] = [old, new].map(|message| format!("{}.", message.name.text));
    let mut changes: Vec<Change> = fields.removed(Kind::FieldRemoved, &before, described).collect();
    for both in &fields.both {
        let item = format!("{before}{}", both.0.name.text);
        let is_breaking = checksum_differs(pair);
        changes.extend(differs((Kind::FieldName, is_breaking), &item, *both, |field| field.name.text.clone()));
        changes.extend(differs((Kind::FieldType, true), &item, *both, type_of));
        let extension = |field: &Field| if field.extension { "an extension" } else { "a plain field" };
        changes.extend(differs((Kind::FieldExtension, true), &item, *both, extension));
    }
    changes.extend(reordered(pair));
    let added = fields.added(Kind::FieldAdded, &after, described).zip(&fields.added);
    changes.extend(added.map(|(change, field)| Change { breaking: !is_appended(pair, field), ..change }));
    changes
}

/// `uint8_t, an extension`
fn described(field: &Field) -> Option<String> {
    Some(if field.extension { format!("{}, an extension", type_of(field)) } else { type_of(field) })
}

/// Fields that have other neighbours. What a new, removed or changed field does to the places of others is no news.
fn reordered(pair: &MessagePair<'_>) -> impl Iterator<Item = Change> {
    let unchanged = |(old, new): &(&Field, &Field)| type_of(old) == type_of(new) && old.extension == new.extension;
    let mut fields: Vec<_> = pair.fields.both.iter().copied().filter(unchanged).collect();
    fields.sort_by_key(|(old, _)| old.offset);
    moved(fields, |(_, new)| new.offset).map(|(old, new)| {
        let change = Change::new(Kind::FieldOrder, true, format!("{}.{}", pair.old.name.text, old.name.text));
        change.with(Some(old.offset), Some(new.offset)).at(Some(old.span()), Some(new.span()))
    })
}

/// Whether a new field follows all others on the wire, where receivers that do not know it do not look.
fn is_appended(pair: &MessagePair<'_>, field: &Field) -> bool {
    field.extension && pair.fields.both.iter().all(|(_, other)| other.offset < field.offset)
}
