//! Uses of enums: the bits and bindings of overlays that carry enums, beside the fields that do.

use super::super::enums::{Enums, Merged, ValuedEntry};
use super::super::width::Width;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{EnumId, Repr, largest_of_bits};
use crate::source::Span;
use crate::syntax::Text;

/// Bits or a field that an overlay gives an enum to.
pub(in crate::resolve) struct EnumUse<'a> {
    pub(in crate::resolve) enum_: EnumId,
    /// Where it is named.
    pub(in crate::resolve) name: &'a Text,
    /// What carries it, and where its width or its type stands.
    pub(in crate::resolve) place: (UsePlace, Span),
}

/// What carries an enum.
#[derive(Clone, Copy)]
pub(in crate::resolve) enum UsePlace {
    /// So many bits, 1 to 64.
    Bits(u8),
    /// A field.
    Field(Repr),
}

impl EnumUse<'_> {
    /// The integer that suits it.
    pub(in crate::resolve) fn repr(&self) -> Repr {
        match self.place.0 {
            UsePlace::Bits(width) => Repr::smallest_for(largest_of_bits(width)),
            UsePlace::Field(repr) => repr,
        }
    }
}

/// Checks that the enums suit what carries them.
pub(in crate::resolve) fn check(
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
            UsePlace::Bits(bits) => diagnostics.extend(beyond(enum_use, merged, bits)),
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
fn beyond(enum_use: &EnumUse<'_>, merged: &Merged<'_>, bits: u8) -> Option<Diagnostic> {
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
