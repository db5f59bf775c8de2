//! Mistakes of mavgen's own, which no input can cause.

use std::fmt;

/// A mistake of mavgen's own: a model that says something impossible, or items that are no Rust.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Internal(String);

impl Internal {
    /// Says what is wrong; at once, where mavgen is tested.
    pub(crate) fn new(what: impl Into<String>) -> Self {
        let what = what.into();
        debug_assert!(false, "{what}");
        Self(what)
    }
}

impl fmt::Display for Internal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
