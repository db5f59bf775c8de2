//! What was lost: in reading, and who would otherwise miss it a second time; and what is not in the model because it is wrong,
//! whose names are worth checking all the same.

use std::collections::HashSet;

use super::names;
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::ir::{Dialect, FileIndex, LostMessage, LostView};
use crate::read::Loaded;
use crate::source::{FileId, Span};

/// The files of which something could not be read.
pub(super) struct Poisoned {
    files: Vec<Option<FileId>>,
}

impl Poisoned {
    /// The poisoned behind the errors so far.
    pub(super) fn behind(diagnostics: &Diagnostics) -> Self {
        Self { files: diagnostics.broken_files().to_vec() }
    }

    /// A file whose definitions are not taken in.
    pub(super) fn add(&mut self, file: FileId) {
        self.files.push(Some(file));
    }

    /// Whether anything was lost: a name without a definition may then be no mistake.
    pub(super) fn any(&self) -> bool {
        !self.files.is_empty()
    }

    /// Whether anything was lost of the file of `place`: what looks empty there may not be.
    pub(super) fn near(&self, place: Span) -> bool {
        self.files.contains(&Some(place.file))
    }
}

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
        let views = overlay.messages.iter().flat_map(|message| &message.views);
        for view in views.filter(|view| !resolved.contains(&view.span)) {
            // Where there are slots, also the type of one.
            let item = view.item.as_ref().filter(|_| view.items.is_some());
            let types = std::iter::once(&view.name).chain(item);
            lost.extend(types.map(|name| LostView { name: names::name(name), file }));
        }
    }
    lost
}
