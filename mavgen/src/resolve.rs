//! From syntax to model: everything that a dialect leaves unsaid is worked out here, and everything that is wrong with it is
//! found.
//!
//! This file is the order of the passes. Each collects every problem it finds; what depends on a broken part is left out, so
//! that one mistake is reported once.

mod boolean;
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
mod lost;
mod merge;
mod message;
mod number;
mod origin;
mod overlay;
mod owner;
mod reserved;
mod spelling;
mod suggest;
mod units;
mod uses;
mod version;
mod view;
mod width;

#[cfg(test)]
mod tests;

use crate::diag::Diagnostics;
use crate::ir::{Dialect, EnumId, File, Partial};
use crate::read::Loaded;
use crate::source::Sources;

use losses::Losses;
use merge::Enums;
use overlay::Carrier;
use uses::Use;
use version::Version;
use width::Width;

#[cfg(feature = "vendor")]
pub(crate) use width::integer;

/// Resolves the files of a dialect; `None` if there was an error, here or in reading them, or if there is no file.
///
/// What this finds is about the definitions. What collides in Rust alone is found by [`crate::Builder::resolve`].
pub fn resolve(loaded: &Loaded, sources: &Sources, diagnostics: &mut Diagnostics) -> Option<Dialect> {
    let partial = passes(loaded, sources, diagnostics);
    diagnostics.arrange();
    partial.filter(|_| !diagnostics.has_errors()).map(|partial| partial.dialect)
}

/// The passes: what can be resolved, also where there are errors; `None` if there is no file. Diagnostics are in the order in
/// which they were found.
pub(crate) fn passes(loaded: &Loaded, sources: &Sources, diagnostics: &mut Diagnostics) -> Option<Partial> {
    if loaded.files.is_empty() {
        return None;
    }
    let mut losses = Losses::behind(diagnostics);
    let loaded = &*overlay::check_heads(loaded, sources, &mut losses, diagnostics);
    let mut enums = Enums::merge(loaded, &losses, diagnostics);
    overlay::refine(loaded, &mut enums, diagnostics);
    let versions: Vec<Version> = loaded.files.iter().map(|file| Version::of(file, diagnostics)).collect();
    duplicates::check(loaded, diagnostics);
    reserved::check(loaded, diagnostics);
    let mut drafts = message::drafts(loaded, &versions, &losses, diagnostics);
    uses::check(loaded, &enums, diagnostics);
    let lost = message::lost(loaded, &drafts);
    uses::check_lost(&lost, &enums, diagnostics);
    let uses = uses::collect(&drafts, &enums, diagnostics);
    let carriers = overlay::resolve(loaded, &mut drafts, &enums, &losses, diagnostics);
    let widths = widths(loaded, &enums, &uses, &carriers, diagnostics);
    overlay::check_carriers(&carriers, &enums, &widths, diagnostics);
    uses::link(&mut drafts, &enums, &widths);
    invalid::link(&mut drafts, &enums, diagnostics);
    invalid::check(&lost, &enums, diagnostics);

    spelling::check_all(loaded, diagnostics);
    check::check_entry_names(loaded, &enums.list, diagnostics);
    for ((merged, &width), uses) in enums.list.iter().zip(&widths).zip(&uses) {
        check::check(loaded, merged, width, uses, diagnostics);
    }

    let sized = enums.list.iter().zip(widths);
    let models = sized.map(|(merged, width)| enums::model(loaded, merged, width, &enums, diagnostics)).collect();
    let mut messages: Vec<_> = drafts.into_iter().map(|draft| draft.message).collect();
    messages.sort_by_key(|message| message.id);
    let version = versions.first().map_or(0, |version| version.number());
    let (name, type_name) = (loaded.name.clone(), String::new());
    let mut dialect = Dialect { name, type_name, version, files: files(loaded, sources), enums: models, messages };
    overlay::note(loaded, &mut dialect, &losses, diagnostics);
    overlay::credit(loaded, &mut dialect);
    let (lost, lost_views) = (lost::messages(loaded, &dialect), lost::views(loaded, &dialect));
    Some(Partial { dialect, lost, lost_views })
}

/// Owner and integer of every enum.
fn widths(
    loaded: &Loaded,
    enums: &Enums<'_>,
    uses: &[Vec<Use<'_>>],
    carriers: &[Carrier<'_>],
    diagnostics: &mut Diagnostics,
) -> Vec<Width> {
    let mut includes = owner::Includes::new(loaded);
    let each = enums.list.iter().zip(uses).enumerate();
    each.map(|(index, (merged, uses))| {
        let owner = owner::owner(merged, uses, &mut includes);
        let mut asked = Vec::new();
        if owner.0 >= loaded.files.len() {
            let own = carriers.iter().filter(|carrier| carrier.values == EnumId(index));
            asked.extend(own.map(Carrier::repr));
        }
        Width::of(merged, owner, uses, &asked, diagnostics)
    })
    .collect()
}

/// The files of the model: those of the dialect, then the overlays.
fn files(loaded: &Loaded, sources: &Sources) -> Vec<File> {
    let files = loaded.files.iter().zip(loaded.includes.iter().cloned().chain(std::iter::repeat_with(Vec::new)));
    let files = files.map(|(file, includes)| File { name: sources.name(file.id), includes, overlay: false });
    let overlays = loaded.overlays.iter().map(|overlay| File {
        name: sources.name(overlay.id),
        includes: Vec::new(),
        overlay: true,
    });
    files.chain(overlays).collect()
}
