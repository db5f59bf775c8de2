//! Which overlays add to an item: the header of its file names them.

use super::note::origin_of;
use crate::ir::{Dialect, FileIndex, Origin};
use crate::read::Loaded;

/// Notes the overlays of every item that one of them adds to.
pub(in crate::resolve) fn credit(loaded: &Loaded, dialect: &mut Dialect) {
    for (at, overlay) in loaded.overlays.iter().enumerate() {
        let file = FileIndex(loaded.files.len() + at);
        for addition in &overlay.messages {
            let message = dialect.messages.iter_mut().find(|message| message.name.text == addition.name.value);
            note(message.map(|message| &mut message.origin), file);
        }
        for refinement in &overlay.refinements {
            let refined = dialect.enums.iter_mut().find(|one| one.name.text == refinement.values.value);
            note(refined.map(|one| &mut one.origin), file);
        }
        for text in &overlay.notes {
            note(origin_of(text, dialect), file);
        }
    }
}

fn note(origin: Option<&mut Origin>, file: FileIndex) {
    if let Some(origin) = origin.filter(|origin| !origin.overlays.contains(&file)) {
        origin.overlays.push(file);
    }
}
