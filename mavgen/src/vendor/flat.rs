//! Names in a flat folder: what files are called there, and how their includes have to be spelled.

use std::collections::HashMap;
use std::ops::Range;

use super::facts::escaped;
use crate::builder::Failure;
use crate::read::Loaded;
use crate::source::Sources;

/// An include of a file.
pub(super) struct Include {
    /// Where its path stands in the text.
    pub(super) place: Range<usize>,
    /// The path, as the file spells it.
    pub(super) path: String,
    /// What the file that it leads to is called.
    pub(super) name: String,
}

/// The names of a dialect's files, in its order.
///
/// Two files of one name cannot both be in the folder, and no name is made up: whoever includes them wants to know. Case does
/// not tell two names apart, because on some systems it does not.
pub(super) fn names(loaded: &Loaded, sources: &Sources) -> Result<Vec<String>, Failure> {
    let mut seen = HashMap::new();
    let mut names = Vec::new();
    for source in loaded.files.iter().filter_map(|file| sources.get(file.id)) {
        let name = source.name();
        if let Some(first) = seen.insert(name.to_lowercase(), source.path()) {
            let (first, second) = (first.display(), source.path().display());
            let problem = format!("`{first}` and `{second}` would be one file in one folder: rename one of them");
            return Err(Failure::Usage(problem));
        }
        names.push(name);
    }
    Ok(names)
}

/// The includes of the file at a place of [`Loaded::files`], in its order.
pub(super) fn includes(loaded: &Loaded, at: usize, names: &[String]) -> Vec<Include> {
    let Some((file, targets)) = loaded.files.get(at).zip(loaded.includes.get(at)) else { return Vec::new() };
    let pairs = file.includes.iter().zip(targets);
    let include = pairs.filter_map(|(path, target)| {
        let name = names.get(target.0)?.clone();
        Some(Include { place: path.span.range(), path: path.value.clone(), name })
    });
    include.collect()
}

/// The includes that have to be spelled anew, to lead to the flat folder: where they stand, and how they are spelled there.
pub(super) fn respelled(includes: &[Include]) -> Vec<(Range<usize>, String)> {
    let changed = includes.iter().filter(|include| include.path != include.name);
    changed.map(|include| (include.place.clone(), escaped(&include.name))).collect()
}
