//! What every item says of itself.

use super::{lifecycle, text};
use crate::diag::Diagnostics;
use crate::ir::{FileIndex, Origin};
use crate::source::Span;
use crate::syntax::{Lifecycle, Text};

/// The parts of an element that become its origin.
pub(super) struct Described<'a> {
    /// The file it stands in.
    pub(super) file: FileIndex,
    /// Its start tag.
    pub(super) span: Span,
    /// Its text.
    pub(super) description: Option<&'a Text>,
    /// Its stage of life.
    pub(super) lifecycle: Option<&'a Lifecycle>,
}

impl Described<'_> {
    /// The origin.
    pub(super) fn origin(self, diagnostics: &mut Diagnostics) -> Origin {
        let lifecycle = self.lifecycle.map(|element| lifecycle::resolve(element, diagnostics));
        Origin {
            file: self.file,
            overlays: Vec::new(),
            span: self.span,
            description: text::or_empty(self.description),
            lifecycle,
        }
    }
}
