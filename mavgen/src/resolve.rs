//! From syntax to model: everything that a dialect leaves unsaid is worked out here, and everything that is wrong with it is
//! found.
//!
//! This file is the order of the passes. Each collects every problem it finds; what depends on a broken part is left out, so
//! that one mistake is reported once.

mod boolean;
mod build;
mod check;
mod enums;
mod field_type;
mod invalid;
mod lost;
mod message;
mod message_scope;
mod names;
mod notes;
mod number;
mod origin;
mod overlay;
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
use crate::ir::{Dialect, File, Partial};
use crate::order;
use crate::read::Loaded;
use crate::source::Sources;

use build::{Build, Commands};
use check::Carried;
use enums::Enums;
use invalid::Entries;
#[cfg(feature = "uorb")]
pub(crate) use invalid::sentinel_of;
use lost::Poisoned;
use notes::Notes;
use version::Version;
use width::Width;

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
    names::check_duplicates(loaded, diagnostics);
    names::check_reserved(loaded, diagnostics);
    let drafts = message::drafts(loaded, &versions, &poisoned, diagnostics);
    uses::check(loaded, &enums, diagnostics);
    let uses = uses::collect(&drafts, &enums, diagnostics);
    let entries = Entries::of(&enums);
    let (added, enum_uses) = overlay::resolve(loaded, &drafts.messages, (&enums, &entries), &poisoned, diagnostics);
    let widths = Width::of_all(loaded, &enums, &uses, &enum_uses, diagnostics);
    check::check_enum_uses(&enum_uses, &enums, &widths, diagnostics);
    for field in &drafts.lost {
        invalid::of_field(field, &entries, diagnostics);
    }
    names::check_all(loaded, diagnostics);
    check::check_entry_names(loaded, &enums.list, diagnostics);
    for ((merged, &width), uses) in enums.list.iter().zip(&widths).zip(&uses) {
        Carried { loaded, merged, width, uses }.check(diagnostics);
    }

    let notes = &Notes::of(loaded, &drafts.messages, &enums, &poisoned, diagnostics);
    let commands = &Commands::of(loaded, &enums, diagnostics);
    let (enums, widths, entries) = (&enums, &widths, &entries);
    let mut build = Build { loaded, enums, widths, entries, notes, commands, diagnostics };
    let enums = enums.list.iter().zip(widths).map(|(merged, &width)| build.enum_(merged, width)).collect_vec();
    let whole = drafts.messages.into_iter().zip(added);
    let mut messages = whole.map(|(draft, added)| build.message(draft, added)).collect_vec();
    order::sort_by_key(&mut messages, |message| message.id);
    let (name, version) = (loaded.name.clone(), versions.first()?.number);
    let dialect = Dialect { name, version, files: files(loaded, sources), enums, messages };
    let (lost, lost_views) = (lost::messages(loaded, &dialect), lost::views(loaded, &dialect));
    Some(Partial { dialect, lost, lost_views })
}

/// The files of the model: those of the dialect, then the overlays.
fn files(loaded: &Loaded, sources: &Sources) -> Vec<File> {
    let file = |id, includes, overlay| File { name: sources.name(id), includes, overlay };
    let includes = loaded.includes.iter().cloned().chain(std::iter::repeat_with(Vec::new));
    let files = loaded.files.iter().zip(includes).map(|(one, includes)| file(one.id, includes, false));
    let overlays = loaded.overlays.iter().map(|overlay| file(overlay.id, Vec::new(), true));
    files.chain(overlays).collect_vec()
}
