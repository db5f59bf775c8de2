//! A random dialect, and what mavgen makes of it.

use std::fs;
use std::path::{Path, PathBuf};

use mavgen::{Builder, Failure, GeneratedFile, Resolved};
use random_dialects::Case;

/// A case and what became of it.
pub(crate) struct Sample {
    pub(crate) case: Case,
    pub(crate) fate: Fate,
}

/// What mavgen says to a case.
pub(crate) enum Fate {
    Accepted(Box<Accepted>),
    Refused,
}

/// What is generated, and from which model.
pub(crate) struct Accepted {
    pub(crate) files: Vec<GeneratedFile>,
    pub(crate) resolved: Resolved,
}

impl Sample {
    /// Asks mavgen.
    ///
    /// # Panics
    ///
    /// If it fails otherwise than by diagnostics.
    pub(crate) fn of(case: Case) -> Self {
        let folder = tempfile::tempdir().unwrap();
        write(folder.path(), &case);
        let builder = builder(folder.path(), &case);
        let fate = match builder.resolve() {
            Ok(resolved) => Fate::Accepted(Box::new(Accepted { files: builder.emit(&resolved).unwrap(), resolved })),
            Err(Failure::Definitions(_)) => Fate::Refused,
            Err(failure) => panic!("seed {}: {failure}", case.seed),
        };
        Self { case, fate }
    }

    /// What was generated, if it was.
    pub(crate) fn accepted(&self) -> Option<&Accepted> {
        match &self.fate {
            Fate::Accepted(accepted) => Some(accepted),
            Fate::Refused => None,
        }
    }
}

/// Writes the files of a case into a folder.
pub(crate) fn write(folder: &Path, case: &Case) {
    for (name, text) in &case.files {
        fs::write(folder.join(name), text).unwrap();
    }
}

fn builder(folder: &Path, case: &Case) -> Builder {
    let paths = |names: &[String]| -> Vec<PathBuf> { names.iter().map(|name| folder.join(name)).collect() };
    let (roots, overlays) = (paths(&case.roots), paths(&case.overlays));
    let (first, others) = roots.split_first().unwrap();
    let builder = others.iter().fold(Builder::new(first), Builder::root);
    overlays.iter().fold(builder, Builder::overlay)
}
