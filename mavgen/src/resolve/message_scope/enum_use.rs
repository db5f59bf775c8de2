//! Uses of enums: the bits and bindings of overlays that carry enums, beside the fields that do.

use super::super::enums::{Enums, Merged, ValuedEntry};
use super::super::width::Width;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{EnumId, Repr};
use crate::source::Span;
use crate::syntax::Text;

/// Bits or a field that an overlay gives an enum to.
pub(in crate::resolve) struct EnumUse<'a> {
    /// The enum.
    pub(in crate::resolve) enum_: EnumId,
    /// Where it is named.
    pub(in crate::resolve) name: &'a Text,
    /// What carries it.
    pub(in crate::resolve) place: UsePlace,
}

/// What carries an enum.
#[derive(Clone, Copy)]
pub(in crate::resolve) enum UsePlace {
    /// So many bits, 1 to 64, whose width stands there.
    Bits(u8, Span),
    /// A field of this type, which stands there.
    Field(Repr, Span),
}

impl EnumUse<'_> {
    /// The integer that suits it.
    pub(in crate::resolve) fn repr(&self) -> Repr {
        match self.place {
            UsePlace::Bits(width, _) => Repr::smallest_for(mask(width)),
            UsePlace::Field(repr, _) => repr,
        }
    }
}

/// The largest value of so many bits, at most 64.
fn mask(width: u8) -> u64 {
    u64::MAX >> (64 - u32::from(width.clamp(1, 64)))
}

/// Checks that the enums suit what carries them.
pub(in crate::resolve) fn check(
    enum_uses: &[EnumUse<'_>],
    enums: &Enums<'_>,
    widths: &[Width],
    diagnostics: &mut Diagnostics,
) {
    for enum_use in enum_uses {
        let index = enum_use.enum_.0;
        let (Some(merged), Some(width)) = (enums.list.get(index), widths.get(index)) else { continue };
        match enum_use.place {
            UsePlace::Bits(bits, place) if width.repr.highest() < mask(bits) => {
                diagnostics.push(too_narrow(enum_use, merged, *width, (bits, place)));
            }
            UsePlace::Bits(bits, place) => diagnostics.extend(beyond(enum_use, merged, (bits, place))),
            UsePlace::Field(repr, place) if repr != width.repr => {
                diagnostics.push(other_type(enum_use, merged, *width, (repr, place)));
            }
            UsePlace::Field(..) => {}
        }
    }
}

fn too_narrow(enum_use: &EnumUse<'_>, merged: &Merged<'_>, width: Width, (bits, place): (u8, Span)) -> Diagnostic {
    let (name, repr) = (&enum_use.name.value, width.repr.name());
    let message = format!("enum `{name}` is {repr}, which does not hold all values of {bits} bits");
    let problem = Diagnostic::new(Code::EnumTooNarrow, enum_use.name.span, message);
    let problem = problem.related(place, "the width");
    let problem = problem.related(merged.defining_span(width.defining_file), format!("the enum is {repr} here"));
    problem.help("define a new enum in the overlay, or make the bits a plain number")
}

/// The documented values that the bits cannot have.
fn beyond(enum_use: &EnumUse<'_>, merged: &Merged<'_>, (bits, place): (u8, Span)) -> Option<Diagnostic> {
    let largest = u128::from(mask(bits));
    let beyond = merged.entries.iter().filter(|entry| entry.value > largest).collect_vec();
    let first = beyond.first()?;
    let (values, unit) = (&enum_use.name.value, if bits == 1 { "bit" } else { "bits" });
    let message = format!("values of enum `{values}` do not fit {bits} {unit}: {}", ValuedEntry::list(&beyond));
    let problem = Diagnostic::new(Code::ValueBeyondBits, enum_use.name.span, message);
    let problem = problem.related(place, format!("at most {largest}"));
    let problem = problem.related(first.syntax.name.span, "does not fit");
    Some(
        problem.help("such a value arrives as another: make the bits wider, or leave it out and describe what arrives"),
    )
}

fn other_type(enum_use: &EnumUse<'_>, merged: &Merged<'_>, width: Width, (field, place): (Repr, Span)) -> Diagnostic {
    let (name, repr, field) = (&enum_use.name.value, width.repr.name(), field.name());
    let message = format!("enum `{name}` is {repr}, and the field is {field}");
    let problem = Diagnostic::new(Code::Bind, enum_use.name.span, message).related(place, "the field");
    let problem = problem.related(merged.defining_span(width.defining_file), format!("the enum is {repr} here"));
    problem.help("bind an enum to fields of its own type; a `<view>` can say which bits of the field it fills")
}
