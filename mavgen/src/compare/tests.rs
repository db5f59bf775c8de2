//! Every change is found, is called what it is, and is the only one.

mod edits;
mod groups;
mod model;
mod mutations;
mod properties;
mod renames;

use super::{Change, Group, compare};
use crate::diag::Diagnostics;
use crate::ir::{Dialect, FileIndex};
use crate::read::{Loaded, read, read_overlay};
use crate::roots::resolve;
use crate::source::Sources;

/// Resolves files, given as name and text; the first is the dialect's own, and the others are those that it includes.
fn dialect(files: &[(&str, &str)], overlay: Option<&str>) -> Dialect {
    let (mut sources, mut diagnostics, mut loaded) = (Sources::default(), Diagnostics::default(), Loaded::default());
    loaded.name = files[0].0.trim_end_matches(".xml").to_owned();
    for (name, text) in files {
        let id = sources.add(*name, *text);
        loaded.files.push(read(id, &sources, &mut diagnostics).into());
    }
    if let Some(overlay) = overlay {
        let id = sources.add("overlay.xml", overlay);
        loaded.overlays.push(read_overlay(id, &sources, &mut diagnostics).into());
    }
    loaded.includes = vec![Vec::new(); files.len()];
    loaded.includes[0] = (1..files.len()).map(FileIndex).collect();
    resolve(&loaded, &sources, &mut diagnostics)
        .map(|named| named.dialect)
        .unwrap_or_else(|| panic!("{:#?}", diagnostics.iter().map(|problem| &problem.message).collect::<Vec<_>>()))
}

fn of(text: &str) -> Dialect {
    dialect(&[("acme.xml", text)], None)
}

/// A change in one line: its group, `!` if it breaks something, and the sentence.
fn shown(change: &Change) -> String {
    format!("{}{} {change}", change.group().name(), if change.breaking { "!" } else { "" })
}

/// The changes from one text to another.
fn changes(old: &str, new: &str) -> Vec<String> {
    compare(&of(old), &of(new), None).unwrap().iter().map(shown).collect()
}
