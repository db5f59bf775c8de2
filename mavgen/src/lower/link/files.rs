//! The files of all dialects, each once.

use crate::internal::Internal;
use crate::ir::{Dialect, File, FileIndex};
use crate::source::FileId;

#[derive(Default)]
pub(super) struct Files {
    pub(super) list: Vec<File>,
    /// Where each was read from.
    sources: Vec<FileId>,
}

impl Files {
    /// Takes in the files of a dialect, and points everything in it to their new places. Returns that of its top file.
    pub(super) fn take(&mut self, dialect: &mut Dialect, sources: &[FileId]) -> Result<FileIndex, Internal> {
        let before = self.list.len();
        let mut places = Vec::with_capacity(sources.len());
        for (file, source) in std::mem::take(&mut dialect.files).into_iter().zip(sources) {
            let known = self.sources.iter().position(|known| known == source);
            places.push(FileIndex(known.unwrap_or(self.list.len())));
            if known.is_none() {
                self.list.push(file);
                self.sources.push(*source);
            }
        }
        let mut lost = None;
        let mut moved = |file: &mut FileIndex| match places.get(file.0) {
            Some(place) => *file = *place,
            None => lost = Some(file.0),
        };
        self.list.iter_mut().skip(before).flat_map(|file| &mut file.includes).for_each(&mut moved);
        each(dialect, moved);
        match (lost, places.first()) {
            (None, Some(top)) => Ok(*top),
            (Some(lost), _) => Err(Internal::new(format!("dialect {} has no file {lost}", dialect.name))),
            (None, None) => Err(Internal::new(format!("dialect {} has no files", dialect.name))),
        }
    }
}

/// Changes every mention of a file.
fn each(dialect: &mut Dialect, mut change: impl FnMut(&mut FileIndex)) {
    for enum_ in &mut dialect.enums {
        change(&mut enum_.named_in);
        change(&mut enum_.defined_in);
        enum_.origin.map_files(&mut change);
        for entry in &mut enum_.entries {
            entry.origin.map_files(&mut change);
            let params = entry.command.iter_mut().flat_map(|command| &mut command.params);
            params.for_each(|param| param.origin.map_files(&mut change));
        }
    }
    for message in &mut dialect.messages {
        message.origin.map_files(&mut change);
        message.fields.iter_mut().for_each(|field| field.origin.map_files(&mut change));
        message.views.iter_mut().for_each(|view| view.origin.map_files(&mut change));
    }
}
