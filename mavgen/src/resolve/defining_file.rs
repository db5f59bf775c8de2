//! Ownership: which of several files that define an enum decides on its type.

use super::enums::Merged;
use super::uses::Use;
use crate::collect::CollectVec as _;
use crate::ir::FileIndex;
use crate::read::Loaded;

/// Which files include which, however indirectly; worked out when first asked, file by file.
pub(super) struct Includes<'l> {
    direct: &'l [Vec<FileIndex>],
    reached: Vec<Option<Vec<bool>>>,
}

impl<'l> Includes<'l> {
    /// The includes of a run.
    pub(super) fn new(loaded: &'l Loaded) -> Self {
        Self { direct: &loaded.includes, reached: vec![None; loaded.files.len()] }
    }

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
pub(super) fn of(merged: &Merged<'_>, uses: &[Use<'_>], includes: &mut Includes<'_>) -> FileIndex {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn includes_are_followed_through_others_and_around() {
        let direct = [vec![FileIndex(1)], vec![FileIndex(2)], vec![FileIndex(1)], vec![]];
        assert_eq!(reached_from(FileIndex(0), &direct), [false, true, true, false]);
        assert_eq!(reached_from(FileIndex(2), &direct), [false, true, true, false]);
        assert_eq!(reached_from(FileIndex(3), &direct), [false; 4]);
    }
}
