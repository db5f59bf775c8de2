//! Checks across enums: what is legal, and still likely to be a mistake.

use std::collections::HashMap;

use super::enums::{Enums, Merged, ValuedEntry};
use super::uses::{EnumUse, Use, UsePlace};
use super::width::Width;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Repr, largest_of_bits};
use crate::order;
use crate::read::Loaded;
use crate::source::Span;

/// The fewest flags beyond 1 and 2 that make an enum look like a bitmask: small enums count 0, 1, 2 as well.
const FEWEST_FLAGS: usize = 2;

/// An enum and the fields that carry it.
pub(super) struct Carried<'c, 'a> {
    pub(super) loaded: &'c Loaded,
    pub(super) merged: &'c Merged<'a>,
    pub(super) width: Width,
    pub(super) uses: &'c [Use<'a>],
}

impl<'c, 'a> Carried<'c, 'a> {
    pub(super) fn check(&self, diagnostics: &mut Diagnostics) {
        self.check_bitmask(diagnostics);
        let kinds = self.kinds();
        diagnostics.extend(self.widths_differ(&kinds));
        let name = &self.merged.name.value;
        for kind in kinds {
            let Some(beyond) = self.beyond(kind.repr) else { continue };
            // Every value should fit every field.
            for one in self.uses.iter().filter(|one| one.repr == kind.repr) {
                let (message, field, ty) = (&one.message.name.value, &one.field.name.value, &one.field.ty.value);
                let message = format!("`{message}.{field}` is `{ty}`, which does not hold every value of `{name}`");
                let problem = Diagnostic::new(Code::ValueBeyondField, one.name.span, message);
                diagnostics.push(problem.label(&*beyond));
            }
        }
    }

    /// Where the defining file names the enum.
    fn defined(&self) -> Span {
        self.merged.defining_span(self.width.defining_file)
    }

    /// Files should agree on what the enum is, and its values should look like it. Zero names the empty set.
    fn check_bitmask(&self, diagnostics: &mut Diagnostics) {
        let (merged, defining_file) = (self.merged, self.width.defining_file);
        let bitmask = merged.declared_bitmask(defining_file);
        let attribute = |given: bool| if given { "a bitmask" } else { "not a bitmask" };
        for block in merged.blocks.iter().filter(|block| block.bitmask != bitmask) {
            let name = &block.syntax.name;
            let place = block.syntax.bitmask.as_ref().map_or(name.span, |text| text.span);
            let message = format!("files disagree on whether enum `{}` is a bitmask", name.value);
            let problem = Diagnostic::new(Code::BitmaskDiffers, place, message).label(attribute(block.bitmask));
            diagnostics.push(problem.related(self.defined(), format!("{}: this file decides", attribute(bitmask))));
        }
        if merged.bitmask(defining_file) {
            for entry in merged.entries.iter().filter(|entry| entry.value.count_ones() > 1) {
                let (name, value, of) = (&entry.syntax.name, entry.value, &merged.name.value);
                let message = format!("`{}` = {value} of bitmask `{of}` is not a single bit", name.value);
                let place = entry.syntax.value.as_ref().map_or(name.span, |text| text.span);
                diagnostics.push(Diagnostic::new(Code::BitmaskValue, place, message).label(format!("{value:#x}")));
            }
        } else if merged.refined_bitmask.is_none() && merged.blocks.iter().all(|block| block.syntax.bitmask.is_none()) {
            // Who writes `bitmask="false"` has thought of it.
            diagnostics.extend(self.likely_bitmask());
        }
    }

    /// Says that an enum is most likely a bitmask, by its values or by how a field of it is shown.
    fn likely_bitmask(&self) -> Option<Diagnostic> {
        let name = &self.merged.name.value;
        let mut displays = self.uses.iter().filter_map(|one| one.field.display.as_ref());
        let mut values = self.merged.entries.iter().map(|entry| entry.value);
        let flags = values.clone().filter(|&value| value > 2).count();
        let problem = |message| Diagnostic::new(Code::LikelyBitmask, self.defined(), message);
        let problem = match displays.find(|display| display.value == "bitmask") {
            Some(display) => problem(format!("enum `{name}` is displayed as a bitmask, but it is not one"))
                .related(display.span, "displayed as a bitmask here"),
            None if flags >= FEWEST_FLAGS && values.all(|value| value == 0 || value.is_power_of_two()) => {
                problem(format!("the values of enum `{name}` are single bits, but it is not a bitmask"))
            }
            None => return None,
        };
        Some(problem.help("if they are combined, add `bitmask=\"true\"`: then they are flags in Rust"))
    }

    /// The first use with each integer, those of older files first.
    fn kinds(&self) -> Vec<&'c Use<'a>> {
        let mut uses = self.uses.iter().collect_vec();
        order::sort_by_key(&mut uses, |one| self.loaded.age(one.file));
        let mut kinds: Vec<&Use<'a>> = Vec::new();
        for one in uses {
            if kinds.iter().all(|kind| kind.repr != one.repr) {
                kinds.push(one);
            }
        }
        kinds
    }

    /// One enum should have one integer: says once which fields differ. If the last of them is of a file that came after the enum,
    /// it is the one to mend.
    fn widths_differ(&self, kinds: &[&Use<'_>]) -> Option<Diagnostic> {
        let (last, others) = kinds.split_last().filter(|(_, others)| !others.is_empty())?;
        let message = format!("enum `{}` is carried by fields of {} types", self.merged.name.value, kinds.len());
        let is = |Use { message, field, .. }: &Use<'_>| {
            format!("`{}.{}` is `{}`", message.name.value, field.name.value, field.ty.value)
        };
        let related = |problem: Diagnostic, one: &&Use<'_>| problem.related(one.field.ty.span, is(one));
        let problem = |place| Diagnostic::new(Code::EnumWidths, place, message);
        Some(if self.loaded.age(last.file) > self.loaded.age(self.width.defining_file) {
            let problem = problem(last.field.ty.span).label(is(last)).related(self.defined(), "the enum");
            others.iter().fold(problem, related)
        } else {
            kinds.iter().fold(problem(self.defined()), related)
        })
    }

    /// The values that do not fit an integer, as a label; those that made the enum wider have been spoken of.
    fn beyond(&self, repr: Repr) -> Option<String> {
        let fitting = self.merged.entries.partition_point(|entry| entry.value <= u128::from(repr.highest()));
        let beyond = self.merged.entries.get(fitting..).unwrap_or_default();
        let beyond = beyond.iter().filter(|entry| !self.width.is_widened_by(entry)).collect_vec();
        (!beyond.is_empty()).then(|| ValuedEntry::list(&beyond))
    }
}

/// Names of entries are global in C, and entries of two enums that share one are most likely the same thing twice.
pub(super) fn check_entry_names(loaded: &Loaded, enums: &[Merged<'_>], diagnostics: &mut Diagnostics) {
    let mut seen: HashMap<&str, (usize, Span)> = HashMap::new();
    let mut entries = Vec::new();
    for (index, merged) in enums.iter().enumerate() {
        entries.extend(merged.entries.iter().map(|entry| (index, entry)));
    }
    order::sort_by_key(&mut entries, |(_, entry)| loaded.age(entry.file));
    for (index, entry) in entries {
        let name = &entry.syntax.name;
        let (first, span) = *seen.entry(&name.value).or_insert((index, name.span));
        if first != index {
            let message = format!("`{}` is an entry of two enums", name.value);
            let problem = Diagnostic::new(Code::SameEntryName, name.span, message);
            diagnostics.push(problem.related(span, "the other one"));
        }
    }
}

pub(super) fn check_enum_uses(
    enum_uses: &[EnumUse<'_>],
    enums: &Enums<'_>,
    widths: &[Width],
    diagnostics: &mut Diagnostics,
) {
    for enum_use in enum_uses {
        let (Some(merged), Some(width)) = (enums.get(enum_use.enum_), widths.get(enum_use.enum_.0)) else { continue };
        let (name, repr, place) = (&enum_use.name.value, width.repr.name(), enum_use.place.1);
        let differs = |code, message, place_label, help| {
            let problem = Diagnostic::new(code, enum_use.name.span, message).related(place, place_label);
            let defined = merged.defining_span(width.defining_file);
            problem.related(defined, format!("the enum is {repr} here")).help(help)
        };
        match enum_use.place.0 {
            UsePlace::Bits(bits) if width.repr.highest() < largest_of_bits(bits) => {
                let message = format!("enum `{name}` is {repr}, which does not hold all values of {bits} bits");
                let help = "define a new enum in the overlay, or make the bits a plain number";
                diagnostics.push(differs(Code::EnumTooNarrow, message, "the width", help));
            }
            UsePlace::Bits(bits) => diagnostics.extend(beyond_bits(enum_use, merged, bits)),
            UsePlace::Field(field) if field != width.repr => {
                let message = format!("enum `{name}` is {repr}, and the field is {}", field.name());
                let help =
                    "bind an enum to fields of its own type; a `<view>` can say which bits of the field it fills";
                diagnostics.push(differs(Code::Bind, message, "the field", help));
            }
            UsePlace::Field(_) => {}
        }
    }
}

/// The documented values that the bits cannot have.
fn beyond_bits(enum_use: &EnumUse<'_>, merged: &Merged<'_>, bits: u8) -> Option<Diagnostic> {
    let largest = u128::from(largest_of_bits(bits));
    let beyond = merged.entries.iter().filter(|entry| entry.value > largest).collect_vec();
    let first = beyond.first()?;
    let (values, unit) = (&enum_use.name.value, if bits == 1 { "bit" } else { "bits" });
    let message = format!("values of enum `{values}` do not fit {bits} {unit}: {}", ValuedEntry::list(&beyond));
    let problem = Diagnostic::new(Code::ValueBeyondBits, enum_use.name.span, message);
    let problem = problem.related(enum_use.place.1, format!("at most {largest}"));
    let problem = problem.related(first.syntax.name.span, "does not fit");
    Some(
        problem.help("such a value arrives as another: make the bits wider, or leave it out and describe what arrives"),
    )
}
