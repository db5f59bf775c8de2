//! Where a build script runs, and what its other builders have written there.

use std::borrow::Cow;
use std::env;
use std::path::{Path, PathBuf, absolute};
use std::sync::{Mutex, PoisonError};

/// Where a build script runs.
pub(super) struct Place<'b> {
    /// The folder of what it makes; `None` outside of a build script.
    pub(super) out_dir: Option<PathBuf>,
    /// What was written there before.
    pub(super) builders: &'b Builders,
    /// Whether a relative path means to cargo what it means here.
    is_in_package: bool,
}

/// The builders of one process.
#[derive(Default)]
pub(super) struct Builders(Mutex<Vec<Claim>>);

/// What a builder writes.
#[derive(Clone)]
pub(super) struct Claim {
    /// The dialect that it is for.
    pub(super) root: PathBuf,
    /// The module that the crate takes in.
    pub(super) module: String,
    /// The folder that is its alone.
    pub(super) tree: PathBuf,
}

impl Place<'static> {
    /// Where this process runs.
    pub(super) fn of_process() -> Self {
        static BUILDERS: Builders = Builders(Mutex::new(Vec::new()));
        // Cargo starts a build script in the folder of its package, which is where it looks for relative paths; the script may
        // have gone elsewhere since.
        let package = env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
        let is_in_package = package.is_none_or(|package| env::current_dir().is_ok_and(|here| here == package));
        Self { out_dir: env::var_os("OUT_DIR").map(PathBuf::from), builders: &BUILDERS, is_in_package }
    }
}

impl<'b> Place<'b> {
    /// A place of a test's own.
    #[cfg(test)]
    pub(super) fn new(out_dir: &Path, builders: &'b Builders, is_in_package: bool) -> Self {
        Self { out_dir: Some(out_dir.to_owned()), builders, is_in_package }
    }

    /// A path as cargo understands it.
    pub(super) fn for_cargo<'p>(&self, path: &'p Path) -> Cow<'p, Path> {
        let elsewhere = if self.is_in_package { None } else { absolute(path).ok() };
        elsewhere.map_or(Cow::Borrowed(path), Cow::Owned)
    }
}

impl Builders {
    /// Lets a builder write, or says which other has written there already: each would remove what the other made.
    pub(super) fn claim(&self, new: Claim) -> Result<(), String> {
        let mut claims = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        for other in &*claims {
            let both = format!("the builders of `{}` and of `{}`", other.root.display(), new.root.display());
            if other.module == new.module {
                let module = new.module;
                return Err(format!("{both} make one module, `{module}`: name one of them with Builder::name"));
            }
            if overlap(&other.tree, &new.tree) {
                let tree = new.tree.display();
                return Err(format!("{both} write into one folder, `{tree}`: give each its own Builder::out_dir"));
            }
        }
        claims.push(new);
        Ok(())
    }
}

/// Whether one of two folders is the other, or lies in it.
fn overlap(a: &Path, b: &Path) -> bool {
    let (a, b) = (canonical(a), canonical(b));
    a.starts_with(&b) || b.starts_with(&a)
}

/// A path without links, as far as it is there.
fn canonical(path: &Path) -> PathBuf {
    let path = absolute(path).unwrap_or_else(|_| path.to_owned());
    let whole = |folder: &Path| Some(folder.canonicalize().ok()?.join(path.strip_prefix(folder).ok()?));
    path.ancestors().find_map(whole).unwrap_or_else(|| path.clone())
}
