//! What all items are made of.

use super::link::{Placement, Union};
use super::names::Names;
use crate::internal::Internal;
use crate::ir::{Dialect, FileIndex, Lifecycle, Origin, Valid};

/// What the items of a dialect are made of.
#[derive(Clone, Copy)]
pub(crate) struct Items<'d> {
    /// All that is generated, of however many dialects.
    pub(super) dialect: &'d Dialect,
    /// What everything in it is called.
    pub(super) names: &'d Names,
    /// The dialects, if there are several.
    pub(super) union: Option<&'d Union>,
    /// The folder of the file that is being made.
    pub(super) placement: Placement,
    /// Whether `<deprecated>` becomes `#[deprecated]`.
    pub(super) deprecated: bool,
}

impl<'d> Items<'d> {
    /// Those of one dialect.
    pub(crate) fn of(valid: Valid<'d>, names: &'d Names, deprecated: bool) -> Self {
        Self { dialect: valid.dialect(), names, union: None, placement: Placement::Shared, deprecated }
    }

    /// Those of several, which were legal when they were linked.
    pub(super) fn of_several(union: &'d Union, deprecated: bool) -> Self {
        let Union { all, names, .. } = union;
        Self { dialect: all, names, union: Some(union), placement: Placement::Shared, deprecated }
    }

    /// The name of a file.
    pub(crate) fn file_name(self, index: FileIndex) -> Result<&'d str, Internal> {
        let file = self.dialect.file(index).map(|file| file.name.as_str());
        file.ok_or_else(|| Internal::new(format!("there is no file {}", index.0)))
    }

    /// Whether naming the item makes the compiler warn.
    pub(crate) fn is_deprecated(&self, origin: &Origin) -> bool {
        self.deprecated && matches!(origin.lifecycle, Some(Lifecycle::Deprecated(_)))
    }
}
