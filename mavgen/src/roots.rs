//! Several dialects at once: each is resolved for itself, then they are united.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

use crate::diag::Diagnostics;
use crate::ir::{Dialect, Union};
use crate::names::{dialect_module_name, root_module_name};
use crate::read::Loaded;
use crate::resolve::resolve;
use crate::source::Sources;
use crate::unite::{Part, unite};

/// What a tree with several dialects is called unless it is given a name.
pub(crate) const TREE: &str = "dialects";

/// Why these files cannot be the dialects of one tree of this name, if they cannot.
pub(crate) fn conflict(roots: &[PathBuf], tree: &str) -> Option<String> {
    if roots.len() > 1 && syn::parse_str::<syn::Ident>(&dialect_module_name(tree)).is_err() {
        return Some(format!("`{tree}` makes no Rust name for a module: use letters and digits"));
    }
    let mut modules: HashMap<String, &Path> = HashMap::new();
    for root in roots {
        let name = root.file_stem().unwrap_or_default().to_string_lossy();
        let module = root_module_name(&name, tree);
        let Some(first) = modules.insert(module.clone(), root) else { continue };
        let same =
            first == root || first.canonicalize().ok().is_some_and(|path| root.canonicalize().ok() == Some(path));
        let (first, second) = (first.display(), root.display());
        return Some(if same {
            format!("`{second}` is given twice: name each dialect once")
        } else {
            format!("`{first}` and `{second}` would both be the module `{module}`: rename one of them")
        });
    }
    None
}

/// Resolves dialects, each for itself; none if there was an error. `diagnostics` holds what was found in reading them.
pub(crate) fn resolve_all(all: &[Loaded], sources: &Sources, diagnostics: &mut Diagnostics) -> Vec<Dialect> {
    let (mut dialects, mut found) = (Vec::with_capacity(all.len()), Vec::with_capacity(all.len()));
    for loaded in all {
        let mut own = diagnostics.clone();
        dialects.extend(resolve(loaded, sources, &mut own));
        found.push(own);
    }
    *diagnostics = once(found);
    if dialects.len() == all.len() { dialects } else { Vec::new() }
}

/// Unites dialects into a tree of this name; nothing if there is only one, or none. `all` is what they were resolved from.
pub(crate) fn unite_all(
    dialects: &[Dialect],
    all: &[Loaded],
    tree: &str,
    diagnostics: &mut Diagnostics,
) -> Option<Union> {
    if dialects.len() < 2 {
        return None;
    }
    let parts = dialects.iter().zip(all).map(|(dialect, loaded)| {
        let files = loaded.files.iter().map(|file| file.id);
        let sources = files.chain(loaded.overlays.iter().map(|overlay| overlay.id)).collect();
        Part { dialect: dialect.clone(), sources }
    });
    let mut found = Diagnostics::default();
    let union = unite(tree, parts.collect(), &mut found);
    found.arrange();
    diagnostics.extend(found.iter().cloned());
    Some(union)
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
    let mut seen = HashSet::new();
    all.into_iter().flat_map(|loaded| loaded.watched).filter(|path| seen.insert(path.clone())).collect()
}
