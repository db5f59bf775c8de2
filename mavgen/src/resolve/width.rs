//! Which of several files that define an enum decides on its type, and width and sign of the integer behind it.

use super::enums::{Enums, Merged, ValuedEntry};
use super::uses::{EnumUse, Use};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{EnumId, FileIndex, Repr};
use crate::read::Loaded;

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
    /// Decides for every enum, from the fields and entries of the file that owns it, or from the bits and bindings of the
    /// overlay.
    ///
    /// Entries of other files that do not fit make it wider, which is said: it changes a type of the file they include.
    pub(super) fn of_all(
        loaded: &Loaded,
        enums: &Enums<'_>,
        uses: &[Vec<Use<'_>>],
        enum_uses: &[EnumUse<'_>],
        diagnostics: &mut Diagnostics,
    ) -> Vec<Self> {
        let mut includes = Includes { direct: &loaded.includes, reached: vec![None; loaded.files.len()] };
        let each = enums.list.iter().zip(uses).enumerate().map(|(index, (merged, uses))| {
            let defining_file = defining_file(merged, uses, &mut includes);
            let is_of_overlay = defining_file.0 >= loaded.files.len();
            let asked = enum_uses.iter().filter(|enum_use| is_of_overlay && enum_use.enum_ == EnumId(index));
            let own = own_repr(merged, defining_file, uses, &asked.map(EnumUse::repr).collect_vec());
            let width = Self { defining_file, own, repr: widened(own, merged.largest()) };
            if let Some(entry) = merged.entries.iter().find(|entry| width.is_widened_by(entry)) {
                diagnostics.push(width.widening(merged, entry));
            }
            width
        });
        each.collect_vec()
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

/// Which files include which, however indirectly; worked out when first asked, file by file.
struct Includes<'l> {
    direct: &'l [Vec<FileIndex>],
    reached: Vec<Option<Vec<bool>>>,
}

impl Includes<'_> {
    /// Whether `file` includes `other`, directly or through others.
    fn reaches(&mut self, file: FileIndex, other: FileIndex) -> bool {
        let Some(slot) = self.reached.get_mut(file.0) else { return false };
        let reached = slot.get_or_insert_with(|| reached_from(file, self.direct));
        reached.get(other.0).copied().unwrap_or_default()
    }
}

/// The files that `file` includes, however indirectly, each marked.
fn reached_from(file: FileIndex, direct: &[Vec<FileIndex>]) -> Vec<bool> {
    let mut reached = vec![false; direct.len()];
    let mut open = vec![file];
    while let Some(FileIndex(index)) = open.pop() {
        for &include in direct.get(index).into_iter().flatten() {
            if let Some(mark) = reached.get_mut(include.0).filter(|mark| !**mark) {
                *mark = true;
                open.push(include);
            }
        }
    }
    reached
}

/// The file that owns an enum: of all that define it, the one that most of the others include; then one whose own messages
/// use it; then the first.
///
/// A dialect that adds entries to an enum of the file it includes is thereby never the one.
fn defining_file(merged: &Merged<'_>, uses: &[Use<'_>], includes: &mut Includes<'_>) -> FileIndex {
    let mut files = merged.blocks.iter().map(|block| block.file).collect_vec();
    files.dedup();
    let mut best = (0, false, merged.file);
    for &file in &files {
        let includers = files.iter().filter(|&&other| other != file && includes.reaches(other, file)).count();
        let used = uses.iter().any(|one| one.file == file);
        if (includers, used) > (best.0, best.1) {
            best = (includers, used, file);
        }
    }
    best.2
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

    #[test]
    fn includes_are_followed_through_others_and_around() {
        let direct = [vec![FileIndex(1)], vec![FileIndex(2)], vec![FileIndex(1)], vec![]];
        assert_eq!(reached_from(FileIndex(0), &direct), [false, true, true, false]);
        assert_eq!(reached_from(FileIndex(2), &direct), [false, true, true, false]);
        assert_eq!(reached_from(FileIndex(3), &direct), [false; 4]);
    }
}
