//! Carriers: the bits and bindings of overlays that carry enums, beside the fields that do.

use super::super::enums::Entry;
use super::super::merge::{Enums, Merged};
use super::super::width::Width;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{EnumId, Repr};
use crate::source::Span;
use crate::syntax::Text;

/// So many values of an enum that do not fit are named.
const NAMED_VALUES: usize = 3;

/// Bits or a field that an overlay gives an enum to.
pub(in crate::resolve) struct Carrier<'a> {
    /// The enum.
    pub(in crate::resolve) values: EnumId,
    /// Where it is named.
    pub(in crate::resolve) name: &'a Text,
    /// What carries it.
    pub(in crate::resolve) place: CarrierPlace,
}

/// What carries an enum.
#[derive(Clone, Copy)]
pub(in crate::resolve) enum CarrierPlace {
    /// So many bits, 1 to 64, whose width stands there.
    Bits(u8, Span),
    /// A field of this type, which stands there.
    Field(Repr, Span),
}

impl Carrier<'_> {
    /// The integer that suits it.
    pub(in crate::resolve) fn repr(&self) -> Repr {
        match self.place {
            CarrierPlace::Bits(width, _) => Repr::smallest_for(mask(width)),
            CarrierPlace::Field(repr, _) => repr,
        }
    }
}

/// The largest value of so many bits, at most 64.
fn mask(width: u8) -> u64 {
    u64::MAX >> (64 - u32::from(width.clamp(1, 64)))
}

/// Checks that the enums suit what carries them.
pub(in crate::resolve) fn check(
    carriers: &[Carrier<'_>],
    enums: &Enums<'_>,
    widths: &[Width],
    diagnostics: &mut Diagnostics,
) {
    for carrier in carriers {
        let index = carrier.values.0;
        let (Some(merged), Some(width)) = (enums.list.get(index), widths.get(index)) else { continue };
        match carrier.place {
            CarrierPlace::Bits(bits, place) if width.repr.highest() < mask(bits) => {
                diagnostics.push(too_narrow(carrier, merged, *width, (bits, place)));
            }
            CarrierPlace::Bits(bits, place) => diagnostics.extend(beyond(carrier, merged, (bits, place))),
            CarrierPlace::Field(repr, place) if repr != width.repr => {
                diagnostics.push(other_type(carrier, merged, *width, (repr, place)));
            }
            CarrierPlace::Field(..) => {}
        }
    }
}

fn too_narrow(carrier: &Carrier<'_>, merged: &Merged<'_>, width: Width, (bits, place): (u8, Span)) -> Diagnostic {
    let (name, repr) = (&carrier.name.value, width.repr.rust_name());
    let message = format!("enum `{name}` is {repr}, which does not hold all values of {bits} bits");
    let problem = Diagnostic::new(Code::EnumTooNarrow, carrier.name.span, message);
    let problem = problem.related(place, "the width");
    let problem = problem.related(merged.owner_span(width.owner), format!("the enum is {repr} here"));
    problem.help("define a new enum in the overlay, or make the bits a plain number")
}

/// The documented values that the bits cannot have.
fn beyond(carrier: &Carrier<'_>, merged: &Merged<'_>, (bits, place): (u8, Span)) -> Option<Diagnostic> {
    let largest = u128::from(mask(bits));
    let beyond: Vec<&Entry<'_>> = merged.entries.iter().filter(|entry| entry.value > largest).collect();
    let first = beyond.first()?;
    let name = |entry: &&Entry<'_>| format!("{} = {}", entry.syntax.name.value, entry.value);
    let mut named: Vec<String> = beyond.iter().take(NAMED_VALUES).map(name).collect();
    if beyond.len() > NAMED_VALUES {
        named.push(format!("{} more", beyond.len() - NAMED_VALUES));
    }
    let (values, unit) = (&carrier.name.value, if bits == 1 { "bit" } else { "bits" });
    let message = format!("values of enum `{values}` do not fit {bits} {unit}: {}", named.join(", "));
    let problem = Diagnostic::new(Code::ValueBeyondBits, carrier.name.span, message);
    let problem = problem.related(place, format!("at most {largest}"));
    let problem = problem.related(first.syntax.name.span, "does not fit");
    Some(
        problem.help("such a value arrives as another: make the bits wider, or leave it out and describe what arrives"),
    )
}

fn other_type(carrier: &Carrier<'_>, merged: &Merged<'_>, width: Width, (field, place): (Repr, Span)) -> Diagnostic {
    let (name, repr, field) = (&carrier.name.value, width.repr.rust_name(), field.rust_name());
    let message = format!("enum `{name}` is {repr}, and the field is {field}");
    let problem = Diagnostic::new(Code::Bind, carrier.name.span, message).related(place, "the field");
    let problem = problem.related(merged.owner_span(width.owner), format!("the enum is {repr} here"));
    problem.help("bind an enum to fields of its own type; a `<view>` can say which bits of the field it fills")
}
