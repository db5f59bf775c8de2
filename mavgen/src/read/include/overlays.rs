//! The overlays of the dialects: each read once, and given to the dialects that it is for.

use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::Arc;

use super::{Loaded, bytes, paths};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::source::Sources;
use crate::syntax::{Overlay, Text};

/// Reads the overlays at `paths`, one that is named twice only once. They are watched with the first dialect.
pub(super) fn load(paths: &[PathBuf], dialects: &mut [Loaded], sources: &mut Sources, diagnostics: &mut Diagnostics) {
    let mut seen: HashSet<PathBuf> = HashSet::new();
    for path in paths {
        if !seen.insert(paths::absolute(path)) {
            continue;
        }
        if let Some(first) = dialects.first_mut() {
            first.watched.push(path.to_owned());
        }
        match bytes::read(path, sources) {
            Ok(id) => {
                let overlay = Arc::new(super::super::read_overlay(id, sources, diagnostics));
                give(overlay, dialects, sources, diagnostics);
            }
            Err(why) => diagnostics.push(why.diagnostic(path)),
        }
    }
}

/// Gives an overlay to the dialects that have the file that it is for. Where there is one dialect, it can be for no other.
fn give(overlay: Arc<Overlay>, dialects: &mut [Loaded], sources: &Sources, diagnostics: &mut Diagnostics) {
    if let ([only], _) | ([only, ..], None) = (&mut *dialects, &overlay.base) {
        only.overlays.push(overlay);
        return;
    }
    let Some(base) = &overlay.base else { return };
    let names = dialects.iter().map(|dialect| names(dialect, sources)).collect_vec();
    let mut homeless = true;
    for (dialect, names) in dialects.iter_mut().zip(&names) {
        if names.contains(&base.value) {
            dialect.overlays.push(overlay.clone());
            homeless = false;
        }
    }
    if homeless && !dialects.iter().any(|dialect| dialect.has_include(&base.value)) {
        diagnostics.push(foreign(base, &names));
    }
}

/// The names of the files of a dialect.
fn names(dialect: &Loaded, sources: &Sources) -> Vec<String> {
    dialect.files.iter().filter_map(|file| sources.get(file.id)).map(|source| source.name()).collect_vec()
}

fn foreign(base: &Text, names: &[Vec<String>]) -> Diagnostic {
    let message = format!("the overlay is for `{}`, which is part of none of the dialects", base.value);
    let problem = Diagnostic::new(Code::HomelessOverlay, base.span, message).label("no file of this name was read");
    let tops = names.iter().filter_map(|names| names.first()).map(String::as_str).collect_vec();
    problem
        .help(format!("the dialects are `{}`, and the files that they include", tops.join("`, `")))
        .meant(nearest(&base.value, names.iter().flatten().map(String::as_str)))
}
