//! The files of all dialects, each once.

use std::collections::HashMap;

use crate::ir::{Dialect, File, FileIndex};
use crate::source::FileId;

/// The files so far.
#[derive(Default)]
pub(super) struct Files {
    pub(super) list: Vec<File>,
    known: HashMap<FileId, FileIndex>,
}

impl Files {
    /// Takes in the files of a dialect, and points everything in it to their new places. Returns that of its top file.
    pub(super) fn take(&mut self, dialect: &mut Dialect, sources: &[FileId]) -> FileIndex {
        let before = self.list.len();
        let mut places = Vec::with_capacity(sources.len());
        for (file, source) in std::mem::take(&mut dialect.files).into_iter().zip(sources) {
            let next = FileIndex(self.list.len());
            let place = *self.known.entry(*source).or_insert(next);
            if place == next {
                self.list.push(file);
            }
            places.push(place);
        }
        let moved = |file: &mut FileIndex| *file = places.get(file.0).copied().unwrap_or(FileIndex(usize::MAX));
        self.list.iter_mut().skip(before).flat_map(|file| &mut file.includes).for_each(moved);
        each(dialect, moved);
        places.first().copied().unwrap_or(FileIndex(usize::MAX))
    }
}

/// Changes every mention of a file.
fn each(dialect: &mut Dialect, change: impl Fn(&mut FileIndex)) {
    for values in &mut dialect.enums {
        change(&mut values.defined_in);
        values.origin.map_files(&change);
        for entry in &mut values.entries {
            entry.origin.map_files(&change);
            let params = entry.command.iter_mut().flat_map(|command| &mut command.params);
            params.for_each(|param| param.origin.map_files(&change));
        }
    }
    for message in &mut dialect.messages {
        message.origin.map_files(&change);
        message.fields.iter_mut().for_each(|field| field.origin.map_files(&change));
        message.views.iter_mut().for_each(|view| view.origin.map_files(&change));
    }
}
