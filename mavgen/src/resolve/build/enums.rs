//! Enums of the model.

use super::super::enums::{Enums, Merged, ValuedEntry};
use super::super::notes::{Notes, Whole};
use super::super::origin::{lifecycle, origin, tell_deprecated};
use super::super::overlay::Commands;
use super::super::spelling;
use super::super::width::Width;
use super::command;
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::ir::{Entry, Enum, FileIndex, Lifecycle, Origin};
use crate::read::Loaded;
use crate::syntax::Text;

/// The model of an enum.
pub(in crate::resolve) fn build(
    (loaded, enums): (&Loaded, &Enums<'_>),
    said: (&Notes<'_>, &Commands<'_>),
    merged: &Merged<'_>,
    width: Width,
    diagnostics: &mut Diagnostics,
) -> Enum {
    let Width { defining_file, repr, .. } = width;
    // An entry whose value is beyond 64 bits has been refused.
    let entries = merged.entries.iter().filter_map(|entry| Some((entry, u64::try_from(entry.value).ok()?)));
    let name = merged.name.value.as_str();
    let entries = entries.map(|entry| build_entry(name, entry, enums, said, diagnostics)).collect_vec();
    let (named_in, oldest) = merged.oldest(loaded);
    let mut origin = origin_of(merged, defining_file, diagnostics);
    if merged.refined.in_use {
        tell_deprecated(&mut origin);
    }
    said.0.add_to(&mut origin, (Whole::Enum, name, None));
    Enum {
        name: spelling::name(oldest),
        named_in,
        bitmask: merged.bitmask(defining_file),
        repr,
        entries,
        defined_in: defining_file,
        origin,
    }
}

fn build_entry(
    enum_: &str,
    (entry, value): (&ValuedEntry<'_>, u64),
    enums: &Enums<'_>,
    (notes, commands): (&Notes<'_>, &Commands<'_>),
    diagnostics: &mut Diagnostics,
) -> Entry {
    let syntax = entry.syntax;
    let lifecycle = lifecycle(&syntax.lifecycle, diagnostics);
    let mut origin = origin(entry.file, syntax.span, &syntax.description, lifecycle);
    notes.add_to(&mut origin, (Whole::Enum, enum_, Some(&syntax.name.value)));
    let mut command = command::resolve(enum_, entry, enums, diagnostics);
    commands.add_to((enum_, &syntax.name.value), (&mut command, &mut origin), enums, diagnostics);
    Entry { name: spelling::name(&syntax.name), value, auto: entry.auto, command, origin }
}

/// Place of the first definition, first description that is not empty, stage of life of the file that owns the enum.
///
/// The stage goes with that file so that a dialect that adds entries to a deprecated enum does not revive it.
fn origin_of(merged: &Merged<'_>, defining_file: FileIndex, diagnostics: &mut Diagnostics) -> Origin {
    let mut stage: Option<Lifecycle> = None;
    let mut description = &None;
    for block in &merged.blocks {
        let own = lifecycle(&block.syntax.lifecycle, diagnostics);
        if block.file == defining_file && stage.is_none() {
            stage = own;
        }
        if description.as_ref().is_none_or(|text: &Text| text.value.is_empty()) {
            description = &block.syntax.description;
        }
    }
    origin(merged.file, merged.span, description, stage)
}
