//! From syntax to model: everything that a dialect leaves unsaid is worked out here, and everything that is wrong with it is
//! found.
//!
//! This file is the order of the passes. Each collects every problem it finds; what depends on a broken part is left out, so
//! that one mistake is reported once.

mod check;
mod command;
mod crc;
mod duplicates;
mod enums;
mod field;
mod field_type;
mod invalid;
mod layout;
mod lifecycle;
mod limits;
mod losses;
mod merge;
mod message;
mod naming;
mod number;
mod origin;
mod owner;
mod suggest;
mod uses;
mod version;
mod width;

#[cfg(test)]
mod tests;

use crate::diag::Diagnostics;
use crate::ir::{Dialect, File};
use crate::read::Loaded;
use crate::source::Sources;

use losses::Losses;
use merge::Enums;
use uses::Use;
use version::Version;
use width::Width;

/// Resolves the files of a dialect; `None` if there was an error, here or in reading them, or if there is no file.
pub fn resolve(loaded: &Loaded, sources: &Sources, diagnostics: &mut Diagnostics) -> Option<Dialect> {
    let losses = Losses::behind(diagnostics);
    let enums = Enums::merge(loaded, &losses, diagnostics);
    let versions: Vec<Version> = loaded.files.iter().map(|file| Version::of(file, diagnostics)).collect();
    duplicates::check(loaded, diagnostics);
    let mut drafts = message::drafts(loaded, &versions, &losses, diagnostics);
    let uses = uses::collect(&drafts, &enums, diagnostics);
    let widths = widths(loaded, &enums, &uses, diagnostics);
    uses::link(&mut drafts, &enums, &widths);
    invalid::link(&mut drafts, &enums, diagnostics);

    let types = naming::types(loaded, &enums, diagnostics);
    naming::check(loaded, &enums, &widths, diagnostics);
    check::check_entry_names(&enums.list, diagnostics);
    for ((merged, &width), uses) in enums.list.iter().zip(&widths).zip(&uses) {
        check::check(merged, width, uses, diagnostics);
    }

    let named = enums.list.iter().zip(widths).zip(types.enums);
    let models = named.map(|((merged, width), rust)| enums::model(merged, width, rust, &enums, diagnostics)).collect();
    let mut messages: Vec<_> = drafts.into_iter().map(|draft| draft.message).collect();
    messages.sort_by_key(|message| message.id);
    let version = versions.first().map_or(0, |version| version.number());
    let dialect = Dialect {
        name: loaded.name.clone(),
        type_name: types.dialect,
        version,
        files: files(loaded, sources),
        enums: models,
        messages,
    };
    if diagnostics.has_errors() { None } else { Some(dialect) }
}

/// Owner and integer of every enum.
fn widths(loaded: &Loaded, enums: &Enums<'_>, uses: &[Vec<Use<'_>>], diagnostics: &mut Diagnostics) -> Vec<Width> {
    let mut includes = owner::Includes::new(loaded);
    let each = enums.list.iter().zip(uses);
    each.map(|(merged, uses)| {
        let owner = owner::owner(merged, uses, &mut includes);
        Width::of(merged, owner, uses, diagnostics)
    })
    .collect()
}

/// The files of the model.
fn files(loaded: &Loaded, sources: &Sources) -> Vec<File> {
    let name = |file: &crate::syntax::File| sources.get(file.id).map(|source| source.name()).unwrap_or_default();
    let includes = loaded.includes.iter().cloned().chain(std::iter::repeat_with(Vec::new));
    loaded.files.iter().zip(includes).map(|(file, includes)| File { name: name(file), includes }).collect()
}
