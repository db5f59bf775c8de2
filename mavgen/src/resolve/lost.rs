//! What is not in the model because it is wrong: its names are worth checking all the same.

use std::collections::HashSet;

use super::spelling;
use crate::ir::{Dialect, FileIndex, LostMessage, LostView};
use crate::read::Loaded;
use crate::source::Span;
use crate::syntax::Text;
use crate::syntax::overlay::View;

/// The messages that are not in the model.
pub(super) fn messages(loaded: &Loaded, dialect: &Dialect) -> Vec<LostMessage> {
    let resolved: HashSet<Span> = dialect.messages.iter().map(|message| message.origin.span).collect();
    let files = loaded.files.iter().enumerate();
    let all = files.flat_map(|(index, file)| file.messages.iter().map(move |message| (FileIndex(index), message)));
    let lost = all.filter(|(_, message)| !resolved.contains(&message.span));
    lost.map(|(file, message)| LostMessage {
        name: spelling::name(&message.name),
        file,
        fields: message.fields.iter().map(|field| spelling::name(&field.name)).collect(),
    })
    .collect()
}

/// The views that are not in the model, and the slots of such.
pub(super) fn views(loaded: &Loaded, dialect: &Dialect) -> Vec<LostView> {
    let views = dialect.messages.iter().flat_map(|message| &message.views);
    let resolved: HashSet<Span> = views.map(|view| view.origin.span).collect();
    let mut lost = Vec::new();
    for (index, overlay) in loaded.overlays.iter().enumerate() {
        let file = FileIndex(loaded.files.len() + index);
        let views = overlay.messages.iter().flat_map(|message| &message.views);
        let names = views.filter(|view| !resolved.contains(&view.span)).flat_map(types);
        lost.extend(names.map(|name| LostView { name: spelling::name(name), file }));
    }
    lost
}

/// The names that a view gives to types: its own and, where there are slots, that of a slot.
fn types(view: &View) -> impl Iterator<Item = &Text> {
    let item = view.item.as_ref().filter(|_| view.items.is_some());
    std::iter::once(&view.name).chain(item)
}
