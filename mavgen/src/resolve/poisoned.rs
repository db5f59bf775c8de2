//! What reading lost, and who would otherwise miss it a second time.

use crate::diag::Diagnostics;
use crate::source::{FileId, Span};

/// The files of which something could not be read.
pub(super) struct Poisoned {
    files: Vec<Option<FileId>>,
}

impl Poisoned {
    /// The poisoned behind the errors so far.
    pub(super) fn behind(diagnostics: &Diagnostics) -> Self {
        Self { files: diagnostics.broken_files().to_vec() }
    }

    /// A file whose definitions are not taken in.
    pub(super) fn add(&mut self, file: FileId) {
        self.files.push(Some(file));
    }

    /// Whether anything was lost: a name without a definition may then be no mistake.
    pub(super) fn any(&self) -> bool {
        !self.files.is_empty()
    }

    /// Whether anything was lost of the file of `place`: what looks empty there may not be.
    pub(super) fn near(&self, place: Span) -> bool {
        self.files.contains(&Some(place.file))
    }
}
