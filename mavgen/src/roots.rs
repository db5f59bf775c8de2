//! From what was read to what is emitted: every dialect is resolved and named for itself, then several are linked.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::emit::is_identifier;
use crate::internal::Internal;
use crate::ir::{Dialect, Kept};
use crate::lower::link::{self, Part, Union};
use crate::lower::names::Names;
use crate::lower::spelling::dialect_module_name;
use crate::read::Loaded;
use crate::resolve::passes;
use crate::select::Selection;
use crate::source::{FileId, Sources};

/// What a tree with several dialects is called unless it is given a name.
pub(crate) const TREE: &str = "dialects";

/// A resolved dialect, and what everything in it is called in Rust.
#[derive(Clone, Debug)]
pub(crate) struct Named {
    pub(crate) dialect: Dialect,
    pub(crate) names: Names,
}

impl Named {
    /// Drops what is not selected. What stays keeps its name: those are given before.
    pub(crate) fn select(&mut self, selection: &Selection) {
        self.cut(&selection.kept(&self.dialect));
    }

    /// Drops what does not stay, and what it is called.
    pub(crate) fn cut(&mut self, kept: &Kept) {
        self.dialect.cut(kept);
        self.names.cut(kept);
    }
}

/// Why these files cannot be the dialects of one tree of this name, if they cannot.
pub(crate) fn conflict(roots: &[PathBuf], tree: &str) -> Option<String> {
    if roots.len() > 1 && !is_identifier(&dialect_module_name(tree)) {
        return Some(format!("`{tree}` makes no Rust name for a module: use letters and digits"));
    }
    let mut known: HashSet<PathBuf> = HashSet::new();
    let mut twice = roots.iter().filter(|root| !known.insert(root.canonicalize().unwrap_or_else(|_| (*root).clone())));
    twice.next().map(|root| format!("`{}` is given twice: name each dialect once", root.display()))
}

/// Resolves a dialect and names everything in it; `None` if there was an error, also in reading it. One run finds all that is
/// wrong: names are checked also where resolving found errors.
pub(crate) fn resolve(loaded: &Loaded, sources: &Sources, diagnostics: &mut Diagnostics) -> Option<Named> {
    let named = passes(loaded, sources, diagnostics).map(|partial| {
        let names = Names::check(&partial, diagnostics);
        Named { dialect: partial.dialect, names }
    });
    diagnostics.arrange();
    let named = named.filter(|_| !diagnostics.has_errors());
    if cfg!(debug_assertions)
        && let Some(Err(faults)) = named.as_ref().map(|named| named.dialect.validate())
    {
        debug_assert!(false, "what is resolved without errors is legal: {faults:#?}");
    }
    named
}

/// Resolves dialects, each for itself; none if there was an error. `diagnostics` holds what was found in reading them.
pub(crate) fn resolve_all(all: &[Loaded], tree: &str, sources: &Sources, diagnostics: &mut Diagnostics) -> Vec<Named> {
    let (mut dialects, mut found) = (Vec::with_capacity(all.len()), Vec::with_capacity(all.len()));
    for loaded in all {
        let mut own = diagnostics.clone();
        dialects.extend(resolve(loaded, sources, &mut own));
        found.push(own);
    }
    *diagnostics = once(found);
    link::check_modules(tree, all.iter().filter_map(|loaded| top(loaded, sources)), diagnostics);
    if dialects.len() == all.len() && !diagnostics.has_errors() { dialects } else { Vec::new() }
}

/// The name of a dialect and its top file, if that could be read.
fn top<'a>(loaded: &'a Loaded, sources: &'a Sources) -> Option<(&'a str, (FileId, &'a Path))> {
    let id = loaded.files.first()?.id;
    Some((&loaded.name, (id, sources.get(id)?.path())))
}

/// Links dialects into a tree of this name; nothing if there is only one, or none. `all` is what they were resolved from.
pub(crate) fn link_all(
    dialects: &[Named],
    all: &[Loaded],
    tree: &str,
    diagnostics: &mut Diagnostics,
) -> Result<Option<Union>, Internal> {
    if dialects.len() < 2 {
        return Ok(None);
    }
    let parts = dialects.iter().zip(all).map(|(Named { dialect, names }, loaded)| {
        let illegal = |faults| Internal::new(format!("what is resolved without errors is legal: {faults:#?}"));
        let files = loaded.files.iter().map(|file| file.id);
        let sources = files.chain(loaded.overlays.iter().map(|overlay| overlay.id)).collect_vec();
        Ok(Part { dialect: dialect.validate().map_err(illegal)?, names: names.clone(), sources })
    });
    let mut found = Diagnostics::default();
    let union = link::link(tree, parts.try_collect_vec()?, &mut found)?;
    found.arrange();
    diagnostics.extend(found.iter().cloned());
    Ok(Some(union))
}

/// The diagnostics of several dialects, without those that are there already: they find the same in the files they share.
fn once(found: Vec<Diagnostics>) -> Diagnostics {
    let mut found = found.into_iter();
    let (mut once, others) = (found.next().unwrap_or_default(), found);
    for other in others {
        let known: HashSet<_> = once.iter().map(|one| (one.code, one.span, one.message.clone())).collect();
        once.extend(other.iter().filter(|one| !known.contains(&(one.code, one.span, one.message.clone()))).cloned());
    }
    once
}

/// Every path of several dialects, once.
pub(crate) fn watched(all: Vec<Loaded>) -> Vec<PathBuf> {
    let (mut watched, mut seen) = (Vec::new(), HashSet::new());
    for loaded in all {
        watched.extend(loaded.watched.into_iter().filter(|path| seen.insert(path.clone())));
    }
    watched
}
