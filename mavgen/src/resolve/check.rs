//! Checks across enums: what is legal, and still likely to be a mistake.

use std::collections::HashMap;

use super::enums::{Enums, Merged, ValuedEntry};
use super::uses::{EnumUse, Use, UsePlace};
use super::width::Width;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{FileIndex, Repr, largest_of_bits};
use crate::order;
use crate::read::Loaded;
use crate::source::Span;

/// The fewest flags beyond 1 and 2 that make an enum look like a bitmask: small enums count 0, 1, 2 as well.
const FEWEST_FLAGS: usize = 2;

/// Looks at one enum and the fields that carry it.
pub(super) fn check(
    loaded: &Loaded,
    merged: &Merged<'_>,
    width: Width,
    uses: &[Use<'_>],
    diagnostics: &mut Diagnostics,
) {
    check_bitmask(merged, width.defining_file, uses, diagnostics);
    let (kinds, name) = (kinds(loaded, uses), merged.name.value.as_str());
    check_widths(loaded, (merged.defining_span(width.defining_file), width.defining_file), name, &kinds, diagnostics);
    for kind in kinds {
        let Some(beyond) = beyond(merged, width, kind.repr) else { continue };
        for one in uses.iter().filter(|one| one.repr == kind.repr) {
            check_values(name, &beyond, one, diagnostics);
        }
    }
}

/// Files should agree on what the enum is, and its values should look like it. Zero names the empty set.
fn check_bitmask(merged: &Merged<'_>, defining_file: FileIndex, uses: &[Use<'_>], diagnostics: &mut Diagnostics) {
    let bitmask = merged.declared_bitmask(defining_file);
    let defining_span = merged.defining_span(defining_file);
    let attribute = |given: bool| if given { "a bitmask" } else { "not a bitmask" };
    for block in merged.blocks.iter().filter(|block| block.bitmask != bitmask) {
        let name = &block.syntax.name;
        let place = block.syntax.bitmask.as_ref().map_or(name.span, |text| text.span);
        let message = format!("files disagree on whether enum `{}` is a bitmask", name.value);
        let problem = Diagnostic::new(Code::BitmaskDiffers, place, message);
        let problem = problem.label(attribute(block.bitmask));
        diagnostics.push(problem.related(defining_span, format!("{}: this file decides", attribute(bitmask))));
    }
    if merged.bitmask(defining_file) {
        check_bits(merged, diagnostics);
    } else if merged.refined.bitmask.is_none() && merged.blocks.iter().all(|block| block.syntax.bitmask.is_none()) {
        // Who writes `bitmask="false"` has thought of it.
        diagnostics.extend(likely_bitmask(merged, defining_span, uses));
    }
}

fn check_bits(merged: &Merged<'_>, diagnostics: &mut Diagnostics) {
    for entry in merged.entries.iter().filter(|entry| entry.value.count_ones() > 1) {
        let (name, value) = (&entry.syntax.name, entry.value);
        let message = format!("`{}` = {value} of bitmask `{}` is not a single bit", name.value, merged.name.value);
        let place = entry.syntax.value.as_ref().map_or(name.span, |text| text.span);
        diagnostics.push(Diagnostic::new(Code::BitmaskValue, place, message).label(format!("{value:#x}")));
    }
}

/// Says that an enum is most likely a bitmask, by its values or by how a field of it is shown.
fn likely_bitmask(merged: &Merged<'_>, enum_: Span, uses: &[Use<'_>]) -> Option<Diagnostic> {
    let name = &merged.name.value;
    let shown = uses.iter().find_map(|one| one.field.display.as_ref().filter(|display| display.value == "bitmask"));
    let problem = |message| Diagnostic::new(Code::LikelyBitmask, enum_, message);
    let problem = match shown {
        Some(display) => problem(format!("enum `{name}` is displayed as a bitmask, but it is not one"))
            .related(display.span, "displayed as a bitmask here"),
        None if looks_like_bitmask(merged) => {
            problem(format!("the values of enum `{name}` are single bits, but it is not a bitmask"))
        }
        None => return None,
    };
    Some(problem.help("if they are combined, add `bitmask=\"true\"`: then they are flags in Rust"))
}

fn looks_like_bitmask(merged: &Merged<'_>) -> bool {
    let mut values = merged.entries.iter().map(|entry| entry.value);
    let flags = values.clone().filter(|&value| value > 2).count();
    flags >= FEWEST_FLAGS && values.all(|value| value == 0 || value.is_power_of_two())
}

/// The first use with each integer, those of older files first.
fn kinds<'u, 'a>(loaded: &Loaded, uses: &'u [Use<'a>]) -> Vec<&'u Use<'a>> {
    let mut uses = uses.iter().collect_vec();
    order::sort_by_key(&mut uses, |one| loaded.age(one.file));
    let mut kinds: Vec<&Use<'a>> = Vec::new();
    for one in uses {
        if kinds.iter().all(|kind| kind.repr != one.repr) {
            kinds.push(one);
        }
    }
    kinds
}

/// One enum should have one integer: says once which fields differ. If the last of them is of a file that came after the enum, it
/// is the one to mend.
fn check_widths(
    loaded: &Loaded,
    (enum_, defining_file): (Span, FileIndex),
    name: &str,
    kinds: &[&Use<'_>],
    diagnostics: &mut Diagnostics,
) {
    let (Some((last, others)), 2..) = (kinds.split_last(), kinds.len()) else { return };
    let message = format!("enum `{name}` is carried by fields of {} types", kinds.len());
    let is =
        |one: &Use<'_>| format!("`{}.{}` is `{}`", one.message.name.value, one.field.name.value, one.field.ty.value);
    let related = |problem: Diagnostic, one: &&Use<'_>| problem.related(one.field.ty.span, is(one));
    let problem = |place| Diagnostic::new(Code::EnumWidths, place, message);
    diagnostics.push(if loaded.age(last.file) > loaded.age(defining_file) {
        let problem = problem(last.field.ty.span).label(is(last)).related(enum_, "the enum");
        others.iter().fold(problem, related)
    } else {
        kinds.iter().fold(problem(enum_), related)
    });
}

/// The values that do not fit an integer, as a label; those that made the enum wider have been spoken of.
fn beyond(merged: &Merged<'_>, width: Width, repr: Repr) -> Option<String> {
    let fitting = merged.entries.partition_point(|entry| entry.value <= u128::from(repr.highest()));
    let beyond = merged.entries.get(fitting..).unwrap_or_default();
    let beyond = beyond.iter().filter(|entry| !width.is_widened_by(entry)).collect_vec();
    (!beyond.is_empty()).then(|| ValuedEntry::list(&beyond))
}

/// Every value should fit every field.
fn check_values(name: &str, beyond: &str, one: &Use<'_>, diagnostics: &mut Diagnostics) {
    let (message, field, ty) = (&one.message.name.value, &one.field.name.value, &one.field.ty.value);
    let message = format!("`{message}.{field}` is `{ty}`, which does not hold every value of `{name}`");
    let problem = Diagnostic::new(Code::ValueBeyondField, one.name.span, message);
    diagnostics.push(problem.label(beyond));
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

/// Checks that the enums suit what carries them.
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
