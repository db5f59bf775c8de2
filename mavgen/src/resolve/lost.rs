//! What is not in the model because it is wrong: its names are worth checking all the same.

use std::collections::HashSet;

use super::names;
use crate::collect::CollectVec as _;
use crate::ir::{Dialect, FileIndex, LostMessage, LostView};
use crate::read::Loaded;
use crate::source::Span;

/// The messages that are not in the model.
pub(super) fn messages(loaded: &Loaded, dialect: &Dialect) -> Vec<LostMessage> {
    let resolved: HashSet<Span> = dialect.messages.iter().map(|message| message.origin.span).collect();
    let mut all = Vec::new();
    for (index, file) in loaded.files.iter().enumerate() {
        for message in file.messages.iter().filter(|message| !resolved.contains(&message.span)) {
            let fields = message.fields.iter().map(|field| names::name(&field.name)).collect_vec();
            all.push(LostMessage { name: names::name(&message.name), file: FileIndex(index), fields });
        }
    }
    all
}

/// The views that are not in the model, and the slots of such.
pub(super) fn views(loaded: &Loaded, dialect: &Dialect) -> Vec<LostView> {
    let mut resolved: HashSet<Span> = HashSet::new();
    for message in &dialect.messages {
        resolved.extend(message.views.iter().map(|view| view.origin.span));
    }
    let mut lost = Vec::new();
    for (file, overlay) in loaded.numbered_overlays() {
        for message in &overlay.messages {
            for view in message.views.iter().filter(|view| !resolved.contains(&view.span)) {
                lost.push(LostView { name: names::name(&view.name), file });
                // Where there are slots, the type of one.
                let item = view.item.as_ref().filter(|_| view.items.is_some());
                lost.extend(item.map(|name| LostView { name: names::name(name), file }));
            }
        }
    }
    lost
}
