//! From syntax to model: everything that a dialect leaves unsaid is worked out here, and everything that is wrong with it is
//! found.
//!
//! This file is the order of the passes. Each collects every problem it finds; what depends on a broken part is left out, so
//! that one mistake is reported once.

mod boolean;
mod build;
mod check;
mod defining_file;
mod duplicates;
mod enums;
mod field;
mod field_type;
mod invalid;
mod limits;
mod lost;
mod message;
mod message_scope;
mod notes;
mod number;
mod origin;
mod overlay;
mod poisoned;
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

use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::ir::{Dialect, EnumId, File, Partial};
use crate::order;
use crate::read::Loaded;
use crate::source::Sources;

use build::{Links, build_enum, build_message};
use enums::Enums;
use invalid::Entries;
#[cfg(feature = "uorb")]
pub(crate) use invalid::sentinel_of;
use message_scope::{EnumUse, check_enum_uses};
use notes::Notes;
use poisoned::Poisoned;
use uses::Use;
use version::Version;
use width::Width;

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
    let mut poisoned = Poisoned::behind(diagnostics);
    let loaded = &*overlay::check_heads(loaded, sources, &mut poisoned, diagnostics);
    let mut enums = Enums::merge(loaded, &poisoned, diagnostics);
    overlay::refine(loaded, &mut enums, diagnostics);
    let versions = loaded.files.iter().map(|file| Version::of(file, diagnostics)).collect_vec();
    duplicates::check(loaded, diagnostics);
    reserved::check(loaded, diagnostics);
    let drafts = message::drafts(loaded, &versions, &poisoned, diagnostics);
    uses::check(loaded, &enums, diagnostics);
    let uses = uses::collect(&drafts, &enums, diagnostics);
    let entries = Entries::of(&enums);
    let (added, enum_uses) = overlay::resolve(loaded, &drafts.messages, (&enums, &entries), &poisoned, diagnostics);
    let widths = widths(loaded, &enums, &uses, &enum_uses, diagnostics);
    check_enum_uses(&enum_uses, &enums, &widths, diagnostics);
    for field in &drafts.lost {
        invalid::of_field(field, &entries, diagnostics);
    }
    spelling::check_all(loaded, diagnostics);
    check::check_entry_names(loaded, &enums.list, diagnostics);
    for ((merged, &width), uses) in enums.list.iter().zip(&widths).zip(&uses) {
        check::check(loaded, merged, width, uses, diagnostics);
    }

    let notes = Notes::of(loaded, &drafts.messages, &enums, &poisoned, diagnostics);
    let commands = overlay::Commands::of(loaded, &enums, diagnostics);
    let said = (&notes, &commands);
    let sized = enums.list.iter().zip(&widths);
    let models =
        sized.map(|(merged, &width)| build_enum((loaded, &enums), said, merged, width, diagnostics)).collect_vec();
    let links = Links { enums: &enums, widths: &widths, entries: &entries, notes: &notes };
    let whole = drafts.messages.into_iter().zip(added);
    let mut messages = whole.map(|(draft, added)| build_message(draft, added, &links, diagnostics)).collect_vec();
    order::sort_by_key(&mut messages, |message| message.id);
    let (name, version) = (loaded.name.clone(), versions.first()?.number());
    let dialect = Dialect { name, version, files: files(loaded, sources), enums: models, messages };
    let (lost, lost_views) = (lost::messages(loaded, &dialect), lost::views(loaded, &dialect));
    Some(Partial { dialect, lost, lost_views })
}

/// Defining file and integer of every enum.
fn widths(
    loaded: &Loaded,
    enums: &Enums<'_>,
    uses: &[Vec<Use<'_>>],
    enum_uses: &[EnumUse<'_>],
    diagnostics: &mut Diagnostics,
) -> Vec<Width> {
    let mut includes = defining_file::Includes::new(loaded);
    let each = enums.list.iter().zip(uses).enumerate();
    each.map(|(index, (merged, uses))| {
        let defining_file = defining_file::of(merged, uses, &mut includes);
        let mut asked = Vec::new();
        if defining_file.0 >= loaded.files.len() {
            let own = enum_uses.iter().filter(|enum_use| enum_use.enum_ == EnumId(index));
            asked.extend(own.map(EnumUse::repr));
        }
        Width::of(merged, defining_file, uses, &asked, diagnostics)
    })
    .collect_vec()
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
    files.chain(overlays).collect_vec()
}
