//! The last pass: finished items of the model out of what the others found.

mod command;

use super::enums::{Enums, Merged, ValuedEntry};
use super::invalid::{self, Entries};
use super::message::{Draft, DraftField};
use super::notes::{Notes, Whole};
use super::origin::{lifecycle, non_empty, origin, tell_deprecated};
use super::overlay::Added;
use super::width::Width;
use super::{names, uses};
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::ir::{Entry, Enum, Field, FileIndex, Layout, Lifecycle, Message, Origin, Values};
use crate::read::Loaded;
use crate::syntax::Text;

pub(super) use command::Commands;

/// What the items of the model are made of.
pub(super) struct Build<'b, 'a> {
    pub(super) loaded: &'b Loaded,
    pub(super) enums: &'b Enums<'a>,
    pub(super) widths: &'b [Width],
    pub(super) entries: &'b Entries<'a>,
    pub(super) notes: &'b Notes<'a>,
    pub(super) commands: &'b Commands<'a>,
    pub(super) diagnostics: &'b mut Diagnostics,
}

impl Build<'_, '_> {
    pub(super) fn message(&mut self, draft: Draft<'_>, Added { views, bindings }: Added) -> Message {
        let name = draft.syntax.name.value.as_str();
        let mut origin = draft.origin;
        self.notes.add_to(&mut origin, (Whole::Message, name, None));
        let Layout { offsets, len_v1, len_v2, crc_extra } = draft.layout;
        let fields = draft.fields.into_iter().zip(offsets);
        Message {
            id: draft.id,
            name: names::name(&draft.syntax.name),
            crc_extra,
            len_v1,
            len_v2,
            fields: fields.map(|(field, offset)| self.field(name, field, offset)).collect_vec(),
            views,
            bindings,
            origin,
        }
    }

    fn field(&mut self, message: &str, field: DraftField<'_>, offset: u8) -> Field {
        let invalid = invalid::of_field(&field, self.entries, self.diagnostics);
        let values = self.values(&field);
        let DraftField { syntax, ty, extension, limits, display_bitmask, instance, mut origin } = field;
        self.notes.add_to(&mut origin, (Whole::Message, message, Some(&syntax.name.value)));
        Field {
            name: names::name(&syntax.name),
            ty,
            offset,
            extension,
            values,
            units: non_empty(&syntax.units),
            invalid,
            limits,
            multiplier: non_empty(&syntax.multiplier),
            default: non_empty(&syntax.default),
            print_format: non_empty(&syntax.print_format),
            display_bitmask,
            instance,
            origin,
        }
    }

    /// What a field carries, now that every enum has its integer.
    fn values(&self, field: &DraftField<'_>) -> Option<Values> {
        let id = self.enums.id(&uses::named(field.syntax)?.value)?;
        let own = field.ty.scalar.repr()?;
        let width = self.widths.get(id.0)?;
        Some(if width.repr == own { Values::Typed(id) } else { Values::Converted(id) })
    }

    pub(super) fn enum_(&mut self, merged: &Merged<'_>, Width { defining_file, repr, .. }: Width) -> Enum {
        let name = merged.name.value.as_str();
        // An entry whose value is beyond 64 bits has been refused.
        let entries = merged.entries.iter().filter_map(|entry| Some((entry, u64::try_from(entry.value).ok()?)));
        let entries = entries.map(|(entry, value)| self.entry(name, entry, value)).collect_vec();
        let (named_in, oldest) = merged.oldest(self.loaded);
        let mut origin = self.origin_of(merged, defining_file);
        if merged.in_use {
            tell_deprecated(&mut origin);
        }
        self.notes.add_to(&mut origin, (Whole::Enum, name, None));
        let (name, bitmask) = (names::name(oldest), merged.bitmask(defining_file));
        Enum { name, named_in, bitmask, repr, entries, defined_in: defining_file, origin }
    }

    fn entry(&mut self, enum_: &str, entry: &ValuedEntry<'_>, value: u64) -> Entry {
        let syntax = entry.syntax;
        let lifecycle = lifecycle(&syntax.lifecycle, self.diagnostics);
        let mut origin = origin(entry.file, syntax.span, &syntax.description, lifecycle);
        self.notes.add_to(&mut origin, (Whole::Enum, enum_, Some(&syntax.name.value)));
        let command = self.command(enum_, entry, &mut origin);
        Entry { name: names::name(&syntax.name), value, auto: entry.auto, command, origin }
    }

    /// Place of the first definition, first description that is not empty, stage of life of the file that owns the enum.
    ///
    /// The stage goes with that file so that a dialect that adds entries to a deprecated enum does not revive it.
    fn origin_of(&mut self, merged: &Merged<'_>, defining_file: FileIndex) -> Origin {
        let mut stage: Option<Lifecycle> = None;
        let mut description = &None;
        for block in &merged.blocks {
            let own = lifecycle(&block.syntax.lifecycle, self.diagnostics);
            if block.file == defining_file && stage.is_none() {
                stage = own;
            }
            if description.as_ref().is_none_or(|text: &Text| text.value.is_empty()) {
                description = &block.syntax.description;
            }
        }
        origin(merged.file, merged.span, description, stage)
    }
}
