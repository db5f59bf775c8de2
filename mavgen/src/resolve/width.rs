//! Width and sign of the integer behind an enum.

use super::enums::{Merged, ValuedEntry};
use super::uses::Use;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{FileIndex, Repr};

/// Who decides on the integer behind an enum, and which one it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Width {
    /// The file that owns the enum.
    pub(super) defining_file: FileIndex,
    /// The integer that the fields and entries of that file ask for.
    own: Repr,
    /// The integer that all entries fit.
    pub(super) repr: Repr,
}

impl Width {
    /// Decides, from the fields and entries of the file that owns the enum.
    ///
    /// Entries of other files that do not fit make it wider, which is said: it changes a type of the file they include.
    ///
    /// `asked` are the integers that the bits and bindings of an overlay ask its own enums to be.
    pub(super) fn of(
        merged: &Merged<'_>,
        defining_file: FileIndex,
        uses: &[Use<'_>],
        asked: &[Repr],
        diagnostics: &mut Diagnostics,
    ) -> Self {
        let own = own_repr(merged, defining_file, uses, asked);
        let width = Self { defining_file, own, repr: widened(own, merged.largest()) };
        if let Some(entry) = merged.entries.iter().find(|entry| width.is_widened_by(entry)) {
            diagnostics.push(width.widening(merged, entry));
        }
        width
    }

    /// Whether the entry is one that made the enum wider.
    pub(super) fn is_widened_by(self, entry: &ValuedEntry<'_>) -> bool {
        entry.file != self.defining_file && entry.value > u128::from(self.own.highest())
    }

    fn widening(self, merged: &Merged<'_>, entry: &ValuedEntry<'_>) -> Diagnostic {
        let (name, value, of) = (&entry.syntax.name, entry.value, &merged.name.value);
        let (from, to) = (self.own.name(), self.repr.name());
        let message = format!("`{}` = {value} does not fit `{of}`, which becomes {to} instead of {from}", name.value);
        let problem = Diagnostic::new(Code::WidenedEnum, name.span, message);
        problem.related(merged.defining_span(self.defining_file), format!("the enum is {from} here"))
    }
}

/// The widest field of the messages of the file that owns it, unsigned before signed, or else the smallest unsigned; wide enough for the
/// entries of that file.
fn own_repr(merged: &Merged<'_>, defining_file: FileIndex, uses: &[Use<'_>], asked: &[Repr]) -> Repr {
    let fields = uses.iter().filter(|one| one.file == defining_file).map(|one| one.repr);
    let widest = fields.chain(asked.iter().copied()).max_by_key(|repr| (repr.size(), !repr.is_signed()));
    let entries = merged.entries.iter().filter(|entry| entry.file == defining_file);
    // One beyond 64 bits has been refused.
    let largest = entries.filter_map(|entry| u64::try_from(entry.value).ok()).max();
    widened(widest.unwrap_or(Repr::U8), largest.unwrap_or_default())
}

/// The smallest type of the sign of `repr`, at least as wide, that holds `value`; unsigned if no signed one does.
fn widened(repr: Repr, value: u64) -> Repr {
    if value <= repr.highest() {
        return repr;
    }
    let signed =
        [Repr::I16, Repr::I32, Repr::I64].into_iter().find(|wider| repr.is_signed() && value <= wider.highest());
    signed.unwrap_or_else(|| Repr::smallest_for(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widening_keeps_the_sign_while_it_can() {
        for (repr, value, wide) in [
            (Repr::U8, 255, Repr::U8),
            (Repr::U8, 256, Repr::U16),
            (Repr::U8, 1 << 32, Repr::U64),
            (Repr::I8, 127, Repr::I8),
            (Repr::I8, 128, Repr::I16),
            (Repr::I16, 40_000, Repr::I32),
            (Repr::I32, u64::MAX / 2, Repr::I64),
            (Repr::I8, u64::MAX, Repr::U64),
        ] {
            assert_eq!(widened(repr, value), wide, "{repr:?} {value}");
        }
    }
}
