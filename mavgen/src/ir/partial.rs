//! What is left of a dialect that has errors.

use super::{Dialect, FileIndex, Name};

/// What could be resolved of a dialect, and the names of what could not: those are worth checking all the same, so that one run
/// finds all that is wrong.
#[derive(Clone, Debug)]
pub struct Partial {
    /// What could be resolved. Without an error it is legal; with one, ids and names may stand there twice.
    pub dialect: Dialect,
    /// The messages that are not in it.
    pub lost: Vec<LostMessage>,
    /// The types of views that are not in it.
    pub lost_views: Vec<LostView>,
}

/// A message that could not be resolved.
#[derive(Clone, Debug)]
pub struct LostMessage {
    /// Its name.
    pub name: Name,
    /// The file.
    pub file: FileIndex,
    /// The names of its fields, in the order of the XML.
    pub fields: Vec<Name>,
}

/// A view that could not be resolved, or its slot.
#[derive(Clone, Debug)]
pub struct LostView {
    /// The name of its type.
    pub name: Name,
    /// The overlay.
    pub file: FileIndex,
}
